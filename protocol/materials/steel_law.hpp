// Reinforcing steel over time.
//
// Bilinear: elastic, then yielding with linear kinematic hardening (Prager 1956),
//   |sigma - alpha| <= f_y,   d sigma = E (d eps - d eps_p),   d alpha = H d eps_p,   H = b E / (1 - b),
// so that the slope after yield is b E. Stored: sigma^2/2E + alpha^2/2H.
//
// Menegotto and Pinto (1973, IABSE Reports 13; with the numbers of Filippou, Popov and Bertero 1983,
// UCB/EERC-83/19): from a reversal (eps_r, sigma_r) stress turns from the slope E into the same line of slope
// b E, which it would meet at (eps_0, sigma_0):
//   s = b x + (1 - b) x / (1 + |x|^R)^(1/R),   x = (eps - eps_r)/(eps_0 - eps_r),
//   s = (sigma - sigma_r)/(sigma_0 - sigma_r),   R = 20 (1 - 0.925 xi/(0.15 + xi)),
// xi the distance from eps_0 to the farthest strain on that side, over f_y/E. Loading again after a small
// reversal would overshoot the curve that was left; beyond the strain where that was, the lower of both
// holds. Stored: sigma^2/2E.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace adit::protocol {

enum class SteelCurve { kBilinear, kMenegottoPinto };

struct SteelLaw {
  double modulus;    // E [Pa]
  double yield;      // f_y [Pa]
  double hardening;  // b, below 1
  SteelCurve curve = SteelCurve::kBilinear;
  double rupture = std::numeric_limits<double>::infinity();  // tensile strain

  double plastic_modulus() const { return hardening * modulus / (1 - hardening); }
};

// From a reversal to where the line of hardening would be met.
struct SteelBranch {
  double strain = 0, stress = 0, to_strain = 0, to_stress = 0;
  double exponent = 0;  // R
};

// Of one sense of loading: tension, compression.
struct SteelSense {
  double farthest = 0;      // the strain farthest on its side
  double left = 0;          // the strain where its branch was left
  double was_left = 0;      // 1, once it was
  SteelBranch branch = {};  // that branch
};

struct SteelState {
  double stress = 0;
  double broken = 0;             // 1, once it is
  double plastic = 0, back = 0;  // bilinear: eps_p, alpha [Pa]
  // Menegotto and Pinto: the last strain, its sense of 1 or -1, and the branch there.
  double strain = 0, way = 0;
  SteelBranch branch = {};
  std::array<SteelSense, 2> senses = {};
};

namespace steel {

struct CurvePoint {
  double stress, slope;  // [Pa]
};

inline CurvePoint on_branch(const SteelLaw& law, const SteelBranch& of, double strain) {
  constexpr double kFar = 1e3;  // there the curve is on the line
  const double span = of.to_strain - of.strain, b = law.hardening;
  const double x = (strain - of.strain) / span, size = std::abs(x);
  const double power = size < kFar ? std::pow(size, of.exponent) : std::numeric_limits<double>::infinity();
  const double round = size < kFar ? std::pow(1 + power, 1 / of.exponent) : size;
  return {of.stress + (b * x + (1 - b) * x / round) * (of.to_stress - of.stress),
          law.modulus * (b + (1 - b) / (round * (1 + power)))};
}

inline SteelSense& sense(double way, SteelState& state) {
  return state.senses[way > 0 ? 0 : 1];
}

// Loading turns to the other sense, or begins.
inline void reverse(const SteelLaw& law, double way, SteelState& state) {
  const double yield = law.yield / law.modulus;
  if (state.way == 0)
    for (const double one : {1.0, -1.0}) sense(one, state).farthest = one * yield;
  else
    sense(state.way, state) = {sense(state.way, state).farthest, state.strain, 1, state.branch};
  const double to = state.strain + (way * law.yield - state.stress / (1 - law.hardening) +
                                    law.hardening / (1 - law.hardening) * law.modulus * state.strain) /
                                       law.modulus;
  const double farthest = sense(way, state).farthest;
  const double xi = std::abs(farthest - to) / yield;
  const double span = way * std::max(way * (to - state.strain), 1e-9 * yield);
  state.branch = {state.strain, state.stress, state.strain + span, state.stress + law.modulus * span,
                  20 * (1 - 0.925 * xi / (0.15 + xi))};
  state.way = way;
}

inline double strain_on_curve(const SteelLaw& law, double strain, SteelState& state) {
  if (strain == state.strain && state.way == 0) return law.modulus;
  const double way = strain > state.strain ? 1 : strain < state.strain ? -1 : state.way;
  if (way != state.way) reverse(law, way, state);
  CurvePoint now = on_branch(law, state.branch, strain);
  if (SteelSense& before = sense(way, state); before.was_left == 1 && way * (strain - before.left) >= 0) {
    const CurvePoint there = on_branch(law, before.branch, strain);
    if (way * there.stress < way * now.stress) {
      now = there;
      state.branch = before.branch;
      before.was_left = 0;
    }
  }
  SteelSense& of = sense(way, state);
  of.farthest = way * std::max(way * of.farthest, way * strain);
  state.strain = strain;
  state.stress = now.stress;
  return now.slope;
}

}  // namespace steel

// Returns the slope of what follows in the same sense [Pa].
inline double strain_to(const SteelLaw& law, double strain, SteelState& state) {
  if (state.broken == 1) {
    state = {};
    state.broken = 1;
    return 0;
  }
  if (law.curve == SteelCurve::kMenegottoPinto) return steel::strain_on_curve(law, strain, state);
  const double trial = law.modulus * (strain - state.plastic),
               over = std::abs(trial - state.back) - law.yield;
  state.stress = trial;
  if (over <= 0) return law.modulus;
  const double h = law.plastic_modulus(), slip = std::copysign(over / (law.modulus + h), trial - state.back);
  state.plastic += slip;
  state.back += h * slip;
  state.stress = trial - law.modulus * slip;
  return law.hardening * law.modulus;
}

// Breaks in the next step where it was strained too far in this one.
inline void break_beyond(const SteelLaw& law, double strain, SteelState& state) {
  if (strain > law.rupture) state.broken = 1;
}

inline double stored(const SteelLaw& law, const SteelState& state) {  // [J/m^3]
  const double h = law.plastic_modulus();
  return (state.stress * state.stress / law.modulus + (h > 0 ? state.back * state.back / h : 0)) / 2;
}

}  // namespace adit::protocol
