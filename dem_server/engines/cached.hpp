// Models of so few particles stay about in the cache of one core. What steps of larger ones read is asked for
// beforehand.
#pragma once

#include <cstddef>

namespace adit::dem {

inline constexpr std::size_t kCached = 16384;

}  // namespace adit::dem
