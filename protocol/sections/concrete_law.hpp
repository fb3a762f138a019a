// Concrete over time: stress of a fibre under strains that come and go.
//
// Compression, c = |eps|, eta = c / eps_c1: the curve of EN 1992-1-1:2004, eq. 3.14,
//   sigma = -f_c (k eta - eta^2) / (1 + (k - 2) eta),   k = E eps_c1 / f_c,
// with E its slope at the origin (1.05 E_cm). The code gives it up to eps_cu1; here it goes on to eta = k,
// where it reaches zero: crushed concrete carries nothing. Table 3.1: eps_c1 = min(0.7 f_cm^0.31, 2.8)/1000,
// f_cm in MPa.
// Confined concrete (confined_concrete.hpp) has the curve of Popovics (1973) in its place,
//   sigma = -f_c eta r / (r - 1 + eta^r),   r = E / (E - f_c/eps_c1),
// up to the strain at which the first stirrup breaks, and falls in proportion to zero at twice that.
// Unloading and loading again follow the straight line from the largest c, r, to the residual strain p of
// Karsan and Jirsa (1969, J. Struct. Div. ASCE 95), with q = r / eps_c1,
//   p / eps_c1 = 0.145 q^2 + 0.13 q   up to q = 2,   0.707 (q - 2) + 0.834 above,
// never steeper than E. Loading returns to the curve where it was left.
// Tension, t the strain beyond -p: E t up to f_t, then the line that falls to zero at the end strain. Where
// bars hold cracked concrete, it begins with k_t f_t, to which stress falls by three times the cracking
// strain: k_t = 0.6 is the mean between cracks under loads of short duration (EN 1992-1-1:2004, 7.3.4). The
// residual line of fibres (fibre_concrete.hpp) holds where it is larger. Cracks close along the straight line
// to t = 0, and the compression is that before they opened.
//
// The tangent never exceeds E. What is stored is that of the line on which the fibre would unload, sigma^2/2
// over its slope; the rest of the work is dissipated.
#pragma once

#include <algorithm>
#include <cmath>

namespace adit::sections {

// Residual tensile stress of fibres over the strain beyond cracking.
struct ResidualTension {
  double first = 0, last = 0;  // at the crack, at the end strain [Pa]
  double end_strain = 0;       // nothing is left beyond

  double stress(double strain) const {
    if (strain > end_strain) return 0;
    return first + (last - first) * strain / end_strain;
  }
};

struct ConcreteLaw {
  double modulus;                                // E [Pa]
  double strength, peak_strain;                  // f_c [Pa], eps_c1, positive
  double tensile_strength = 0, tensile_end = 0;  // f_t [Pa]; the end strain, beyond f_t/E
  ResidualTension residual{};
  double bonded = 1;          // k_t: the share of f_t that is left between cracks
  double stirrups_break = 0;  // strain, positive; 0 without confinement

  double compression(double c) const {  // [Pa], positive
    if (stirrups_break > 0)
      return popovics(std::min(c, stirrups_break)) * std::clamp(2 - c / stirrups_break, 0.0, 1.0);
    const double k = modulus * peak_strain / strength, eta = c / peak_strain;
    if (eta >= k) return 0;
    return strength * (k * eta - eta * eta) / (1 + (k - 2) * eta);
  }
  // The strain from which nothing is left, positive.
  double crushed() const {
    return stirrups_break > 0 ? 2 * stirrups_break : modulus * peak_strain * peak_strain / strength;
  }
  double tension(double t) const {
    const double cracking = tensile_strength / modulus;
    if (t <= cracking) return modulus * t;
    double line =
        t < tensile_end ? bonded * tensile_strength * (tensile_end - t) / (tensile_end - cracking) : 0.0;
    if (bonded < 1) line = std::max(line, tensile_strength * (3 * cracking - t) / (2 * cracking));
    return std::min(std::max(line, residual.stress(t)), modulus * t);
  }
  double residual_strain(double largest) const {
    const double q = largest / peak_strain;
    const double p = peak_strain * (q < 2 ? (0.145 * q + 0.13) * q : 0.707 * (q - 2) + 0.834);
    return std::min(p, largest - compression(largest) / modulus);
  }

 private:
  double popovics(double c) const {
    const double eta = c / peak_strain, r = modulus / (modulus - strength / peak_strain);
    return strength * eta * r / (r - 1 + std::pow(eta, r));
  }
};

// What a fibre remembers.
struct ConcreteState {
  double stress = 0;
  double crushed = 0, residual = 0;   // r, p
  double opened = 0;                  // the largest t
  double closing = 0, unloading = 0;  // slopes in tension and in compression [Pa]
};

inline ConcreteState virgin(const ConcreteLaw& law) {
  return {0,          0, 0, law.tensile_strength / law.modulus, law.tensile_strength > 0 ? law.modulus : 0.0,
          law.modulus};
}

inline void strain_to(const ConcreteLaw& law, double strain, ConcreteState& state) {
  const double beyond = strain + state.residual;
  if (beyond >= 0) {
    if (beyond > state.opened) {
      state.opened = beyond;
      state.closing = law.tension(beyond) / beyond;
    }
    state.stress = state.closing * beyond;
    return;
  }
  if (-strain > state.crushed) {
    state.crushed = -strain;
    state.residual = law.residual_strain(state.crushed);
    const double envelope = law.compression(state.crushed);
    state.unloading = envelope > 0 ? envelope / (state.crushed - state.residual) : 0;
    state.stress = -envelope;
    return;
  }
  state.stress = state.unloading * beyond;
}

inline double stored(const ConcreteState& state) {  // [J/m^3]
  const double slope = state.stress > 0 ? state.closing : state.unloading;
  return slope > 0 ? state.stress * state.stress / slope / 2 : 0;
}

}  // namespace adit::sections
