#include "fdm_server/zones/kernel/zone_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {
namespace {

// Equal up to a translation and to the rounding of the coordinates.
bool same_shape(const Corners& a, const Corners& b) {
  double largest = 0, difference = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    largest = std::max({largest, std::abs(a.x[c]), std::abs(a.y[c]), std::abs(b.x[c]), std::abs(b.y[c])});
    difference = std::max({difference, std::abs((a.x[c] - a.x[0]) - (b.x[c] - b.x[0])),
                           std::abs((a.y[c] - a.y[0]) - (b.y[c] - b.y[0]))});
  }
  return difference <= 8 * std::numeric_limits<double>::epsilon() * largest;
}

bool continues(const ZoneRun& run, const ZonePoints& zone) {
  for (std::size_t c = 0; c < 4; ++c)
    if (zone[c] != run.points[c] + static_cast<std::int32_t>(run.count)) return false;
  return true;
}

ZoneRun piece(ZoneRun run, const protocol::IndexRange& range) {
  run.first += range.begin;
  run.count = range.end - range.begin;
  for (auto& point : run.points) point += static_cast<std::int32_t>(range.begin);
  return run;
}

}  // namespace

ZoneLayout lay_out(const Grid& grid) {
  ZoneLayout layout;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto here = corners(grid, z);
    const bool same = !layout.shapes.empty() && same_shape(layout.shapes.back(), here);
    if (!same) layout.shapes.push_back(here);
    if (same && continues(layout.runs.back(), grid.zones[z]))
      ++layout.runs.back().count;
    else
      layout.runs.push_back({static_cast<std::uint32_t>(z), 1,
                             static_cast<std::uint32_t>(layout.shapes.size() - 1), grid.zones[z]});
  }
  return layout;
}

SplitRuns split(std::span<const ZoneRun> runs, const std::vector<bool>& chosen) {
  SplitRuns parts;
  for (const ZoneRun& run : runs)
    protocol::for_each_range(
        run.count,
        [&](std::uint32_t k) {
          return std::ranges::any_of(run.points, [&](auto point) { return chosen[point + k]; });
        },
        [&](const protocol::IndexRange& range, bool touches) {
          (touches ? parts.touching : parts.others).push_back(piece(run, range));
        });
  return parts;
}

std::vector<ZoneRun> without(std::span<const ZoneRun> runs, const std::vector<bool>& zones) {
  std::vector<ZoneRun> left;
  for (const ZoneRun& run : runs)
    protocol::for_each_range(
        run.count, [&](std::uint32_t k) { return !zones[run.first + k]; },
        [&](const protocol::IndexRange& range, bool stays) {
          if (stays) left.push_back(piece(run, range));
        });
  return left;
}

}  // namespace adit::fdm
