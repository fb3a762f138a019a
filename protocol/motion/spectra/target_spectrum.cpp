#include "protocol/motion/spectra/target_spectrum.hpp"

#include <fmt/format.h>

#include "protocol/errors.hpp"
#include "protocol/motion/motion.hpp"

namespace adit::motion {
namespace {

struct Ec8Parameters {
  double soil, tb, tc, td;
};

// EN 1998-1:2004, table 3.2.
Ec8Parameters type1(GroundType ground) {
  switch (ground) {
    case GroundType::kA:
      return {1.0, 0.15, 0.4, 2.0};
    case GroundType::kB:
      return {1.2, 0.15, 0.5, 2.0};
    case GroundType::kC:
      return {1.15, 0.20, 0.6, 2.0};
    case GroundType::kD:
      return {1.35, 0.20, 0.8, 2.0};
    case GroundType::kE:
      return {1.4, 0.15, 0.5, 2.0};
  }
  return {};
}

constexpr double kPlateau = 2.5;

}  // namespace

TargetSpectrum gb18306(double peak, double characteristic_period) {
  constexpr double kPlateauBegins = 0.1;  // [s]
  require_positive(peak, "peak acceleration of the spectrum");
  if (!(characteristic_period > kPlateauBegins && characteristic_period < 10))
    throw protocol::UserError(
        "", fmt::format("the characteristic period is {} s; give one between 0.1 s and 10 s",
                        characteristic_period));
  return [=](double period) {
    if (period < kPlateauBegins) return peak * (1 + (kPlateau - 1) * period / kPlateauBegins);
    if (period <= characteristic_period) return peak * kPlateau;
    return peak * kPlateau * characteristic_period / period;
  };
}

TargetSpectrum ec8_type1(double ground_acceleration, GroundType ground) {
  require_positive(ground_acceleration, "ground acceleration of the spectrum");
  const Ec8Parameters p = type1(ground);
  const double peak = ground_acceleration * p.soil;
  return [=](double period) {
    if (period < p.tb) return peak * (1 + (kPlateau - 1) * period / p.tb);
    if (period <= p.tc) return peak * kPlateau;
    if (period <= p.td) return peak * kPlateau * p.tc / period;
    return peak * kPlateau * p.tc * p.td / (period * period);
  };
}

}  // namespace adit::motion
