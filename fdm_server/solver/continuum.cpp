#include "fdm_server/solver/continuum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "protocol/ground/imposed.hpp"
#include "protocol/kernels/sums.hpp"

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
PrescribedMotion take(PrescribedMotion& motion, const std::vector<bool>& chosen) {
  PrescribedMotion left = motion;
  left.points.clear();
  PrescribedMotion taken = left;
  for (const auto point : motion.points) (chosen[point] ? taken : left).points.push_back(point);
  motion = std::move(left);
  return taken;
}

}  // namespace

Continuum::Continuum(ZoneSet zones, std::span<const double> masses, std::vector<Load> loads,
                     std::vector<PrescribedMotion> motions, std::size_t threads, Structures structures,
                     Contacts contacts)
    : zones_(std::move(zones)),
      structures_(std::move(structures)),
      contacts_(std::move(contacts)),
      points_(masses.size()),
      team_(threads),
      structures_step_(structures_.critical_step()) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    points_[kMass][i] = masses[i];
    points_[kInverseMassX][i] = points_[kInverseMassY][i] = masses[i] > 0 ? 1 / masses[i] : 0;
  }
  zones_.follow(points_[kUx].data(), points_[kUy].data());
  contacts_.take_stress([this](std::uint32_t zone) { return zones_.stress(zone); },
                        [this](std::uint32_t zone) { return zones_.water_pressure(zone); });
  place(std::move(loads));
  for (auto& motion : motions) {
    for (const auto point : motion.points)
      points_[motion.axis == Axis::kX ? kInverseMassX : kInverseMassY][point] = 0;
    interior_.motions.push_back(prescribed(std::move(motion)));
  }
  plan(std::vector<bool>(masses.size(), false));
}

void Continuum::add_steady(const Load& load) {
  steady_ = true;
  for (std::size_t i = 0; i < load.points.size(); ++i) {
    points_[kSteadyX][load.points[i]] += load.fx[i];
    points_[kSteadyY][load.points[i]] += load.fy[i];
  }
}

// Gives each part what acts on its points.
void Continuum::place(std::vector<Load> loads) {
  const auto chosen = of_interface();
  for (auto& load : loads) {
    if (!load.factor) {
      add_steady(load);
      continue;
    }
    Load taken = take(load, chosen);
    if (!taken.points.empty()) interface_.loads.push_back({std::move(taken)});
    if (!load.points.empty()) interior_.loads.push_back({std::move(load)});
  }
}

std::vector<bool> Continuum::of_interface() const {
  std::vector<bool> chosen(points_.size(), false);
  for (const auto [begin, end] : interface_.points)
    std::fill(chosen.begin() + begin, chosen.begin() + end, true);
  return chosen;
}

Continuum::Prescribed Continuum::prescribed(PrescribedMotion motion) const {
  double mass = 0;
  for (const auto point : motion.points) mass += points_[kMass][point];
  return {std::move(motion), mass};
}

void Continuum::set_dashpots(std::vector<Dashpot> dashpots, bool support) {
  interior_.dashpots = std::move(dashpots);
  supports_ = support;
  plan(std::vector<bool>(points_.size(), false));
}

void Continuum::set_damping(const DampingLaw& law) {
  damping_ = Damping(law, points_.size());
}

void Continuum::set_foundations(std::vector<foundation::Springs> foundations) {
  interior_.foundations = std::move(foundations);
  plan(std::vector<bool>(points_.size(), false));
}

void Continuum::set_flow(Flow flow) {
  flow_ = std::move(flow);
  excess_.assign(zones_.count(), 0.0);
  inflow_.assign(zones_.count(), 0.0);
}

void Continuum::set_interface(std::span<const std::uint32_t> points) {
  std::vector<bool> chosen(points_.size(), false);
  for (const auto point : points) chosen[point] = true;
  for (const auto& dashpot : interior_.dashpots)  // which need the column's velocity
    if (dashpot.field && chosen[dashpot.point]) chosen[dashpot.field->column_point] = true;
  plan(chosen);
  damping_.tie(points);
  auto& dashpots = interior_.dashpots;
  const auto inside = std::stable_partition(dashpots.begin(), dashpots.end(),
                                            [&](const Dashpot& dashpot) { return !chosen[dashpot.point]; });
  interface_.dashpots.assign(inside, dashpots.end());
  dashpots.erase(inside, dashpots.end());
  for (const Dashpot& dashpot : interface_.dashpots)
    if (dashpot.hold_x || dashpot.hold_y) held_[dashpot.point] = {dashpot.hold_x, dashpot.hold_y};
  tie_x_.assign(points_.size(), 0.0);
  tie_y_.assign(points_.size(), 0.0);
  for (auto& springs : interior_.foundations) {
    springs.tie(points);
    if (auto taken = springs.take(chosen); !taken.empty()) interface_.foundations.push_back(std::move(taken));
  }
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

// Before loads, motions and dashpots are divided.
void Continuum::plan(const std::vector<bool>& chosen) {
  std::vector<bool> pulled(points_.size(), false);  // by others than zones
  for (const Part* part : {&interface_, &interior_}) {
    for (const auto& [load, factor] : part->loads)
      for (const auto point : load.points) pulled[point] = true;
    for (const auto& one : part->motions)
      for (const auto point : one.motion.points) pulled[point] = true;
    for (const auto& dashpot : part->dashpots) {
      pulled[dashpot.point] = true;
      if (dashpot.field) pulled[dashpot.field->column_point] = true;
    }
    for (const auto& springs : part->foundations) springs.mark(pulled);
  }
  structures_.mark_points(pulled);
  contacts_.mark_points(pulled);
  average_.reset();
  interior_.structures = structures_.standing();
  interface_.structures = structures_.take(interior_.structures, chosen);
  interior_.contacts = contacts_.standing();
  interface_.contacts = contacts_.take(interior_.contacts, chosen);

  interface_.points = protocol::index_ranges(chosen, true);
  interior_.points = protocol::index_ranges(chosen, false);
  const auto [touching, others] = split(zones_.runs(), chosen);
  std::vector<bool> reached = chosen;
  for (const ZoneRun& run : touching)
    for (const auto point : run.points)
      for (std::uint32_t k = 0; k < run.count; ++k) reached[point + k] = true;

  std::vector<bool> in_zones(points_.size(), false);
  for (const ZoneRun& run : zones_.runs())
    for (const auto point : run.points)
      for (std::uint32_t k = 0; k < run.count; ++k) in_zones[point + k] = true;
  std::vector<Role> of_interface(points_.size(), Role::kForeign), of_interior = of_interface;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (chosen[i])
      of_interface[i] = pulled[i] || !in_zones[i] ? Role::kKept : Role::kSwept;
    else
      of_interior[i] = pulled[i] || reached[i] || !in_zones[i] ? Role::kKept : Role::kSwept;
  for (auto [part, roles] : {std::pair{&interface_, &of_interface}, {&interior_, &of_interior}}) {
    std::vector<bool> kept(points_.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = (*roles)[i] == Role::kKept;
    part->kept = protocol::index_ranges(kept, true);
  }
  interface_.sweep = {touching, of_interface, reached, team_.threads()};
  reached.flip();
  interior_.sweep = {others, of_interior, reached, team_.threads()};
}

// What statics hold does not yield to multipliers either: they are a part of what its support bears.
void Continuum::push(std::uint32_t point, double x, double y) {
  if (!tie_x_.empty()) {
    tie_x_[point] = x / last_kick_;
    tie_y_[point] = y / last_kick_;
  }
  const auto [held_x, held_y] = relaxes_ ? held_in_statics(point) : std::array{false, false};
  if (held_x) x = 0;
  if (held_y) y = 0;
  points_[kVx][point] += points_[kInverseMassX][point] * x;
  points_[kVy][point] += points_[kInverseMassY][point] * y;
  if (points_[kInverseMassX][point] == 0) hold(Axis::kX, point, x);
  if (points_[kInverseMassY][point] == 0) hold(Axis::kY, point, y);
}

std::array<bool, 2> Continuum::held_in_statics(std::uint32_t point) const {
  const auto found = held_.find(point);
  return found == held_.end() ? std::array{false, false} : found->second;
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

PointArrays Continuum::arrays(const protocol::Step& step) {
  return {points_[kUx].data(),
          points_[kUy].data(),
          points_[kVx].data(),
          points_[kVy].data(),
          points_[kFx].data(),
          points_[kFy].data(),
          points_[kMass].data(),
          points_[kInverseMassX].data(),
          points_[kInverseMassY].data(),
          steady_ ? points_[kSteadyX].data() : nullptr,
          steady_ ? points_[kSteadyY].data() : nullptr,
          step.local_damping,
          tie_x_.data(),
          tie_y_.data()};
}

void Continuum::step(const protocol::Step& step, Energies* wanted) {
  if (wanted) remember_velocities();
  pull(interface_, step);
  pull(interior_, step);
  predict(interface_, step);
  predict(interior_, step);
  if (step.relax) ++step_of_stage_;
  if (wanted) *wanted = energies(step);
  flow(step);
}

void Continuum::step_interface(const protocol::Step& step) {
  pull(interface_, step);
  predict(interface_, step);
}

void Continuum::step_interior(const protocol::Step& step) {
  pull(interior_, step);
  predict(interior_, step);
  if (step.relax) ++step_of_stage_;
  flow(step);
}

// Of the pressures that this step ends with, into the next one.
void Continuum::flow(const protocol::Step& step) {
  if (!flow_ || step.relax) return;
  zones_.read_excess(team_, excess_);
  flow_->step(team_, step.dt, excess_, inflow_);
  zones_.set_inflow(team_, inflow_);
}

void Continuum::pull(Part& part, const protocol::Step& step) {
  if (step.local_damping > 0 && !damps_) {  // which counts the multipliers from its own first step on
    tie_x_.assign(points_.size(), 0.0);
    tie_y_.assign(points_.size(), 0.0);
  }
  damps_ = step.local_damping > 0;
  zones_.set_time(step.time());
  const bool average_here = &part == &interior_ && averages(step);
  const bool slides = &part == &interior_ && contacts_.slides();
  if (average_here && !slides && (!average_ || average_->dt() != step.dt)) plan_average(step.dt);
  const PointArrays points = arrays(step);
  damped_ += part.sweep.run(team_, zones_, step, points, damping_);
  if (slides) {
    contacts_.find_feet(step, points_[kUx], points_[kUy], points_[kVx], points_[kVy]);
    if (average_here) plan_average(step.dt);  // with the partners of now
  }
  if (damping_.acts()) damping_.add_viscous(part.kept, step, points);  // before any force but the zones'
  structures_.add_forces(part.structures, step.dt, {points.vx, points.vy, points.fx, points.fy});
  if (zones_.any_water())
    external_work_ += contacts_.push_apart(part.contacts, step,
                                           [this](std::uint32_t zone) { return zones_.water_pressure(zone); },
                                           {points.vx, points.vy, points.fx, points.fy});
  contacts_.add_forces(average_here ? moving_contacts_ : part.contacts, step.dt,
                       {points.vx, points.vy, points.fx, points.fy});
  apply_loads(part, step);
  for (foundation::Springs& springs : part.foundations) springs.pull(step, motion(springs));
  add_boundary_forces(part.dashpots, supports_, damping_.law(), step, zones_, points, boundary_work_);
  for (foundation::Springs& springs : part.foundations) springs.brake(step, motion(springs));
  if (damping_.acts()) damped_ += damping_.add_others(part.kept, step, points);
  find_motions(part, step);
  if (average_here) average_structures(step);
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

foundation::PointMotion Continuum::motion(const foundation::Springs& springs) {
  const bool x = springs.direction() == foundation::Direction::kX;
  return {points_[x ? kVx : kVy].data(), points_[x ? kInverseMassX : kInverseMassY].data(),
          points_[x ? kFx : kFy].data()};
}

void Continuum::find_motions(Part& part, const protocol::Step& step) {
  for (Prescribed& one : part.motions) {
    const double next = step.relax ? velocity_in_statics(one, step)
                                   : one.motion.velocity * one.motion.factor(step.half_time());
    one.before = step.from_rest() ? -next : one.after;
    one.after = next;
  }
}

// What the points have moved is measured, because stops and slowing take their velocities, too.
double Continuum::velocity_in_statics(Prescribed& one, const protocol::Step& step) const {
  const PrescribedMotion& motion = one.motion;
  if (motion.displacement == 0 || motion.stage != stage_ || motion.points.empty()) return 0;
  const auto velocity = points_[motion.axis == Axis::kX ? kVx : kVy];
  if (!step.from_rest()) one.moved += step.dt * velocity[motion.points.front()];
  return (motion.displacement * protocol::imposed_share(step_of_stage_ + 1) - one.moved) / step.dt;
}

// The reaction of a motion is what it adds to the other forces: R = m (v(n+1/2) - v(n-1/2))/dt - f. From rest
// the points come to their velocity at once, without the half step before the start that mirrors the one
// after it: the energy that they get is 1/2 m v^2, not twice as much.
void Continuum::find_reactions(Part& part, const protocol::Step& step) {
  for (auto& prescribed : part.motions) {
    const auto& motion = prescribed.motion;
    const auto force = points_[motion.axis == Axis::kX ? kFx : kFy];
    const double before = step.from_rest() ? 0 : prescribed.before;
    double reaction = prescribed.mass * (prescribed.after - before) / step.dt;
    for (const auto point : motion.points) reaction -= force[point];
    if (!step.from_rest())
      external_work_ += step.dt * prescribed.before * (prescribed.reaction + reaction) / 2;
    prescribed.reaction = reaction;
  }
}

void Continuum::remember_velocities() {
  std::ranges::copy(points_[kVx], points_[kLastVx].begin());
  std::ranges::copy(points_[kVy], points_[kLastVy].begin());
}

// Since the displacements were 0.
double Continuum::steady_work() const {
  if (!steady_) return 0;
  double work = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    work += points_[kSteadyX][i] * points_[kUx][i] + points_[kSteadyY][i] * points_[kUy][i];
  return work;
}

double Continuum::twice_kinetic_energy_of_points(const protocol::Step& step) {
  const double sign = step.from_rest() ? -1 : 1;
  const std::span<const double> mass = points_[kMass], vx = points_[kVx], vy = points_[kVy],
                                last_vx = step.from_rest() ? vx : points_[kLastVx],
                                last_vy = step.from_rest() ? vy : points_[kLastVy];
  std::array<double, 64> parts{};  // as many whoever computes them
  team_.run(parts.size(), [&](std::size_t part, std::size_t) {
    parts[part] = protocol::eight_sums(
        mass.size() * part / parts.size(), mass.size() * (part + 1) / parts.size(),
        [&](std::size_t i) { return sign * (mass[i] * (last_vx[i] * vx[i] + last_vy[i] * vy[i])); });
  });
  double twice = std::accumulate(parts.begin(), parts.end(), 0.0);
  if (step.from_rest())  // v(-1/2) is 0 where a motion is prescribed (find_reactions)
    for (const Part* part : {&interface_, &interior_})
      for (const Prescribed& one : part->motions) twice += one.mass * one.after * one.after;
  return twice;
}

Energies Continuum::energies(const protocol::Step& step) {
  const double twice = structures_.twice_kinetic_energy(step) + twice_kinetic_energy_of_average(step) +
                       twice_kinetic_energy_of_points(step);
  Energies sum{twice / 2,
               zones_.strain_energy(team_) + structures_.strain_energy() + contacts_.strain_energy(),
               external_work_ + steady_work() + zones_.external_work() + boundary_work_.external,
               zones_.dissipated() + structures_.dissipated() + contacts_.dissipated() +
                   boundary_work_.dissipated + damped_};
  for (const Part* part : {&interface_, &interior_})
    for (const foundation::Springs& springs : part->foundations) {
      sum.strain += springs.stored();
      sum.external_work += springs.work();
      sum.dissipated += springs.dissipated();
    }
  return sum;
}

void Continuum::predict(const Part& part, const protocol::Step& step) {
  part.sweep.predict(team_, step.kick(), arrays(step));
  structures_.move_and_predict(part.structures, step);
  for (const auto& prescribed : part.motions) {
    const auto velocity = points_[prescribed.motion.axis == Axis::kX ? kVx : kVy];
    for (const auto point : prescribed.motion.points) velocity[point] = prescribed.after;
  }
  last_dt_ = step.dt;
  last_kick_ = step.kick();
  relaxes_ = step.relax;
}

void Continuum::slow(double factor) {
  for (const Field velocity : {kVx, kVy})
    for (double& value : points_[velocity]) value *= factor;
  structures_.slow(factor);
}

void Continuum::start_over() {
  stop();
  structures_.start_over();
  contacts_.start_over();
  external_work_ = damped_ = 0;
  boundary_work_ = {};
  for (Part* part : {&interface_, &interior_})
    for (foundation::Springs& springs : part->foundations) springs.start_over();
}

void Continuum::reset_displacements() {
  zones_.start_over();
  contacts_.reset_offsets();
  for (const Field displacement : {kUx, kUy}) std::ranges::fill(points_[displacement], 0.0);
}

void Continuum::exchange(state::Archive& archive) {
  zones_.exchange(archive);
  structures_.exchange(archive);
  contacts_.exchange(archive);
  points_.exchange(archive);
  damping_.exchange(archive);
  for (Part* part : {&interface_, &interior_}) {
    for (Loading& loading : part->loads) archive("load_factor", loading.factor);
    for (Prescribed& one : part->motions) {
      archive("prescribed_mass", one.mass);
      archive("prescribed_before", one.before);
      archive("prescribed_after", one.after);
      archive("prescribed_reaction", one.reaction);
      archive("prescribed_moved", one.moved);
    }
    archive.members("dashpots", std::span(part->dashpots), &Dashpot::origin, &Dashpot::settling,
                    &Dashpot::support, &Dashpot::stress, &Dashpot::viscous_x, &Dashpot::viscous_y,
                    &Dashpot::given, &Dashpot::drag);
    for (foundation::Springs& springs : part->foundations) springs.exchange(archive);
  }
  archive("boundary_work", boundary_work_);
  archive("steady", steady_);
  archive("external_work", external_work_);
  archive("damped", damped_);
  archive("last_dt", last_dt_);
  archive("last_kick", last_kick_);
  archive("step_of_stage", step_of_stage_);
  archive("damps", damps_);
  archive.all_or_none("ties", {&tie_x_, &tie_y_}, points_.size());
}

std::vector<std::uint32_t> Continuum::points_on_dashpots() const {
  std::set<std::uint32_t> found;
  for (const Part* part : {&interface_, &interior_})
    for (const Dashpot& dashpot : part->dashpots) found.insert(dashpot.point);
  return {found.begin(), found.end()};
}

Vector Continuum::drag(protocol::IndexRange points) const {
  const auto inside = [points](std::uint32_t point) { return points.begin <= point && point < points.end; };
  Vector sum;
  for (const Part* part : {&interface_, &interior_}) {
    for (const Dashpot& dashpot : part->dashpots) {
      if (!inside(dashpot.point)) continue;
      const Symmetric c = of_ground(dashpot);
      sum.x += c.xx;
      sum.y += c.yy;
    }
    for (const Prescribed& one : part->motions)
      if (std::ranges::any_of(one.motion.points, inside))
        (one.motion.axis == Axis::kX ? sum.x : sum.y) = std::numeric_limits<double>::infinity();
    for (const foundation::Springs& springs : part->foundations)
      if (springs.holds(points.begin, points.end))
        (springs.direction() == foundation::Direction::kX ? sum.x : sum.y) =
            std::numeric_limits<double>::infinity();
  }
  return sum;
}

void Continuum::settle(protocol::IndexRange points, const protocol::Drift& drift) {
  for (Part* part : {&interface_, &interior_})
    for (Dashpot& dashpot : part->dashpots) {
      if (dashpot.point < points.begin || dashpot.point >= points.end) continue;
      const Vector drag = of_ground(dashpot) * Vector{drift.x, drift.y};
      dashpot.settling = {-drag.x, -drag.y};
    }
}

std::optional<std::uint32_t> Continuum::first_non_finite() const {
  const auto vx = points_[kVx], vy = points_[kVy];
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!std::isfinite(vx[i]) || !std::isfinite(vy[i])) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

}  // namespace adit::fdm
