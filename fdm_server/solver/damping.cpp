#include "fdm_server/solver/damping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

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

Maxwell::Maxwell(const DampingLaw& law, const protocol::Step& step) {
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
  const Maxwell maxwell(law_, step);
  const auto axis = [&](double* force, double* zones, double* viscous) {
    for (const auto [begin, end] : ranges)
#pragma GCC ivdep
      for (std::size_t i = begin; i < end; ++i) {
        viscous[i] = maxwell(viscous[i], force[i] - zones[i]);
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

namespace {

// One component of the points; powers in lanes, which the compiler makes a vector.
struct Component {
  const double *velocity, *inverse_mass, *mass, *local, *viscous;
  double *force, *damping;
};
constexpr std::size_t kLanes = 4;
using Powers = std::array<double, kLanes>;

// `drag`: alpha over its implicit factor; 0 where nothing acts yet.
template <bool kLocal>
ADIT_VECTOR_CLONES void add_to(const protocol::IndexRange& range, double drag, double half, double acts,
                               const Component& axis, Powers& powers) {
  const Component of = axis;
  Powers power = powers;
  const auto add = [&](std::size_t i, double& lane) {
    const double v = of.velocity[i], f = of.force[i];
    double taken = drag * of.mass[i] * (v + half * of.inverse_mass[i] * f);
    if constexpr (kLocal)
      taken += of.inverse_mass[i] > 0 ? acts * of.local[i] * std::abs(f) * protocol::sign(v) : 0;
    const double all = of.viscous[i] - taken;
    of.force[i] = f - taken;
    lane += v * (of.damping[i] + all);
    of.damping[i] = all;
  };
  std::size_t i = range.begin;
  for (; i + kLanes <= range.end; i += kLanes)
#pragma GCC ivdep
    for (std::size_t lane = 0; lane < kLanes; ++lane) add(i + lane, power[lane]);
  for (; i < range.end; ++i) add(i, power[0]);
  powers = power;
}

}  // namespace

double Damping::add_others(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                           const PointArrays& points) {
  if (!law_.any() || step.relax) return 0;
  const double half = step.kick() / 2, acts = step.from_rest() ? 0 : 1;
  const double drag = acts * law_.alpha / (1 + law_.alpha * half);
  const auto add = law_.local > 0 ? add_to<true> : add_to<false>;
  Powers powers{};
  for (const Component& axis : {Component{points.vx, points.inverse_mass_x, points.mass, local_.data(),
                                          state_[kViscousX].data(), points.fx, state_[kDampingX].data()},
                                Component{points.vy, points.inverse_mass_y, points.mass, local_.data(),
                                          state_[kViscousY].data(), points.fy, state_[kDampingY].data()}})
    for (const auto& range : ranges) add(range, drag, half, acts, axis, powers);
  return acts * -step.dt / 2 * ((powers[0] + powers[1]) + (powers[2] + powers[3]));
}

}  // namespace adit::fdm
