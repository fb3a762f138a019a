#include "fdm_server/solver/damping.hpp"

#include <cmath>
#include <numbers>

namespace adit::fdm {

DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency) {
  const double low = 2 * std::numbers::pi * low_frequency, high = 2 * std::numbers::pi * high_frequency;
  return {.alpha = 2 * ratio * low * high / (low + high), .beta = 2 * ratio / (low + high)};
}

double critical_step(const DampingLaw& law, double undamped) {
  const double x = law.beta / undamped;  // beta w/2 with w = 2/undamped
  return undamped * (std::sqrt(1 + x * x) - x);
}

void Damping::add_viscous(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                          const PointArrays& points) {
  if (law_.beta == 0 || step.relax) return;
  const double factor = step.from_rest() ? 0 : law_.beta / step.dt;
  const auto axis = [&](double* force, double* zones, double* viscous) {
    for (const auto [begin, end] : ranges)
      for (std::size_t i = begin; i < end; ++i) {
        viscous[i] = factor * (force[i] - zones[i]);
        zones[i] = force[i];
        force[i] += viscous[i];
      }
  };
  axis(points.fx, state_[kZonesX].data(), state_[kViscousX].data());
  axis(points.fy, state_[kZonesY].data(), state_[kViscousY].data());
}

void Damping::tie(std::span<const std::uint32_t> points) {
  if (!acts()) return;
  for (const std::uint32_t i : points) local_[i] = 0;
}

double Damping::add_others(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                           const PointArrays& points, std::span<const double> masses) {
  if (!law_.any() || step.relax) return 0;
  const double half = step.kick() / 2, implicit = 1 + law_.alpha * half;
  double power = 0;
  const auto axis = [&](const double* velocity, double* force, const double* inverse_mass,
                        const double* viscous, double* damping) {
    for (const auto [begin, end] : ranges)
      for (std::size_t i = begin; i < end; ++i) {
        double added = 0;
        if (!step.from_rest()) {
          const double v = velocity[i];
          added = -law_.alpha * masses[i] * (v + half * inverse_mass[i] * force[i]) / implicit;
          if (v != 0 && inverse_mass[i] > 0) added -= local_[i] * std::copysign(force[i], v);
        }
        force[i] += added;
        added += viscous[i];
        power += velocity[i] * (damping[i] + added);
        damping[i] = added;
      }
  };
  axis(points.vx, points.fx, points.inverse_mass_x, state_[kViscousX].data(), state_[kDampingX].data());
  axis(points.vy, points.fy, points.inverse_mass_y, state_[kViscousY].data(), state_[kDampingY].data());
  return step.from_rest() ? 0 : -step.dt / 2 * power;
}

}  // namespace adit::fdm
