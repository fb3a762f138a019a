// The ubiquitous weak plane: slip by Coulomb and opening across planes of one direction, after the law of the
// ground between them. With the traction on the plane, normal s_n and shear tau,
//   slip     |tau| + s_n tan phi - c <= 0,   flow (|gamma|, e_n) = l (1, tan psi),
//   opening  s_n - t <= 0,                   flow e_n,
// and the elastic predictor goes back by Koiter's rule, as in mohr_coulomb.hpp; e_n takes lame() from the
// stress along and across, lame() + 2G from s_n. Without branches, for loops over many points.
#pragma once

#include <cmath>
#include <cstdint>

#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

struct PlaneStrength {
  double cohesion, tan_friction, tan_dilation, tension;
};

// Of so many times the cohesion and tension.
[[gnu::always_inline]] inline PlaneStrength times(double factor, const PlaneStrength& plane) {
  return {factor * plane.cohesion, plane.tan_friction, plane.tan_dilation, factor * plane.tension};
}

// The planes' direction as the cosine and sine of twice its angle from x, counter-clockwise.
struct PlaneDirection {
  double cosine, sine;
};

[[gnu::always_inline]] inline PlaneDirection turned(const PlaneDirection& d, double cosine, double sine) {
  return {cosine * d.cosine - sine * d.sine, sine * d.cosine + cosine * d.sine};
}

struct PlaneReturn {
  PointStress stress;
  std::int64_t yields;  // kSlipNow, kOpeningNow
};

// The traction's normal part and shear.
struct Traction {
  double normal, shear;
};
[[gnu::always_inline]] inline Traction traction(const PlaneDirection& to, const PointStress& s) {
  return {s.mean - (to.cosine * s.difference + to.sine * s.shear),
          to.cosine * s.shear - to.sine * s.difference};
}

[[gnu::always_inline]] inline PlaneReturn to_plane(const Elasticity& e, const PlaneStrength& plane,
                                                   const PlaneDirection& direction, const PointStress& from) {
  const auto [normal, shear] = traction(direction, from);
  const double size = std::abs(shear), across = e.lame() + 2 * e.shear;
  const double slip = size + normal * plane.tan_friction - plane.cohesion, opening = normal - plane.tension;
  const double alone = slip * (1 / (e.shear + across * plane.tan_friction * plane.tan_dilation));
  const bool slips = slip > 0,
             opens = (slips & (normal - across * (alone * plane.tan_dilation) > plane.tension)) |
                     (!slips & (opening > 0));
  // Opening, with slip where the shear stress is then too large.
  const double left = (size + plane.tension * plane.tan_friction - plane.cohesion) * (1 / e.shear);
  const double gamma = opens ? (left > 0 ? left : 0) : slips ? alone : 0;
  const double strain = opens ? opening * (1 / across) : slips ? alone * plane.tan_dilation : 0;
  const double shear_lost = std::copysign(e.shear * gamma, shear), difference_lost = -e.shear * strain;
  return {{from.mean - (e.lame() + e.shear) * strain,
           from.difference - (direction.cosine * difference_lost - direction.sine * shear_lost),
           from.shear - (direction.sine * difference_lost + direction.cosine * shear_lost),
           from.across - e.lame() * strain},
          (opens ? std::int64_t{kOpeningNow} : 0) | (gamma > 0 ? std::int64_t{kSlipNow} : 0)};
}

class WeakPlane {
 public:
  // `dip_angle`: of the trace, from x counter-clockwise [rad].
  WeakPlane(double dip_angle, const Strength& strength);

  struct Return {
    SolidStress stress;
    unsigned yields;  // kSlipNow, kOpeningNow
  };
  Return admissible(const Elasticity& elasticity, const SolidStress& predicted,
                    const PlaneDirection& direction) const;
  Return admissible(const Elasticity& elasticity, const SolidStress& predicted) const {
    return admissible(elasticity, predicted, direction_);
  }

  const PlaneStrength& strength() const { return strength_; }
  const PlaneDirection& direction() const { return direction_; }  // before the ground turns

 private:
  PlaneStrength strength_;
  PlaneDirection direction_;
};

}  // namespace adit::fdm
