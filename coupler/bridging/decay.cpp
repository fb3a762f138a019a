#include "coupler/bridging/decay.hpp"

#include <cmath>

namespace adit::coupler {

double default_decay_rate(double wave_speed, double width) {
  // The fine motion on its way through the overlap decays by exp(-25/4): the mean of across³ is 1/4.
  constexpr double kDecayOnTheWay = 25;
  return kDecayOnTheWay * wave_speed / width;
}

std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt) {
  std::vector<double> shares;
  shares.reserve(across.size());
  // expm1, because 1 − exp(−x) loses all digits for the small x of short time steps.
  for (const double place : across) shares.push_back(-std::expm1(-rate * place * place * place * dt));
  return shares;
}

}  // namespace adit::coupler
