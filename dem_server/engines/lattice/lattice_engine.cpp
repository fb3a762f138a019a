#include "dem_server/engines/lattice/lattice_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/packing/meeting_place.hpp"
#include "dem_server/packing/useful_threads.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

// From the first to the second of two particles where they are now.
struct Facing {
  double nx, ny, gap;
};
Facing facing(const Particles& p, std::uint32_t i, std::uint32_t j) {
  const double dx = (p.x[j] - p.x[i]) + (p.ux[j] - p.ux[i]), dy = (p.y[j] - p.y[i]) + (p.uy[j] - p.uy[i]);
  const double length = std::hypot(dx, dy);
  return {dx / length, dy / length, length - p.radius[i] - p.radius[j]};
}

}  // namespace

LatticeEngine::LatticeEngine(const Model& model, std::size_t threads)
    : LocalEngine(model),
      team_(threads > 0 ? threads : useful_threads(model.discs.size())),
      law_(model.contact_bonds[model.bonds.front().number]),
      assembly_(assemble(model)),
      contacts_(assembly_),
      tied_(model.discs.size(), false) {
  interior_.loads = Loads(model, assembly_.particles);
  assembly_.gravity = interior_.loads.take_gravity(assembly_.particles);
  interior_.motions = PrescribedMotions(model, assembly_.particles);
  plan();
}

CriticalElement LatticeEngine::critical_element() const {
  return dem::critical_element(assembly_, law_.stiffness);
}

const protocol::InterfaceOperator& LatticeEngine::tie(std::span<const double> places) {
  const protocol::InterfaceOperator& n = tie_particles(places, ends_of(assembly_.bonds), interior_.motions);
  for (const std::uint32_t i : tied()) tied_[i] = true;
  // Loads and motions follow their particles, because the velocities of tied ones are complete before the
  // interior is computed.
  interface_.loads = interior_.loads.take(tied_);
  interface_.motions = interior_.motions.take(tied_, assembly_.particles);
  plan();
  return n;
}

void LatticeEngine::plan() {
  const std::size_t size = assembly_.particles.size();
  std::vector<bool> pulled(size, false);  // by others than bonds
  for (Part* part : {&interface_, &interior_}) {
    part->loads.mark(pulled);
    part->motions.mark(pulled);
    part->pairs.clear();
  }
  const auto [touching, others] = split(assembly_.bonds.runs, tied_);
  std::vector<bool> reached = tied_;
  for (const Run& run : touching)
    for (std::uint32_t k = 0; k < run.count; ++k) reached[run.first + k] = reached[run.second + k] = true;
  for (const Pair& pair : contacts_.pairs()) {
    const bool touches = tied_[pair.first] || tied_[pair.second];
    (touches ? interface_ : interior_).pairs.push_back(pair);
    for (const std::uint32_t i : {pair.first, pair.second}) {
      pulled[i] = true;
      if (touches) reached[i] = true;
    }
  }

  std::vector<Role> of_interface(size, Role::kForeign), of_interior = of_interface;
  for (std::size_t i = 0; i < size; ++i)
    if (tied_[i])
      of_interface[i] = pulled[i] ? Role::kKept : Role::kSwept;
    else
      of_interior[i] = pulled[i] || reached[i] ? Role::kKept : Role::kSwept;
  // The interface moves all particles that its bonds and contacts reach, the interior all others, so that
  // each moves once.
  interface_.sweep = {touching, of_interface, reached, team_.threads()};
  reached.flip();
  interior_.sweep = {others, of_interior, reached, team_.threads()};
}

void LatticeEngine::step_interface(const protocol::Step& step) {
  begin(step);
  result_ = {};
  speed_ = 0;
  broken_.clear();
  // A new list changes which particles others than bonds pull on, hence the roles in the sweeps.
  if (contacts_.update(step.dt, assembly_)) plan();
  pull(step, interface_);
  predict(step, interface_);
}

void LatticeEngine::step_interior(const protocol::Step& step) {
  pull(step, interior_);
  predict(step, interior_);
  released_ += result_.released;
  contacts_.moved(step.dt, speed_);
  cracks_.clear();
  for (const std::uint32_t bond : broken_) {
    const std::uint32_t i = assembly_.bonds.first[bond], j = assembly_.bonds.second[bond];
    Crack crack = crack_between(assembly_.particles, i, j, 0, assembly_.bonds.state[bond]);
    std::tie(crack.group_a, crack.group_b) = std::minmax({group()[i], group()[j]});
    cracks_.push_back(crack);
  }
}

void LatticeEngine::pull(const protocol::Step& step, Part& part) {
  speed_ = std::max(speed_, part.sweep.run(team_, law_, step, assembly_, result_, broken_));
  add_contacts(law_.stiffness.normal, assembly_.bonds.rest_length, part.pairs, assembly_.particles,
               resultants_of(assembly_.particles));
  if (!std::isfinite(result_.max_normal_force)) {
    const auto [force, x, y] = strongest();
    throw protocol::Unstable(fmt::format(
        "step {}: the normal force of the bond at ({:.6g}, {:.6g}) m is {} N; reduce time.dt_factor",
        step.number, x, y, force));
  }
  part.loads.apply(step, assembly_.particles);
}

void LatticeEngine::predict(const protocol::Step& step, Part& part) {
  part.sweep.predict(team_, step, assembly_.particles);
  part.motions.impose(step, assembly_.particles);
}

Strongest LatticeEngine::strongest() const {
  const Bonds& b = assembly_.bonds;
  const auto [x, y] =
      meeting_place(assembly_.particles, b.first[result_.strongest_bond], b.second[result_.strongest_bond]);
  return {result_.max_normal_force, x, y};
}

Energies LatticeEngine::energies(const protocol::Step& step) {
  const double bonds = strain_of_bonds(),
               contacts = contact_energy(law_.stiffness.normal, assembly_.bonds.rest_length,
                                         contacts_.pairs(), assembly_.particles);
  Energies energies;
  energies.kinetic =
      kinetic_energy_of(step, interface_.motions.kinetic_energy() + interior_.motions.kinetic_energy());
  energies.strain = bonds + contacts;
  energies.released = released_;
  energies.external_work = work_of_gravity() - gravity_in_statics_;
  for (const Part* part : {&interface_, &interior_})
    energies.external_work +=
        part->loads.work().forces + part->loads.work().accelerations + part->motions.work();
  return energies;
}

double LatticeEngine::work_of_gravity() const {
  const Particles& p = assembly_.particles;
  const auto [x, y] = assembly_.gravity;
  if (x == 0 && y == 0) return 0;
  double work = 0;
  for (std::size_t i = 0; i < p.size(); ++i) work += p.mass[i] * (x * p.ux[i] + y * p.uy[i]);
  return work;
}

double LatticeEngine::strain_of_bonds() {
  std::array<double, 64> parts{};  // as many whoever computes them
  const std::span<const Run> runs = assembly_.bonds.runs;
  team_.run(parts.size(), [&](std::size_t part, std::size_t) {
    const std::size_t begin = runs.size() * part / parts.size(),
                      end = runs.size() * (part + 1) / parts.size();
    parts[part] = strain_energy(law_, runs.subspan(begin, end - begin), assembly_.particles, assembly_.bonds);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

void LatticeEngine::start_over(const protocol::Drift& drift) {
  LocalEngine::start_over(drift);
  released_ = 0;
  gravity_in_statics_ = work_of_gravity();
  for (Part* part : {&interface_, &interior_}) {
    part->loads.start_over();
    part->motions.start_over();
  }
}

void LatticeEngine::exchange(state::Archive& archive) {
  LocalEngine::exchange(archive);
  assembly_.bonds.exchange(archive);
  contacts_.exchange(archive);
  for (Part* part : {&interface_, &interior_}) {
    part->loads.exchange(archive);
    part->motions.exchange(archive);
  }
  archive("released", released_);
  archive("gravity_in_statics", gravity_in_statics_);
  if (!archive.reads()) return;
  for (const Pair& pair : contacts_.pairs())
    state::require_below(std::array{pair.first, pair.second}, assembly_.particles.size(), "contact_pairs");
  plan();
}

std::vector<double> LatticeEngine::normal_forces() const {
  std::vector<double> normal(assembly_.bonds.size());
  find_normal_forces(law_, assembly_.particles, assembly_.bonds, normal);
  return normal;
}

double LatticeEngine::internal_force() const {
  return dem::internal_force(law_, assembly_.particles, assembly_.bonds);
}

void LatticeEngine::for_each_bond(const SeePair& see) const {
  std::vector<std::uint32_t> all(assembly_.bonds.size());
  std::iota(all.begin(), all.end(), 0u);
  see_bonds(all, see);
}

void LatticeEngine::see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const {
  const Particles& p = assembly_.particles;
  const Bonds& b = assembly_.bonds;
  const auto normal = normal_forces();
  for (const std::uint32_t k : bonds) {
    const std::uint32_t i = b.first[k], j = b.second[k];
    const auto [nx, ny, gap] = facing(p, i, j);
    see({i, j, nx, ny, normal[k], b.shear_force[k], 0, b.weight[k], b.state[k], normal[k] < 0});
  }
}

void LatticeEngine::for_each_contact(const SeePair& see) const {
  const Particles& p = assembly_.particles;
  for (const Pair& pair : contacts_.pairs()) {
    const auto [nx, ny, gap] = facing(p, pair.first, pair.second);
    if (gap < 0)
      see({pair.first, pair.second, nx, ny, contact_normal_force(law_.stiffness.normal, gap), 0, 0,
           (p.weight[pair.first] + p.weight[pair.second]) / 2});
  }
}

}  // namespace adit::dem
