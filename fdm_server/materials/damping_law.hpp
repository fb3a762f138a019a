// How the ground damps its own vibrations, and what this does to the critical step.
//
// Mass: alpha M, the ratio alpha/2w at the angular frequency w.
//
// Maxwell's elements: dashpots, each behind a spring that is a share s of the zones' stiffness K, beside the
// zones. For constant K the modulus is G (1 + sum s i w tau/(1 + i w tau)); otherwise K is the stiffness of
// the moment, and what yields is not damped. By the trapezoidal rule, with f the zones' force, an element
// adds
//   g(n) = a g(n-1) + (1 - a) s tau (f(n) - f(n-1))/dt,   a = (2 tau - dt)/(2 tau + dt).
// Steps longer than 2 tau have dt/2 in the place of tau, and s tau as it is: a = 0, the dashpot alone, which
// looks half a step back.
//
// Rayleigh: alpha M + beta K, the ratio (alpha/w + beta w)/2; the ratio x at w1 and w2 needs
// alpha = 2 x w1 w2/(w1 + w2), beta = 2 x/(w1 + w2). For beta K stands one element with s = 6, tau = beta/6:
// up to w2 its ratio is Rayleigh's within x^2/9 of it, and the modulus G within 2/3 x^2 (0.17 % where x is 5
// %).
//
// Maxwell damping: the ratio x from w1 to w2, by elements whose 1/tau stand at w1, sqrt(w1 w2) and w2; a band
// of less than 30 to 1 is widened to that, because springs of narrower ones would have to pull against each
// other. With S(w) = sum s (w tau)^2/(1 + (w tau)^2) and L(w) = sum s w tau/(1 + (w tau)^2) the ratio is
// L/2(1 + S), and L - 2 x S = 2 x is linear in s: least squares over the band leave at most 5 % of x where w2
// is up to 100 w1 and x up to 5 %. No ground damps all frequencies alike without being stiffer at the higher
// ones: by S, 2.5 % at w1 and 5.6 % at w2 = 10 w1 with x = 1 %.
//
// Critical step: with e(n) = a e(n-1) + u(n) - u(n-1), so that g = -c K e, c = (1 - a) s tau/dt, the sum
//   1/2 M v.v + 1/2 (K + B) u(n).u(n+1) + sum over elements 1/2 c K (e(n).e(n+1) + (1 - a)/2 e(n).e(n))
// (B: stiffness without damping, as of linings; v between u(n) and u(n+1)) falls in each step by the sum of
// (1 - a)/4 c K (e(n) + e(n-1)).(e(n) + e(n-1)), and is not negative where
//   M - dt^2/4 (B + K (1 + sum s)) > 0,
// since e(n).e(n+1) + (1 - a)/2 e(n).e(n) >= -d.d/2(1 + a), d = dt v, and c/(1 + a) = s/2. The left side is a
// sum over zones, so that each may be asked by itself. Dashpots alone allow zones 2/w (sqrt(1 + y^2) - y), y
// = w/2 sum s tau (Belytschko 1983): a tenth of 2/w and less where they are small beside the waves. With
// springs it is at least 2/w/sqrt(1 + sum s).
#pragma once

#include <array>
#include <cstddef>

#include "protocol/participant/step.hpp"

namespace adit::fdm {

inline constexpr std::size_t kMostElements = 3;
using Elements = std::array<double, kMostElements>;  // one value an element

struct DampingLaw {
  struct Element {
    double spring = 0;      // s; 0: there is none
    double relaxation = 0;  // tau [s]
    double viscosity() const { return spring * relaxation; }
  };
  double alpha = 0;  // [1/s]
  double local = 0;  // share of the unbalanced force (damping.hpp)
  std::array<Element, kMostElements> elements{};

  std::size_t count() const;  // of elements
  bool any() const { return alpha != 0 || local != 0 || count() > 0; }
};

// Rayleigh damping with the ratio at both frequencies [Hz]; alpha [1/s] and beta [s].
DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency);
DampingLaw rayleigh(double alpha, double beta);

// Maxwell damping with the ratio, at most 0.05, from one frequency to the other [Hz], at most kWidestBand
// times as high.
inline constexpr double kWidestBand = 100;
DampingLaw maxwell(double ratio, double low_frequency, double high_frequency);

// How stiff zones are in waves of this frequency [Hz], over what they are under slow loads: 1 + S.
double stiffening(const DampingLaw& law, double frequency);

// The damping ratio at this frequency [Hz]: alpha/2w + L/2(1 + S).
double damping_ratio(const DampingLaw& law, double frequency);

// The critical step [s] of zones whose undamped critical step is `undamped`.
double critical_step(const DampingLaw& law, double undamped);

// What a step does to the elements' forces; nothing in statics and from rest.
struct MaxwellStep {
  Elements keep{}, take{};
  MaxwellStep(const DampingLaw& law, const protocol::Step& step);
  // The force of an element whose force was g, after a step in which the zones' force grew.
  double operator()(std::size_t element, double g, double growth) const {
    return keep[element] * g + take[element] * growth;
  }
};

}  // namespace adit::fdm
