// Mean small strain of a zone under the displacement since time began.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"

namespace adit::fdm {

struct MeanStrain {
  double xx, yy, xy;  // xy: the engineering shear strain, twice the tensor's component
};

inline MeanStrain mean_strain(const MeanGradient& g, const ZonePoints& zone, std::span<const double> ux,
                              std::span<const double> uy) {
  const double x02 = ux[zone[0]] - ux[zone[2]], x13 = ux[zone[1]] - ux[zone[3]];
  const double y02 = uy[zone[0]] - uy[zone[2]], y13 = uy[zone[1]] - uy[zone[3]];
  return {g.x0 * x02 + g.x1 * x13, g.y0 * y02 + g.y1 * y13,
          (g.y0 * x02 + g.y1 * x13) + (g.x0 * y02 + g.x1 * y13)};
}

}  // namespace adit::fdm
