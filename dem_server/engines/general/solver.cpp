#include "dem_server/engines/general/solver.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "dem_server/engines/general/build_arrays.hpp"
#include "dem_server/particles/integrate.hpp"
#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
}

protocol::IndexRange range_of(std::uint32_t block, std::size_t discs) {
  return {block * kBlock, static_cast<std::uint32_t>(std::min<std::size_t>((block + 1) * kBlock, discs))};
}

// Twice the mean power [W] of the forces on some discs at the last step (`before`) and now; stores the latter
// in `before`.
ADIT_VECTOR_CLONES double power(const Particles& p, std::uint32_t begin, std::uint32_t end,
                                const Resultants& before) {
  const double *vx = p.vx.data(), *vy = p.vy.data(), *spin = p.spin.data();
  const double *fx = p.fx.data(), *fy = p.fy.data(), *moment = p.moment.data();
  double *before_x = before.fx, *before_y = before.fy, *before_moment = before.moment;
  return protocol::eight_sums(begin, end, [=](std::size_t i) {
    const double x = before_x[i] + fx[i], y = before_y[i] + fy[i], m = before_moment[i] + moment[i];
    before_x[i] = fx[i];
    before_y[i] = fy[i];
    before_moment[i] = moment[i];
    return vx[i] * x + vy[i] * y + spin[i] * m;
  });
}

// Each disc is held with the area of its cell.
std::vector<foundation::Springs> foundations_of(const Model& model) {
  std::vector<foundation::Springs> springs;
  for (const Foundation& given : model.foundations) {
    std::vector<foundation::HeldPoint> held;
    for (const std::uint32_t i : given.discs)
      held.push_back({i, model.weight[i] * model.cell_area(i), model.discs.x[i]});
    springs.emplace_back(given.direction, given.law, given.ground, held);
  }
  return springs;
}

}  // namespace

Solver::Solver(const Model& model, std::size_t threads)
    : particles_(at_rest(model)),
      springs_(model.springs),
      bars_(model.bars, particles_),
      foundations_(foundations_of(model)),
      local_damping_(model.local_damping),
      viscous_damping_(model.viscous_damping),
      edges_(model.edges),
      support_x_(edges_.size()),
      support_y_(edges_.size()),
      team_(std::make_unique<protocol::Team>(threads)),
      in_work_(threads),
      results_(blocks_of(particles_.size())) {
  Bonded bonded = bonds_of(model);
  take_laws(std::move(bonded.laws));
  bonds_ = std::move(bonded.bonds);
  bond_of_pair_ = std::move(bonded.bond_of_pair);
  joints_ = Joints(std::move(bonded.joints));
  facets_ = Facets(model, threads);
  cells_ = CellContacts(model, facets_.set(), particles_);
  neighbours_ = cells_.empty() ? Neighbours(particles_, model.discs.radius, pairs_of(model.bonds),
                                            model.group, model.groups(), bonded.first_contact_law,
                                            bonded.dashpots, model.overlaps_free, model.touching, laws_)
                               : Neighbours(particles_.size());
  walls_ = WallContacts(model.walls, cells_.polygons(), facets_.set(), particles_,
                        cells_.empty() ? neighbours_.skin() : cells_.skin(), model.overlaps_free);
  for (auto* pulled : {&pulled_x_, &pulled_y_, &pulled_moment_}) pulled->assign(particles_.size(), 0.0);
  strain_at_start_ = strain_energy().sum();
  renew_damping();
}

void Solver::tie(std::span<const std::uint32_t> discs) {
  tied_.assign(discs.begin(), discs.end());
  for (foundation::Springs& springs : foundations_) springs.tie(tied_);
  renew_damping();
}

// Masses and ties are others.
void Solver::renew_damping() {
  damping_ = Damping(local_damping_, viscous_damping_, edges_, particles_, tied_);
}

void Solver::take_laws(std::vector<PairLaw> laws) {
  laws_ = std::move(laws);
  static_laws_ = laws_;
  for (PairLaw& law : static_laws_) law.contact = without_dashpots(law.contact);
}

void Solver::step(const protocol::Step& step, Loads& loads, PrescribedMotions& motions) {
  const double dt = step.from_rest() ? 0 : step.dt;
  facets_.set_steps_per_second(step.relax || step.from_rest() ? 0 : 1 / step.dt);
  move(step);
  if (!planned_ || sweeps_ == damping_.acts_everywhere(step)) plan(step, loads, motions);
  sweep(step);
  facets_.end_step();
  if (!facets_.cracked().empty() || facets_.any_parted()) cells_.expose_more();
  joints_.add_forces(dt, particles_);
  springs_.add_forces(dt, particles_);
  bars_.add_forces(dt, *team_, particles_);
  cells_.add_forces(step, facets_.set(), particles_);
  walls_.add_forces(step, facets_.set(), particles_);
  gather(dt);
  loads.apply(step, particles_);
  for (foundation::Springs& springs : foundations_) springs.pull(step, motion(springs));
  support_held();
  support_edges(step.relax, dt);
  for (foundation::Springs& springs : foundations_) springs.brake(step, motion(springs));
  team_->run(results_.size(), [&](std::size_t block, std::size_t) {
    results_[block].loss = damping_.kick(step, discs_.kept[block], particles_);
  });
  motions.impose(step, particles_);
  walls_.drive(step);
  take_results(step.relax);
}

void Solver::displace(Loads& loads, PrescribedMotions& motions) {
  Damping none;
  std::swap(damping_, none);
  step({.number = 1, .dt = 1, .relax = true}, loads, motions);
  std::swap(damping_, none);
}

void Solver::plan(const protocol::Step& step, const Loads& loads, const PrescribedMotions& motions) {
  note_pulls();
  sweeps_ = !damping_.acts_everywhere(step);
  std::vector<bool> kept(particles_.size(), !sweeps_);
  for (const Pairs* pairs : {&bonds_, &neighbours_.pairs()})
    for (const std::uint32_t i : pairs->reached) kept[i] = true;
  for (const Joints::Joint& joint : joints_.joints()) kept[joint.first] = kept[joint.second] = true;
  for (const Spring& spring : springs_.springs()) kept[spring.first] = kept[spring.second] = true;
  for (std::size_t k = 0; k < bars_.size(); ++k)
    for (const BarNode& node : bars_.chain(k).bar().nodes) kept[node.disc] = true;
  for (const CellContacts::Contact& contact : cells_.contacts())
    kept[contact.first] = kept[contact.second] = true;
  for (const WallContacts::Near& near : walls_.near()) kept[near.disc] = true;
  for (const EdgeDashpot& edge : edges_) kept[edge.disc] = true;
  for (const Held& held : held_) kept[held.disc] = true;
  for (const foundation::Springs& springs : foundations_) springs.mark(kept);
  loads.mark(kept);
  motions.mark(kept);
  discs_ = SweptDiscs(kept);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (!kept[i]) {
      particles_.fx[i] = pulled_x_[i];
      particles_.fy[i] = pulled_y_[i];
      particles_.moment[i] = pulled_moment_[i];
    }
  planned_ = true;
}

// What pairs did at the last step becomes known of the swept discs, too.
void Solver::note_pulls() {
  for (std::uint32_t i = 0; i < discs_.swept.size(); ++i)
    if (discs_.swept[i] == 1) note_pull(i);
}

void Solver::note_pull(std::uint32_t i) {
  pulled_x_[i] = particles_.fx[i];
  pulled_y_[i] = particles_.fy[i];
  pulled_moment_[i] = particles_.moment[i];
}

void Solver::move(const protocol::Step& step) {
  if (step.from_rest()) return;
  team_->run(results_.size(), [&](std::size_t block, std::size_t) {
    const protocol::IndexRange discs = range_of(static_cast<std::uint32_t>(block), particles_.size());
    results_[block].fastest = adit::dem::move(step.dt, {&discs, 1}, particles_);
    facets_.turn(step.dt, discs, particles_.spin);
  });
  double fastest = 0;
  for (const BlockResult& result : results_) fastest = std::max(fastest, result.fastest);
  if (!update_contacts(step.dt, step.dt * std::sqrt(fastest), walls_.move(step))) return;
  walls_.list(particles_);
  planned_ = false;
}

bool Solver::update_contacts(double dt, double farthest, double farthest_wall) {
  if (!cells_.empty()) return cells_.update(dt, farthest_wall, facets_.set(), particles_);
  neighbours_.moved(farthest, farthest_wall);
  return neighbours_.update(particles_);
}

// Work is the trapezoid of the power of what pairs did at the last step and do now.
void Solver::sweep(const protocol::Step& step) {
  const double dt = step.from_rest() ? 0 : step.dt;
  const std::span<const PairLaw> laws = step.relax ? static_laws_ : laws_;
  team_->run(results_.size(), [&](std::size_t b, std::size_t thread) {
    const auto block = static_cast<std::uint32_t>(b);
    BlockDiscs& discs = in_work_[thread];
    if (bonds_.in_block(block) || neighbours_.pairs().in_block(block))
      discs.take(block, particles_);
    else
      discs.clear();
    add_pair_forces(block, laws, dt, step.relax, particles_, bonds_, discs, results_[b].bonds);
    add_pair_forces(block, laws, dt, step.relax, particles_, neighbours_.pairs(), discs,
                    results_[b].contacts);
    facets_.add_forces(block, thread, step.relax, particles_, discs);
    results_[b].work = dt / 2 * discs.give(block, step.kick(), discs_.swept, particles_);
  });
}

// What joints, springs, bars and walls do counts among the work of pairs.
void Solver::gather(double dt) {
  team_->run(results_.size(), [&](std::size_t b, std::size_t) {
    const auto block = static_cast<std::uint32_t>(b);
    gather_pair_forces(block, bonds_, particles_);
    gather_pair_forces(block, neighbours_.pairs(), particles_);
    results_[b].work += dt / 2 * power_of_kept(b);
  });
}

// The same for the kept discs of a block.
double Solver::power_of_kept(std::size_t block) {
  const Resultants before{pulled_x_.data(), pulled_y_.data(), pulled_moment_.data()};
  double sum = 0;
  for (const auto [begin, end] : discs_.kept[block]) sum += power(particles_, begin, end, before);
  return sum;
}

foundation::PointMotion Solver::motion(const foundation::Springs& springs) {
  Particles& p = particles_;
  if (springs.direction() == foundation::Direction::kX)
    return {p.vx.data(), p.inverse_mass.data(), p.fx.data()};
  return {p.vy.data(), p.inverse_mass.data(), p.fy.data()};
}

void Solver::support_held() {
  for (const Held& held : held_) {
    particles_.fx[held.disc] += held.x;
    particles_.fy[held.disc] += held.y;
    particles_.moment[held.disc] += held.moment;
  }
}

// In statics quiet edges are held; later what held them stays.
void Solver::support_edges(bool relax, double dt) {
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const std::uint32_t i = edges_[k].disc;
    if (relax) {
      support_x_[k] = -particles_.fx[i];
      support_y_[k] = -particles_.fy[i];
    }
    ledger_.support += dt * (support_x_[k] * particles_.vx[i] + support_y_[k] * particles_.vy[i]);
    particles_.fx[i] += support_x_[k];
    particles_.fy[i] += support_y_[k];
  }
}

void Solver::take_results(bool relax) {
  broken_.clear();
  double internal = 0;
  for (const BlockResult& result : results_) {
    ledger_.pairs += result.work;
    for (const PairResult* pulled : {&result.bonds, &result.contacts}) {
      ledger_.friction += pulled->friction;
      ledger_.dashpots += pulled->dashpots;
      ledger_.released += pulled->released;
      internal += pulled->internal_force;
    }
    ledger_.damping.local += result.loss.local;
    ledger_.damping.viscous += result.loss.viscous;
    ledger_.damping.edges += result.loss.edges;
    broken_.insert(broken_.end(), result.bonds.broken.begin(), result.bonds.broken.end());
  }
  if (relax) internal_of_pairs_ = internal;
  strongest_ = facets_.empty() ? find_strongest() : facets_.strongest(particles_);
}

Strongest Solver::find_strongest() const {
  const bool bonded = bonds_.size() > 0;
  const Pairs& pairs = bonded ? bonds_ : neighbours_.pairs();
  const PairResult* best = nullptr;
  for (const BlockResult& result : results_) {
    const PairResult& pulled = bonded ? result.bonds : result.contacts;
    if (bits_of_size(pulled.max_normal_force) > bits_of_size(best ? best->max_normal_force : 0))
      best = &pulled;
  }
  if (!best) return {};
  const std::uint32_t i = pairs.first[best->strongest], j = pairs.second[best->strongest];
  return {best->max_normal_force, (particles_.x[i] + particles_.x[j]) / 2,
          (particles_.y[i] + particles_.y[j]) / 2};
}

void Solver::start_over(const protocol::Drift& drift) {
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const double weight = particles_.weight[edges_[k].disc];
    support_x_[k] -= edges_[k].damping_x * weight * drift.x;
    support_y_[k] -= edges_[k].damping_y * weight * drift.y;
  }
  walls_.stop();
  ledger_ = {};
  walls_.start_over();
  springs_.start_over();
  bars_.start_over();
  for (foundation::Springs& springs : foundations_) springs.start_over();
  joints_.start_over();
  facets_.start_over();
  cells_.start_over();
  strain_at_start_ = strain_energy().sum();
}

void Solver::exchange(state::Archive& archive) {
  if (!archive.reads()) note_pulls();
  const std::size_t bonds = bonds_.size();
  bonds_.exchange(particles_.size(), laws_, archive);
  neighbours_.exchange(laws_, archive);
  joints_.exchange(archive);
  facets_.exchange(archive);
  cells_.exchange(archive);
  springs_.exchange(archive);
  bars_.exchange(archive);
  for (foundation::Springs& springs : foundations_) springs.exchange(archive);
  walls_.exchange(archive);
  damping_.exchange(archive);
  archive("support_x", std::span(support_x_));
  archive("support_y", std::span(support_y_));
  archive("held", held_);
  archive("pulled_x", std::span(pulled_x_));
  archive("pulled_y", std::span(pulled_y_));
  archive("pulled_moment", std::span(pulled_moment_));
  double internal = internal_of_pairs_.value_or(-1);
  archive("internal_of_pairs", internal);
  archive("ledger", ledger_);
  archive("strain_at_start", strain_at_start_);
  if (!archive.reads()) return;
  internal_of_pairs_ = internal >= 0 ? std::optional(internal) : std::nullopt;
  discs_ = {};
  planned_ = false;
  state::require_of_model(bonds_.size() == bonds && (bonds == 0 || bonds_.bonded()), "pairs");
  state::require_below(springs_.broken(), springs_.springs().size(), "springs_broken");
  for (const Held& held : held_) state::require_below(std::array{held.disc}, particles_.size(), "held");
  for (const WallContacts::Near& near : walls_.near()) {
    state::require_below(std::array{near.disc}, particles_.size(), "touches");
    state::require_below(std::array{near.wall}, walls_.size(), "touches");
  }
}

Stored Solver::stored() const {
  std::vector<Stored> of_blocks(results_.size());
  team_->run(of_blocks.size(), [&](std::size_t b, std::size_t thread) {
    const auto block = static_cast<std::uint32_t>(b);
    in_work_[thread].take(block, particles_);
    for (const Pairs* pairs : {&bonds_, &neighbours_.pairs()})
      add_stored(block, laws_, particles_, *pairs, in_work_[thread], of_blocks[b]);
  });
  Stored sum;
  for (const Stored& of_block : of_blocks) sum.add(of_block);
  sum.contacts += walls_.strain_energy() + cells_.strain_energy(particles_);
  return sum;
}

Solver::StrainEnergy Solver::strain_energy() const {
  return {stored(), facets_.strain_energy(particles_), joints_.strain_energy(), springs_.strain_energy(),
          bars_.strain_energy()};
}

double Solver::foundation_energy() const {
  double sum = 0;
  for (const foundation::Springs& springs : foundations_) sum += springs.stored();
  return sum;
}

double Solver::internal_force_of_pairs() const {
  double sum = 0;
  for (const Pairs* pairs : {&bonds_, &neighbours_.pairs()})
    for (std::uint32_t k = 0; k < pairs->size(); ++k) {
      const PairState s = state_of(k, laws_, particles_, *pairs);
      sum += pairs->weight[k] * std::hypot(s.bond_normal + s.contact_normal, s.shear);
    }
  return sum;
}

double Solver::internal_force() const {
  double sum = internal_of_pairs_ ? *internal_of_pairs_ : internal_force_of_pairs();
  sum += facets_.internal_force();
  for (const Joints::Joint& joint : joints_.joints())
    sum += joint.weight * std::hypot(joint.normal, joint.springs.shear);
  for (const double force : springs_.forces()) sum += std::abs(force);
  sum += bars_.internal_force();
  for (const CellContacts::Contact& contact : cells_.contacts())
    sum += cells_.weight(contact, particles_) * std::hypot(contact.touch.normal, contact.touch.shear);
  for (const WallContacts::Near& near : walls_.near()) sum += std::hypot(near.touch.normal, near.touch.shear);
  return sum;
}

DiscLedger Solver::ledger() const {
  DiscLedger ledger = ledger_;
  ledger.friction += walls_.friction() + joints_.friction() + cells_.friction();
  ledger.dashpots += walls_.dashpots() + cells_.dashpots();
  ledger.released += springs_.released();
  for (const foundation::Springs& springs : foundations_) {
    ledger.ground += springs.work();
    ledger.foundations += springs.dissipated();
  }
  return ledger;
}

double Solver::time_step_share(double strain_energy) const {
  const DiscLedger sum = ledger();
  return -sum.pairs + walls_.work() - (strain_energy - strain_at_start_) - sum.friction - sum.dashpots -
         sum.released - facets_.fracture() - bars_.dissipated();
}

}  // namespace adit::dem
