// Bond of a ribbed bar to concrete: shear stress tau by slip s (Eligehausen, Popov & Bertero 1983,
// UCB/EERC-83/23; fib Model Code 2010, 6.1.1), simplified for reversals.
//
//   |tau| <= f(|s|) where the slip is larger than ever before:
//     f = tau_max (s / s_1)^alpha  up to s_1,  tau_max  up to s_2,  falling in proportion to  rho tau_max  at
//     s_3;
//   d tau = k (d s - d s_p),  s_p the part of the slip that stays,
// where a bar was before, to s_r on either side, the ribs have crushed the concrete, and friction is left:
//   |tau| <= max(min(f(s_r), rho tau_max), f(s_r) - k (s_r - |s|)),
// the latter while it slips outwards: near s_r its ribs bear again. Stored: tau^2 / 2k; what s_p takes is
// lost.
#pragma once

#include <algorithm>
#include <cmath>

namespace adit::dem {

struct BarBondLaw {
  double stiffness;                // k [Pa/m]
  double strength;                 // tau_max [Pa]
  double peak, plateau, residual;  // s_1, s_2, s_3 [m]
  double exponent, friction;       // alpha, rho

  double envelope(double slip) const {
    if (slip < peak) return strength * std::pow(slip / peak, exponent);
    if (slip <= plateau) return strength;
    if (slip >= residual) return friction * strength;
    return strength * (1 - (1 - friction) * (slip - plateau) / (residual - plateau));
  }
};

struct BarBondState {
  double stress = 0;            // tau [Pa]
  double plastic = 0, far = 0;  // s_p, s_r [m]
};

// What is left of the strength where the bar has yielded (fib Model Code 2010, 6.1.1.3, of the exponent b =
// 1): its strain beyond yield over that from yield to rupture.
inline double bond_after_yield(double beyond_yield) {
  return 1 - 0.85 * (1 - std::exp(-5 * std::max(0.0, beyond_yield)));
}

// Largest |tau| and how it grows with the size of the slip.
struct BarBondLimit {
  double stress, slope;  // [Pa], [Pa/m]
};

// At a slip that would come about in the direction of `trial` [Pa].
inline BarBondLimit bond_limit(const BarBondLaw& law, double slip, double trial, const BarBondState& state) {
  const double size = std::abs(slip), reached = law.envelope(state.far);
  const BarBondLimit friction{std::min(reached, law.friction * law.strength), 0};
  if (trial * slip < 0) return friction;
  if (size > state.far) {
    const double stress = law.envelope(size);
    return {stress, size < law.peak ? law.exponent * stress / size : 0};
  }
  const double back = reached - law.stiffness * (state.far - size);
  return back > friction.stress ? BarBondLimit{back, law.stiffness} : friction;
}

struct BarBondStep {
  BarBondState state;
  double stiffness;  // of what follows, at least 0 [Pa/m]
};

// To a slip [m] from a state before.
inline BarBondStep slip_to(const BarBondLaw& law, double slip, const BarBondState& before) {
  BarBondStep now{before, law.stiffness};
  BarBondState& state = now.state;
  state.far = std::max(state.far, std::abs(slip));
  state.stress = law.stiffness * (slip - before.plastic);
  const BarBondLimit limit = bond_limit(law, slip, state.stress, before);
  if (std::abs(state.stress) <= limit.stress) return now;
  state.stress = std::copysign(limit.stress, state.stress);
  state.plastic = slip - state.stress / law.stiffness;
  now.stiffness = limit.slope;
  return now;
}

}  // namespace adit::dem
