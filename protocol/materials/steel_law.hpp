// Reinforcing steel over time: elastic, then yielding with linear kinematic hardening (Prager 1956).
//
//   |sigma - alpha| <= f_y,   d sigma = E (d eps - d eps_p),   d alpha = H d eps_p,   H = b E / (1 - b),
// so that the slope after yield is b E. Stored: sigma^2/2E + alpha^2/2H.
#pragma once

#include <cmath>

namespace adit::protocol {

struct SteelLaw {
  double modulus;    // E [Pa]
  double yield;      // f_y [Pa]
  double hardening;  // b, below 1

  double plastic_modulus() const { return hardening * modulus / (1 - hardening); }
};

struct SteelState {
  double stress = 0;
  double plastic = 0, back = 0;  // eps_p, alpha [Pa]
};

inline void strain_to(const SteelLaw& law, double strain, SteelState& state) {
  const double trial = law.modulus * (strain - state.plastic),
               over = std::abs(trial - state.back) - law.yield;
  state.stress = trial;
  if (over <= 0) return;
  const double h = law.plastic_modulus(), slip = std::copysign(over / (law.modulus + h), trial - state.back);
  state.plastic += slip;
  state.back += h * slip;
  state.stress = trial - law.modulus * slip;
}

inline double stored(const SteelLaw& law, const SteelState& state) {  // [J/m^3]
  const double h = law.plastic_modulus();
  return (state.stress * state.stress / law.modulus + (h > 0 ? state.back * state.back / h : 0)) / 2;
}

}  // namespace adit::protocol
