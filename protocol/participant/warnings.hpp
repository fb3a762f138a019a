// Notes of a participant that say what of its model is likely to be wrong.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// A note (wire::Model) that begins so is a warning: a coupler tells it as one, without these words.
inline constexpr std::string_view kWarning = "warning: ";

inline std::string as_warning(const std::string& note) {
  return std::string(kWarning) + note;
}

}  // namespace adit::protocol
