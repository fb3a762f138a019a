#include "fdm_server/participant/dowel_figures.hpp"

#include <algorithm>
#include <string>

#include "fdm_server/participant/figures.hpp"

namespace adit::fdm {

void add_figures(const Grid& grid, std::span<const Lining> linings, const PeakDowels& peaks, wire::Bye& bye) {
  if (peaks.forces().empty()) return;
  Figures figures(grid, bye);
  for (const Lining& ring : linings) {
    if (ring.dowels.empty()) continue;
    const auto add = [&](const std::vector<PeakDowels::Instant>& all, double unit, const std::string& name,
                         const std::string& unit_name) {
      const auto of_ring = std::span(all).subspan(ring.first_dowel, ring.dowels.size());
      const auto largest = std::ranges::max_element(of_ring, {}, &PeakDowels::Instant::size);
      const auto node = ring.dowels[static_cast<std::size_t>(largest - of_ring.begin())];
      figures.add(name + unit_name, unit * largest->size);
      figures.add_when_and_where(name, largest->time, ring.path.points[node]);
    };
    const std::string name = "lining_" + ring.name + "_largest_";
    add(peaks.forces(), ring.ring_width, name + "dowel_force", "_N");
    add(peaks.offsets(), 1, name + "ring_offset", "_m");
  }
}

}  // namespace adit::fdm
