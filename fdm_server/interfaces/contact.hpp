// What two faces that touch do to each other, per area of the face (Goodman, Taylor and Brekke 1968, J. Soil
// Mech. Found. Div. 94; friction as Coulomb's).
//
// u is the motion of the first face against the second along the normal, which points from the second to the
// first, and s that along the tangent, to the right of the normal. With tension positive
//   sigma = k_n (u - d),   tau += k_s ds,   |tau| <= c - sigma tan(phi)
// where d is what dilation has opened. A trial beyond the strength returns to it by the slip
//   l = (|tau| - c + sigma tan(phi)) / (k_s + k_n tan(phi) tan(psi)),   d += l tan(psi),   tau -= k_s l,
// since the pressure grows by k_n l tan(psi). A trial beyond the tensile strength parts the faces: they bear
// nothing until u <= d again. Strength falls from its peak to what is left in proportion to slip and
// gap; tension is lost where the faces part.
//
// A stroke is a straight motion (du, ds). Its mean stresses are those that do the work of the law along it,
// also where the faces meet, part or begin to slide on the way: with e the elastic part of the way w,
//   meeting:  sigma^2/2k_n / du,   parting:  (T^2 - sigma^2)/2k_n / du,
//   sliding:  ((tau+^2 - tau-^2)/2k_s + tau+ l)/ds,
// the last over the share of the way in which they touch. So they depend continuously on the end of the
// stroke, but for faces that dilate, which press on each other as soon as they touch. They have the slopes
// k/2 (1 - (1 - e/w)^2), -(mean)/du where that resists, and k/2 (e/w)^2 + (1 - e/w) dtau+/ds against the end
// of the stroke; faces that rest have k/2. So a stroke of any length makes no energy (a discrete gradient;
// Gonzalez 1996, J. Nonlinear Sci. 6).
#pragma once

#include <algorithm>
#include <cmath>

namespace adit::fdm {

struct ContactStrength {
  double cohesion;      // [Pa]
  double tan_friction;  // tan(phi)
  double tan_dilation;  // tan(psi)
  double tension;       // [Pa], at most the apex c/tan(phi)
};

struct ContactLaw {
  double normal, shear;  // k_n, k_s [Pa/m]
  ContactStrength peak, residual;
  double residual_slip;  // over which strength falls from one to the other [m]; 0: at once; infinite: never
};

enum class ContactStatus : unsigned char { kStuck, kSliding, kOpen };

struct ContactState {
  double closure = 0;   // u, 0 where the faces touch without pressure [m]
  double dilated = 0;   // d [m]
  double shear = 0;     // tau [Pa]
  double lost = 0;      // share of the strength that is lost, 0 to 1
  bool parted = false;  // once: tension is lost
  ContactStatus status = ContactStatus::kStuck;
};

inline double normal_stress(const ContactLaw& law, const ContactState& state) {
  return state.status == ContactStatus::kOpen ? 0 : law.normal * (state.closure - state.dilated);
}
inline double opening(const ContactState& state) {
  return state.status == ContactStatus::kOpen ? state.closure : state.dilated;
}
inline double strain_energy(const ContactLaw& law, const ContactState& state) {  // [J/m^2]
  const double sigma = normal_stress(law, state);
  return (sigma * sigma / law.normal + state.shear * state.shear / law.shear) / 2;
}

inline ContactStrength strength(const ContactLaw& law, const ContactState& state) {
  const double lost = state.lost;
  const auto between = [lost](double peak, double residual) {
    return lost < 1 ? peak + lost * (residual - peak) : residual;
  };
  return {between(law.peak.cohesion, law.residual.cohesion),
          between(law.peak.tan_friction, law.residual.tan_friction),
          between(law.peak.tan_dilation, law.residual.tan_dilation),
          state.parted ? 0 : between(law.peak.tension, law.residual.tension)};
}

// By a slip or a gap [m].
inline double lost_by(const ContactLaw& law, double way) {
  return law.residual_slip > 0 ? way / law.residual_slip : 1;
}

// Below this way faces have not moved: quotients of smaller ones are not numbers [m].
inline constexpr double kNoWay = 1e-100;

struct Stroke {
  double du, ds;         // [m]
  double normal, shear;  // mean stresses [Pa]
  struct Slopes {
    double by_normal, by_shear;  // against the end of the stroke, along the normal and the tangent [Pa/m]
  };
  Slopes normal_slopes, shear_slopes;  // of the mean stresses
};

// The faces meet or go on touching: they stick or slide by ds.
inline Stroke touch(const ContactLaw& law, const ContactStrength& now, double sigma_before, double du,
                    double ds, ContactState& state) {
  const bool was_open = state.status == ContactStatus::kOpen;
  const double shear_before = state.shear, pressed = law.normal * (state.closure - state.dilated);
  // The share of the way in which they touch, and how it grows with du.
  const bool meet = was_open && du < -kNoWay;
  const double share = meet ? std::min(1.0, pressed / (law.normal * du)) : 1,
               share_by_du = meet ? (1 - share) / du : 0, touching = share * ds;
  const double trial = shear_before + law.shear * touching,
               limit = std::max(0.0, now.cohesion - pressed * now.tan_friction);
  const double limit_by_normal = limit > 0 ? -law.normal * now.tan_friction : 0;
  Stroke stroke{};
  Stroke::Slopes of_sigma{law.normal, 0};
  // Stress beyond the present strength is lost at once.
  if (std::abs(trial) <= limit) {
    const double from = std::clamp(shear_before, -limit, limit), from_by_normal = from == shear_before ? 0
                                                                                  : from > 0
                                                                                      ? limit_by_normal
                                                                                      : -limit_by_normal;
    state.shear = trial;
    state.status = ContactStatus::kStuck;
    stroke.shear = (from + trial) / 2;
    stroke.shear_slopes = {from_by_normal / 2, law.shear / 2};
  } else {
    const double flow = law.shear + law.normal * now.tan_friction * now.tan_dilation,
                 slip = (std::abs(trial) - limit) / flow;
    const Stroke::Slopes of_slip{-limit_by_normal / flow, std::copysign(law.shear / flow, trial)};
    of_sigma = {law.normal * (1 - now.tan_dilation * of_slip.by_normal),
                -law.normal * now.tan_dilation * of_slip.by_shear};
    state.dilated += slip * now.tan_dilation;
    state.shear = std::copysign(std::max(0.0, std::abs(trial) - law.shear * slip), trial);
    state.lost = std::min(1.0, state.lost + lost_by(law, slip));
    state.status = ContactStatus::kSliding;
    const double bound = std::abs(state.shear), from = std::clamp(shear_before, -bound, bound);
    // The elastic part of the way; what lies beyond the strength at first is lost without a way.
    const double elastic = state.shear == from ? 0 : (state.shear - shear_before) / (law.shear * touching);
    const double half = (from - state.shear) / 2, by_way = elastic == 0 ? 0 : half / (law.shear * touching);
    const double at_end = 1 - (from == shear_before ? elastic / 2 : elastic) + by_way;  // a bound moves both
    const double by_slip = -at_end * std::copysign(law.shear, trial);
    stroke.shear = state.shear + half * elastic;
    stroke.shear_slopes = {by_slip * of_slip.by_normal,
                           law.shear * (at_end - by_way * elastic) + by_slip * of_slip.by_shear};
  }
  const auto by_whole_way = [&](Stroke::Slopes& of) {
    of = {of.by_normal + of.by_shear * ds * share_by_du, share * of.by_shear};
  };
  by_whole_way(of_sigma);
  by_whole_way(stroke.shear_slopes);
  stroke.shear_slopes = {share * stroke.shear_slopes.by_normal + share_by_du * stroke.shear,
                         share * stroke.shear_slopes.by_shear};
  stroke.shear *= share;
  const double sigma = normal_stress(law, state);
  if (was_open && law.normal * du < sigma) {  // they meet on the way
    const double elastic = sigma / (law.normal * du);
    stroke.normal = sigma / 2 * elastic;
    stroke.normal_slopes = {elastic * of_sigma.by_normal - law.normal * elastic * elastic / 2,
                            elastic * of_sigma.by_shear};
  } else {
    stroke.normal = ((was_open ? 0 : std::min(sigma_before, now.tension)) + sigma) / 2;
    stroke.normal_slopes = {of_sigma.by_normal / 2, of_sigma.by_shear / 2};
  }
  return stroke;
}

// The faces part: on the way (du, ds) their stress reaches the tensile strength.
inline Stroke part(const ContactLaw& law, const ContactStrength& now, double sigma_before, double du,
                   double ds, ContactState& state) {
  const bool was_open = state.status == ContactStatus::kOpen;
  const double tension = was_open ? 0 : now.tension;
  // As they part, where dilation, which would press them, does not count.
  ContactState parting = state;
  parting.closure = state.dilated + tension / law.normal;
  state.status = ContactStatus::kOpen;
  state.shear = 0;
  state.parted = true;
  state.lost = std::max(state.lost, std::min(1.0, lost_by(law, state.closure - state.dilated)));
  Stroke stroke{};
  // Slip may have left less than the faces bore.
  const double from = std::min(sigma_before, tension), elastic = (tension - from) / law.normal;
  if (was_open || elastic == 0) return stroke;
  stroke.normal = (from + tension) / 2 * elastic / du;
  if (du < kNoWay) return stroke;
  stroke.normal_slopes.by_normal = std::max(0.0, -stroke.normal / du);
  ContactStrength plain = now;
  plain.tan_dilation = 0;
  const double share = elastic / du;  // of the way, in which they touch
  const Stroke touching = touch(law, plain, sigma_before, elastic, share * ds, parting);
  const double by_way = touching.shear_slopes.by_shear;
  stroke.shear = share * touching.shear;
  stroke.shear_slopes = {-share / du * (touching.shear + share * ds * by_way), share * share * by_way};
  state.lost = std::max(state.lost, parting.lost);
  return stroke;
}

// Moves the first face by du and ds [m].
inline Stroke move(const ContactLaw& law, double du, double ds, ContactState& state) {
  const bool was_open = state.status == ContactStatus::kOpen;
  const double sigma_before = normal_stress(law, state);
  const ContactStrength now = strength(law, state);
  const double tension = was_open ? 0 : now.tension;
  state.closure += du;
  Stroke stroke = law.normal * (state.closure - state.dilated) > tension
                      ? part(law, now, sigma_before, du, ds, state)
                      : touch(law, now, sigma_before, du, ds, state);
  stroke.du = du;
  stroke.ds = ds;
  // Where faces that hardly touch part or meet, stresses change steeply with the end of the stroke. Newton's
  // method then takes slopes as they are elsewhere, or its matrix could be singular.
  const double steepest = law.normal + law.shear;
  for (double* slope : {&stroke.normal_slopes.by_normal, &stroke.shear_slopes.by_normal})
    *slope = std::clamp(*slope, -steepest, steepest);
  return stroke;
}

// By a stroke between these states [J/m^2].
inline double dissipated(const ContactLaw& law, const ContactState& before, const Stroke& stroke,
                         const ContactState& after) {
  return stroke.normal * stroke.du + stroke.shear * stroke.ds -
         (strain_energy(law, after) - strain_energy(law, before));
}

}  // namespace adit::fdm
