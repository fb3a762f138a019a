// Values that will be read and written soon, asked for so that they are in the cache by then: a processor
// does not follow as many lists by itself as a step reads.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

#include "protocol/threads/index_ranges.hpp"

namespace adit::protocol {

inline constexpr std::size_t kLine = 64 / sizeof(double);  // of the cache

// Always inlined: GCC takes a function that does no more than this for one without effect, and drops its
// calls.
[[gnu::always_inline]] inline void prefetch(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); i += kLine) __builtin_prefetch(values.data() + i, 1);
}

[[gnu::always_inline]] inline void prefetch(std::span<const IndexRange> ranges,
                                            std::initializer_list<const double*> lists) {
  for (const auto [begin, end] : ranges)
    for (const double* list : lists) prefetch({list + begin, list + end});
}

// For values that lie in one piece, of which there is more than a processor can have asked for at once: it
// follows a list that is read in its order far ahead, but not what is only asked for.
inline void read_ahead(std::span<const double> values) {
  const volatile double* read = values.data();
  for (std::size_t i = 0; i < values.size(); i += kLine) [[maybe_unused]] const double value = read[i];
}

}  // namespace adit::protocol
