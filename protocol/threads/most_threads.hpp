#pragma once

#include <cstddef>

namespace adit::protocol {

// More are a mistake on any machine of today.
inline constexpr std::size_t kMostThreads = 1024;

}  // namespace adit::protocol
