#include "dem_server/discs/extent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::dem {

Rectangle extent_of(const Discs& d) {
  Rectangle box{d.x[0], d.x[0], d.y[0], d.y[0]};
  for (std::size_t i = 0; i < d.size(); ++i) {
    box.x_min = std::min(box.x_min, d.x[i] - d.radius[i]);
    box.x_max = std::max(box.x_max, d.x[i] + d.radius[i]);
    box.y_min = std::min(box.y_min, d.y[i] - d.radius[i]);
    box.y_max = std::max(box.y_max, d.y[i] + d.radius[i]);
  }
  return box;
}

void refuse_coincident(const Discs& d) {
  std::vector<std::uint32_t> order(d.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(d.x[i], d.y[i], i); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::uint32_t i = order[k - 1], j = order[k];
    if (d.x[i] == d.x[j] && d.y[i] == d.y[j])
      throw protocol::UserError(
          "particles",
          fmt::format("hold two with the same centre, ({:.9g}, {:.9g}) m: numbers {} and {}, counted from "
                      "0; no direction leads from one to the other, move one of them",
                      d.x[i], d.y[i], i, j));
  }
}

}  // namespace adit::dem
