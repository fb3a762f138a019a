// The user's text: trimmed for reading, and made fit for a one-line message.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// Without blanks and tabs at both ends.
std::string_view trim(std::string_view text);

// On one line and at most 60 bytes long: control characters become spaces, the rest is cut with `...`.
std::string shorten(std::string_view text);

// `text`, shortened, between backticks.
std::string quote(std::string_view text);

}  // namespace adit::protocol
