// Ranges of consecutive numbers. A participant computes what touches its interface before the rest
// (participant.hpp); both are lists of ranges, so that the loops over them stay contiguous.
#pragma once

#include <cstdint>
#include <vector>

namespace adit::protocol {

// The numbers begin … end - 1.
struct IndexRange {
  std::uint32_t begin, end;
};

// Cuts 0 … count - 1 where test(k) changes: visit(range, outcome) for each piece in turn.
template <class Test, class Visit>
void for_each_range(std::uint32_t count, Test&& test, Visit&& visit) {
  for (std::uint32_t begin = 0; begin < count;) {
    const bool outcome = test(begin);
    std::uint32_t end = begin + 1;
    while (end < count && test(end) == outcome) ++end;
    visit(IndexRange{begin, end}, outcome);
    begin = end;
  }
}

// The ranges of the numbers whose flag has this value.
inline std::vector<IndexRange> index_ranges(const std::vector<bool>& flags, bool value) {
  std::vector<IndexRange> found;
  for_each_range(
      static_cast<std::uint32_t>(flags.size()), [&](std::uint32_t k) { return flags[k]; },
      [&](const IndexRange& range, bool flag) {
        if (flag == value) found.push_back(range);
      });
  return found;
}

}  // namespace adit::protocol
