#include "coupler/bridging/decay.hpp"

#include <cmath>

namespace adit::coupler {

double default_decay_rate(double wave_speed, double width) {
  constexpr double kDecayOnTheWay = 25;
  return kDecayOnTheWay * wave_speed / width;
}

std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt) {
  std::vector<double> shares;
  shares.reserve(across.size());
  for (const double place : across) shares.push_back(-std::expm1(-rate * place * place * place * dt));
  return shares;
}

}  // namespace adit::coupler
