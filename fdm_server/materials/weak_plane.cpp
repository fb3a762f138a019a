#include "fdm_server/materials/weak_plane.hpp"

#include <algorithm>

namespace adit::fdm {

WeakPlane::WeakPlane(double dip_angle, const Strength& s)
    : strength_{s.cohesion, std::tan(s.friction_angle), std::tan(s.dilation_angle),
                std::min(s.tension, apex(s.cohesion, s.friction_angle))},
      direction_{std::cos(2 * dip_angle), std::sin(2 * dip_angle)} {}

WeakPlane::Return WeakPlane::admissible(const Elasticity& elasticity, const SolidStress& predicted,
                                        const PlaneDirection& direction) const {
  const auto [stress, yields] = to_plane(elasticity, strength_, direction, point_stress(predicted));
  if (yields == kElastic) return {predicted, kElastic};
  return {solid_stress(stress), static_cast<unsigned>(yields)};
}

}  // namespace adit::fdm
