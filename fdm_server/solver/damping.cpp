#include "fdm_server/solver/damping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "protocol/participant/local_damping.hpp"

namespace adit::fdm {

DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency) {
  const double low = 2 * std::numbers::pi * low_frequency, high = 2 * std::numbers::pi * high_frequency;
  return {.alpha = 2 * ratio * low * high / (low + high), .beta = 2 * ratio / (low + high)};
}

double critical_step(const DampingLaw& law, double undamped) {
  if (law.beta == 0) return undamped;
  const double y = law.beta / undamped, of_dashpot = undamped * (std::sqrt(1 + y * y) - y);
  return std::max(of_dashpot, undamped / std::sqrt(1 + law.beta / law.relaxation()));
}

Relaxed::Relaxed(const DampingLaw& law, const protocol::Step& step) {
  if (law.beta == 0 || step.relax || step.from_rest()) return;
  const double twice = std::max(2 * law.relaxation(), step.dt);
  keep = (twice - step.dt) / (twice + step.dt);
  take = 2 * law.beta / (twice + step.dt);
}

double Damping::damp(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                     const PointArrays& points) {
  if (!acts() || step.relax) return 0;
  add_viscous(ranges, step, points);
  return add_others(ranges, step, points);
}

void Damping::add_viscous(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                          const PointArrays& points) {
  if (law_.beta == 0 || step.relax) return;
  const Relaxed relaxed(law_, step);
  const auto axis = [&](double* force, double* zones, double* viscous) {
    for (const auto [begin, end] : ranges)
#pragma GCC ivdep
      for (std::size_t i = begin; i < end; ++i) {
        viscous[i] = relaxed(viscous[i], force[i] - zones[i]);
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
                           const PointArrays& points) {
  if (!law_.any() || step.relax) return 0;
  constexpr std::size_t kLanes = 4;
  const double half = step.kick() / 2, implicit = 1 + law_.alpha * half, acts = step.from_rest() ? 0 : 1;
  std::array<double, kLanes> power{};  // in lanes, which the compiler makes a vector
  const auto axis = [&](const double* velocity, double* force, const double* inverse_mass,
                        const double* viscous, double* damping) {
    const auto add = [&](std::size_t i, double& lane) {
      const double v = velocity[i], f = force[i];
      const double drag = law_.alpha * points.mass[i] * (v + half * inverse_mass[i] * f) / implicit;
      const double brake = inverse_mass[i] > 0 ? local_[i] * std::abs(f) * protocol::sign(v) : 0;
      const double added = -acts * (drag + brake), all = added + viscous[i];
      force[i] = f + added;
      lane += v * (damping[i] + all);
      damping[i] = all;
    };
    for (const auto [begin, end] : ranges) {
      std::size_t i = begin;
      for (; i + kLanes <= end; i += kLanes)
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < kLanes; ++lane) add(i + lane, power[lane]);
      for (; i < end; ++i) add(i, power[0]);
    }
  };
  axis(points.vx, points.fx, points.inverse_mass_x, state_[kViscousX].data(), state_[kDampingX].data());
  axis(points.vy, points.fy, points.inverse_mass_y, state_[kViscousY].data(), state_[kDampingY].data());
  return acts * -step.dt / 2 * ((power[0] + power[1]) + (power[2] + power[3]));
}

}  // namespace adit::fdm
