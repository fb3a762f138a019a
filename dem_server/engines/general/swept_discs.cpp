#include "dem_server/engines/general/swept_discs.hpp"

#include <algorithm>

#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::dem {

SweptDiscs::SweptDiscs(const std::vector<bool>& keep) : kept(blocks_of(keep.size())) {
  for (const bool keeps : keep) swept.push_back(keeps ? 0 : 1);
  for (std::uint32_t b = 0; b < kept.size(); ++b) {
    const std::uint32_t first = b * kBlock;
    protocol::for_each_range(
        static_cast<std::uint32_t>(std::min<std::size_t>(kBlock, keep.size() - first)),
        [&](std::uint32_t k) { return keep[first + k]; },
        [&](const protocol::IndexRange& range, bool keeps) {
          if (keeps) kept[b].push_back({first + range.begin, first + range.end});
        });
  }
}

}  // namespace adit::dem
