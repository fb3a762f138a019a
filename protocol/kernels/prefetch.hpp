// Values that will be read and written soon, asked for so that they are in the cache by then: a processor
// does not follow as many lists by itself as a step reads.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

#include "protocol/threads/index_ranges.hpp"

namespace adit::protocol {

// Always inlined: GCC takes a function that does no more than this for one without effect, and drops its
// calls.
[[gnu::always_inline]] inline void prefetch(std::span<const double> values) {
  constexpr std::size_t kLine = 64 / sizeof(double);
  for (std::size_t i = 0; i < values.size(); i += kLine) __builtin_prefetch(values.data() + i, 1);
}

[[gnu::always_inline]] inline void prefetch(std::span<const IndexRange> ranges,
                                            std::initializer_list<const double*> lists) {
  for (const auto [begin, end] : ranges)
    for (const double* list : lists) prefetch({list + begin, list + end});
}

}  // namespace adit::protocol
