#include "fdm_server/materials/weak_plane.hpp"

#include <algorithm>

namespace adit::fdm {

WeakPlane::WeakPlane(double dip_angle, const Strength& s)
    : dip_angle_(dip_angle),
      cosine_(std::cos(dip_angle)),
      sine_(std::sin(dip_angle)),
      cohesion_(s.cohesion),
      tan_friction_(std::tan(s.friction_angle)),
      tan_dilation_(std::tan(s.dilation_angle)),
      tension_(std::min(s.tension, apex(s.cohesion, s.friction_angle))) {}

WeakPlane::Return WeakPlane::admissible(const Elasticity& elasticity, const SolidStress& predicted,
                                        double turn) const {
  const double cosine = turn == 0 ? cosine_ : std::cos(dip_angle_ + turn);
  const double sine = turn == 0 ? sine_ : std::sin(dip_angle_ + turn);
  const SolidStress local = turned(predicted, cosine, -sine);  // x along the plane, y across it
  const double slip = std::abs(local.xy) + local.yy * tan_friction_ - cohesion_;
  const double opening = local.yy - tension_;
  if (slip <= 0 && opening <= 0) return {predicted, kElastic};

  const double lame = elasticity.lame(), shear = elasticity.shear, across = lame + 2 * shear;
  double gamma = slip / (shear + across * tan_friction_ * tan_dilation_);  // slip alone
  double strain = gamma * tan_dilation_;
  unsigned yields = kSlipNow;
  if (slip <= 0 || local.yy - across * strain > tension_) {
    strain = opening / across;  // opening, with slip where the shear stress is then too large
    gamma = std::max(0.0, (std::abs(local.xy) + tension_ * tan_friction_ - cohesion_) / shear);
    yields = gamma > 0 ? kSlipNow | kOpeningNow : kOpeningNow;
  }
  const SolidStress back{local.xx - lame * strain, local.yy - across * strain, local.zz - lame * strain,
                         local.xy - std::copysign(shear * gamma, local.xy)};
  return {turned(back, cosine, sine), yields};
}

}  // namespace adit::fdm
