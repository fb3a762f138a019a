// Design spectra: pseudo-acceleration [m/s^2] of an oscillator of 5 % damping over its period [s].
#pragma once

#include <functional>

namespace adit::motion {

using TargetSpectrum = std::function<double(double period)>;

// GB 18306-2015, the normalized spectrum of the zonation map: peak (1 + 15 T) up to T = 0.1 s, 2.5 peak up to
// the characteristic period, then 2.5 peak characteristic_period / T. `peak`: peak acceleration on the site's
// class of ground [m/s^2], after the adjustments of the standard's appendix E; `characteristic_period`: Tg of
// that class, above 0.1 s. Peak and Tg are defined in clauses 3.4 and 3.5 (English text at
// codeofchina.com/standard/GB18306-2015.html). The factor 2.5, the 0.1 s and the exponent of the decay were
// not checked against the text of the standard.
TargetSpectrum gb18306(double peak, double characteristic_period);

// EN 1998-1:2004, 3.2.2.2: horizontal elastic spectrum of type 1 with the recommended S, T_B, T_C and T_D of
// table 3.2, taken over from another code (github.com/herrera-mauricio/SynthQuake, EspectroEuro8.m).
// `ground_acceleration`: a_g on ground type A, importance included [m/s^2].
enum class GroundType { kA, kB, kC, kD, kE };
TargetSpectrum ec8_type1(double ground_acceleration, GroundType ground);

}  // namespace adit::motion
