#include "fdm_server/solver/damping.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {

double Damping::damp(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                     const PointArrays& points) {
  if (!acts() || step.relax) return 0;
  add_viscous(ranges, step, points);
  return add_others(ranges, step, points);
}

namespace {

// One component of the points: forces of the zones at the last step, of the elements, of each of these.
struct Viscous {
  double *force, *zones, *viscous;
  std::array<double*, kMostElements> elements;
};

template <std::size_t kCount>
ADIT_VECTOR_CLONES void pull(const protocol::IndexRange& range, const MaxwellStep& step,
                             const Viscous& component) {
  const Viscous of = component;
  const MaxwellStep maxwell = step;
#pragma GCC ivdep
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double growth = of.force[i] - of.zones[i];
    double sum = 0;
    for (std::size_t e = 0; e < kCount; ++e) sum += of.elements[e][i] = maxwell(e, of.elements[e][i], growth);
    of.zones[i] = of.force[i];
    if constexpr (kCount > 1) of.viscous[i] = sum;
    of.force[i] += sum;
  }
}

}  // namespace

void Damping::add_viscous(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                          const PointArrays& points) {
  if (law_.count() == 0 || step.relax) return;
  const MaxwellStep maxwell(law_, step);
  const bool several = law_.count() > 1;
  const auto find = several ? pull<kMostElements> : pull<1>;
  for (std::size_t axis : {0, 1}) {
    Viscous component{axis == 0 ? points.fx : points.fy,
                      state_[kZonesX + axis].data(),
                      state_[kViscousX + axis].data(),
                      {}};
    component.elements[0] = component.viscous;  // of one alone
    for (std::size_t e = 0; several && e < kMostElements; ++e)
      component.elements[e] = elements_[2 * e + axis].data();
    for (const auto& range : ranges) find(range, maxwell, component);
  }
}

void Damping::tie(std::span<const std::uint32_t> points) {
  if (!acts()) return;
  for (const std::uint32_t i : points) local_[i] = free_[i] = 0;
}

namespace {

// One component of the points; powers in lanes, which the compiler makes a vector.
struct Component {
  const double *velocity, *inverse_mass, *mass, *local, *free, *viscous;
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
    double taken = drag * of.mass[i] * (v + half * of.free[i] * of.inverse_mass[i] * f);
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
  for (const Component& axis :
       {Component{points.vx, points.inverse_mass_x, points.mass, local_.data(), free_.data(),
                  state_[kViscousX].data(), points.fx, state_[kDampingX].data()},
        Component{points.vy, points.inverse_mass_y, points.mass, local_.data(), free_.data(),
                  state_[kViscousY].data(), points.fy, state_[kDampingY].data()}})
    for (const auto& range : ranges) add(range, drag, half, acts, axis, powers);
  return acts * -step.dt / 2 * ((powers[0] + powers[1]) + (powers[2] + powers[3]));
}

}  // namespace adit::fdm
