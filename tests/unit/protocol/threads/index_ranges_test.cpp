#include "protocol/threads/index_ranges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace adit::protocol::index_ranges_test {
namespace {

// The ranges of either value name every number once, in order, and none is longer than need be.
RC_GTEST_PROP(IndexRanges, PartitionTheNumbers, (const std::vector<bool>& flags)) {
  std::vector<int> named(flags.size(), 0);
  for (const bool value : {true, false}) {
    std::uint32_t last_end = 0;
    bool first = true;
    for (const auto [begin, end] : index_ranges(flags, value)) {
      RC_ASSERT(begin < end);
      RC_ASSERT(first || begin > last_end);  // neighbours would be one range
      for (std::uint32_t k = begin; k < end; ++k) {
        RC_ASSERT(flags[k] == value);
        ++named[k];
      }
      last_end = end;
      first = false;
    }
  }
  for (const int times : named) RC_ASSERT(times == 1);
}

}  // namespace
}  // namespace adit::protocol::index_ranges_test
