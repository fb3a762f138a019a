#include "fdm_server/solver/continuum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adit::fdm {
namespace {

// Moves the shares of the chosen points out of a load.
Load take(Load& load, const std::vector<bool>& chosen) {
  Load taken{{}, {}, {}, load.factor}, left = taken;
  for (std::size_t i = 0; i < load.points.size(); ++i) {
    Load& to = chosen[load.points[i]] ? taken : left;
    to.points.push_back(load.points[i]);
    to.fx.push_back(load.fx[i]);
    to.fy.push_back(load.fy[i]);
  }
  load = std::move(left);
  return taken;
}

// Moves the chosen points out of a motion.
Motion take(Motion& motion, const std::vector<bool>& chosen) {
  Motion taken{{}, motion.axis, motion.velocity, motion.factor}, left = taken;
  for (const auto point : motion.points) (chosen[point] ? taken : left).points.push_back(point);
  motion = std::move(left);
  return taken;
}

}  // namespace

Continuum::Continuum(std::unique_ptr<Zones> zones, std::span<const double> masses, std::vector<Load> loads,
                     std::vector<Motion> motions)
    : zones_(std::move(zones)), points_(masses.size()) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    points_[kMass][i] = masses[i];
    points_[kInverseMassX][i] = points_[kInverseMassY][i] = 1 / masses[i];
  }
  const auto runs = zones_->runs();
  interior_.runs.assign(runs.begin(), runs.end());
  interior_.points.push_back({0, static_cast<std::uint32_t>(masses.size())});
  place(std::move(loads));
  for (auto& motion : motions) {
    for (const auto point : motion.points)
      points_[motion.axis == Axis::kX ? kInverseMassX : kInverseMassY][point] = 0;
    interior_.motions.push_back(prescribed(std::move(motion)));
  }
}

// Gives each part what acts on its points.
void Continuum::place(std::vector<Load> loads) {
  std::vector<bool> chosen(points_.rows(), false);
  for (const auto [begin, end] : interface_.points)
    std::fill(chosen.begin() + begin, chosen.begin() + end, true);
  for (auto& load : loads) {
    Load taken = take(load, chosen);
    if (!taken.points.empty()) interface_.loads.push_back({std::move(taken)});
    if (!load.points.empty()) interior_.loads.push_back({std::move(load)});
  }
}

Continuum::Prescribed Continuum::prescribed(Motion motion) const {
  double mass = 0;
  for (const auto point : motion.points) mass += points_[kMass][point];
  return {std::move(motion), mass};
}

void Continuum::set_interface(std::span<const std::uint32_t> points) {
  std::vector<bool> chosen(points_.rows(), false);
  for (const auto point : points) chosen[point] = true;
  auto [touching, others] = split(zones_->runs(), chosen);
  interface_.runs = std::move(touching);
  interior_.runs = std::move(others);
  interface_.points = protocol::stretches(chosen, true);
  interior_.points = protocol::stretches(chosen, false);
  std::vector<Load> loads;
  for (auto& loading : interior_.loads) loads.push_back(std::move(loading.load));
  interior_.loads.clear();
  place(std::move(loads));
  for (auto& inside : interior_.motions) {
    interface_.motions.push_back(prescribed(take(inside.motion, chosen)));
    inside = prescribed(std::move(inside.motion));
  }
  for (Part* part : {&interface_, &interior_}) {
    std::erase_if(part->motions, [](const Prescribed& one) { return one.motion.points.empty(); });
  }
}

void Continuum::push(std::uint32_t point, double x, double y) {
  points_[kVx][point] += points_[kInverseMassX][point] * x;
  points_[kVy][point] += points_[kInverseMassY][point] * y;
  if (points_[kInverseMassX][point] == 0) hold(Axis::kX, point, x);
  if (points_[kInverseMassY][point] == 0) hold(Axis::kY, point, y);
}

// The impulse on a component that does not yield is taken up by the reaction of its motion, which was found
// at the last step without it.
void Continuum::hold(Axis axis, std::uint32_t point, double impulse) {
  for (Part* part : {&interface_, &interior_})
    for (auto& prescribed : part->motions) {
      if (prescribed.motion.axis != axis || !std::ranges::binary_search(prescribed.motion.points, point))
        continue;
      const double force = impulse / last_kick_;
      prescribed.reaction -= force;
      external_work_ -= last_dt_ * prescribed.before * force / 2;
    }
}

void Continuum::step(const protocol::Step& step, Energies* wanted) {
  pull(interface_, step);
  pull(interior_, step);
  if (wanted) *wanted = energies(step);
  move_and_predict(interface_, step);
  move_and_predict(interior_, step);
}

void Continuum::step_interface(const protocol::Step& step) {
  pull(interface_, step);
  move_and_predict(interface_, step);
}

void Continuum::step_interior(const protocol::Step& step) {
  pull(interior_, step);
  move_and_predict(interior_, step);
}

void Continuum::pull(Part& part, const protocol::Step& step) {
  zones_->add_forces(part.runs, step.dt,
                     {points_[kVx].data(), points_[kVy].data(), points_[kFx].data(), points_[kFy].data()});
  apply_loads(part, step);
  find_reactions(part, step);
}

void Continuum::apply_loads(Part& part, const protocol::Step& step) {
  const auto vx = points_[kVx], vy = points_[kVy], fx = points_[kFx], fy = points_[kFy];
  for (auto& [load, last_factor] : part.loads) {
    const double factor = load.factor(step.time());
    double power = 0;  // of the unit load
    for (std::size_t i = 0; i < load.points.size(); ++i) {
      const auto point = load.points[i];
      power += load.fx[i] * vx[point] + load.fy[i] * vy[point];
      fx[point] += factor * load.fx[i];
      fy[point] += factor * load.fy[i];
    }
    if (!step.from_rest()) external_work_ += step.dt * power * (last_factor + factor) / 2;
    last_factor = factor;
  }
}

// The reaction of a motion is what it adds to the other forces: R = m (v(n+1/2) - v(n-1/2))/dt - f.
void Continuum::find_reactions(Part& part, const protocol::Step& step) {
  for (auto& prescribed : part.motions) {
    const auto& motion = prescribed.motion;
    const auto force = points_[motion.axis == Axis::kX ? kFx : kFy];
    const double next = step.relax ? 0 : motion.velocity * motion.factor(step.half_time());
    prescribed.before = step.from_rest() ? -next : prescribed.after;
    prescribed.after = next;
    double reaction = prescribed.mass * (next - prescribed.before) / step.dt;
    for (const auto point : motion.points) reaction -= force[point];
    if (!step.from_rest())
      external_work_ += step.dt * prescribed.before * (prescribed.reaction + reaction) / 2;
    prescribed.reaction = reaction;
  }
}

Energies Continuum::energies(const protocol::Step& step) const {
  const auto product = [&](std::span<const double> v, std::span<const double> f,
                           std::span<const double> inverse_mass, std::size_t i) {
    const double kick = step.dt * inverse_mass[i] * f[i];
    return step.from_rest() ? -kick * kick / 4 : v[i] * (v[i] + kick);  // v(n-1/2) v(n+1/2)
  };
  double twice = 0;
  for (std::size_t i = 0; i < points_.rows(); ++i)
    twice += points_[kMass][i] * (product(points_[kVx], points_[kFx], points_[kInverseMassX], i) +
                                  product(points_[kVy], points_[kFy], points_[kInverseMassY], i));
  for (const Part* part : {&interface_, &interior_})
    for (const auto& p : part->motions)  // the loop above took v(n-1/2)^2 of them, and 0 at step 0
      twice += p.mass * (p.before * p.after - (step.from_rest() ? 0 : p.before * p.before));
  return {twice / 2, zones_->strain_energy(), external_work_};
}

void Continuum::move_and_predict(const Part& part, const protocol::Step& step) {
  const double dt = step.dt, kick = step.kick();
  const auto axis = [this, &part, dt, kick](Column displacement, Column velocity, Column force,
                                            Column inverse_mass) {
    double *u = points_[displacement].data(), *v = points_[velocity].data(), *f = points_[force].data();
    const double* inverse = points_[inverse_mass].data();
    for (const auto [begin, end] : part.points) {
#pragma GCC ivdep
      for (std::size_t i = begin; i < end; ++i) {
        u[i] += dt * v[i];
        v[i] += kick * (inverse[i] * f[i]);
        f[i] = 0;
      }
    }
  };
  axis(kUx, kVx, kFx, kInverseMassX);
  axis(kUy, kVy, kFy, kInverseMassY);
  for (const auto& prescribed : part.motions) {
    const auto velocity = points_[prescribed.motion.axis == Axis::kX ? kVx : kVy];
    for (const auto point : prescribed.motion.points) velocity[point] = prescribed.after;
  }
  last_dt_ = dt;
  last_kick_ = kick;
}

void Continuum::stop() {
  for (const Column column : {kVx, kVy}) std::ranges::fill(points_[column], 0.0);
}

void Continuum::start_over() {
  stop();
  external_work_ = 0;
}

void Continuum::reset_displacements() {
  for (const Column column : {kUx, kUy}) std::ranges::fill(points_[column], 0.0);
}

std::optional<std::uint32_t> Continuum::first_non_finite() const {
  const auto vx = points_[kVx], vy = points_[kVy];
  for (std::size_t i = 0; i < points_.rows(); ++i)
    if (!std::isfinite(vx[i]) || !std::isfinite(vy[i])) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

}  // namespace adit::fdm
