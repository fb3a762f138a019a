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
// with the slopes k/2 (1 - (1 - e/w)^2), -(mean)/du where that resists, and k/2 (e/w)^2 against the end of
// the stroke; faces that rest have k/2. So a stroke of any length makes no energy (a discrete gradient;
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

struct Stroke {
  double normal, shear;                      // mean stresses [Pa]
  double normal_stiffness, shear_stiffness;  // twice the slopes of these, as shares of k_n and k_s
  double dissipated;                         // [J/m^2]
};

// Moves the first face by du and ds [m].
inline Stroke move(const ContactLaw& law, double du, double ds, ContactState& state) {
  const double sigma_before = normal_stress(law, state), shear_before = state.shear,
               stored_before = strain_energy(law, state);
  const bool was_open = state.status == ContactStatus::kOpen;
  const ContactStrength now = strength(law, state);
  state.closure += du;
  double sigma = law.normal * (state.closure - state.dilated);
  Stroke stroke{};
  if (sigma > (was_open ? 0 : now.tension)) {
    state.status = ContactStatus::kOpen;
    state.shear = 0;
    state.parted = true;
    state.lost = std::max(state.lost, std::min(1.0, lost_by(law, state.closure - state.dilated)));
    // Slip may have left less than the faces bore.
    const double from = std::min(sigma_before, now.tension), elastic = (now.tension - from) / law.normal;
    if (!was_open && elastic > 0) {
      stroke.normal = (from + now.tension) / 2 * elastic / du;
      stroke.normal_stiffness = std::max(0.0, -2 * stroke.normal / (law.normal * du));
    }
  } else {
    const double trial = state.shear + law.shear * ds,
                 limit = std::max(0.0, now.cohesion - sigma * now.tan_friction);
    const double slip = std::max(0.0, std::abs(trial) - limit) /
                        (law.shear + law.normal * now.tan_friction * now.tan_dilation);
    state.dilated += slip * now.tan_dilation;
    state.shear = trial - std::copysign(law.shear * slip, trial);
    state.lost = std::min(1.0, state.lost + (slip > 0 ? lost_by(law, slip) : 0));
    state.status = slip > 0 ? ContactStatus::kSliding : ContactStatus::kStuck;
    sigma = normal_stress(law, state);
    if (was_open) {
      const double elastic = du < 0 ? std::min(1.0, sigma / (law.normal * du)) : 0;  // share of the way
      stroke.normal = sigma / 2 * elastic;
      stroke.normal_stiffness = 1 - (1 - elastic) * (1 - elastic);
    } else {
      stroke.normal = (sigma_before + sigma) / 2;
      stroke.normal_stiffness = 1;
    }
    // Stress beyond the present strength is lost at once.
    const double bound = std::abs(state.shear),
                 from = slip > 0 ? std::clamp(shear_before, -bound, bound) : shear_before;
    const double elastic =
        state.shear == from ? 0 : (state.shear - from) / (law.shear * ds);  // share of the way
    stroke.shear = slip > 0 ? state.shear + (from - state.shear) / 2 * elastic : (from + state.shear) / 2;
    stroke.shear_stiffness = slip > 0 ? elastic * elastic : 1;
  }
  stroke.dissipated = stroke.normal * du + stroke.shear * ds - (strain_energy(law, state) - stored_before);
  return stroke;
}

}  // namespace adit::fdm
