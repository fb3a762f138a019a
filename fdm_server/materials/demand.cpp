#include "fdm_server/materials/demand.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {
namespace {

// Where there is no strength, any load is all that it bears.
double share(double load, double strength) {
  if (!(load > 0)) return 0;
  return strength > 0 ? load / strength : 1;
}

// A shear stress beside a normal one whose friction adds to the strength or, in tension, to the load.
double shear_share(double shear, double normal_friction, double cohesion) {
  return share(shear + std::max(normal_friction, 0.0), cohesion - std::min(normal_friction, 0.0));
}

}  // namespace

double demand(const YieldCone& cone, const PointStress& stress) {
  const double radius = std::sqrt(stress.difference * stress.difference + stress.shear * stress.shear);
  const double largest = std::max(stress.mean + radius, stress.across),
               smallest = std::min(stress.mean - radius, stress.across);
  return std::max(share(largest, cone.tension),
                  shear_share((largest - smallest) / 2, (largest + smallest) / 2 * cone.sin_friction,
                              cone.twice_c_cos / 2));
}

double demand(const PlaneStrength& plane, const PlaneDirection& direction, const PointStress& stress) {
  const auto [normal, shear] = traction(direction, stress);
  return std::max(share(normal, plane.tension),
                  shear_share(std::abs(shear), normal * plane.tan_friction, plane.cohesion));
}

}  // namespace adit::fdm
