#include "fdm_server/participant/demand_figures.hpp"

#include <algorithm>

#include "fdm_server/participant/figures.hpp"

namespace adit::fdm {

void add_largest_demand(const Grid& grid, const Peaks& peaks, wire::Bye& bye) {
  const auto largest = std::ranges::max_element(peaks.demand());
  if (largest == peaks.demand().end()) return;
  const auto zone = static_cast<std::size_t>(largest - peaks.demand().begin());
  const auto [x, y] = centroid(corners(grid, zone));
  add_figure("largest_demand", *largest, bye);
  add_figure("largest_demand_time_s", peaks.demand_time()[zone], bye);
  add_figure("largest_demand_x_m", x, bye);
  add_figure("largest_demand_y_m", y, bye);
}

}  // namespace adit::fdm
