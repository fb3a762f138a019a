#include "dem_server/participant/participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "dem_server/engines/lattice/initial_stress.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/participant/crack.hpp"
#include "dem_server/participant/messages.hpp"
#include "dem_server/participant/snapshot.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

double selection_tolerance(const Rectangle& box) {
  return 1e-9 * std::max(box.x_max - box.x_min, box.y_max - box.y_min);
}

}  // namespace

void DemParticipant::set_up(const wire::Setup& setup, wire::Model& model) {
  started_ = std::clock();
  scene_ = setup.scene();
  packing_ = checked_packing(scene_);
  law_ = checked_bond_law(scene_);
  assembly_ = assemble(packing_, cell_mass(material_of(scene_).density(), packing_.radius));
  model.set_critical_dt(critical_step(assembly_, law_.stiffness));
  model.set_x_min(packing_.cells.x_min);
  model.set_x_max(packing_.cells.x_max);
  model.set_y_min(packing_.cells.y_min);
  model.set_y_max(packing_.cells.y_max);
  std::vector<double> points;
  points.reserve(2 * (packing_.x.size() + packing_.links.size()));
  for (std::size_t i = 0; i < packing_.x.size(); ++i)
    points.insert(points.end(), {packing_.x[i], packing_.y[i]});
  for (std::uint32_t k = 0; k < assembly_.bonds.size(); ++k) {
    const Place place = middle_of_bond(assembly_, k);
    points.insert(points.end(), {place.x, place.y});
  }
  assign(*model.mutable_sample_points(), points);
}

void DemParticipant::weigh(const wire::Weights& weights, wire::Interface& interface) {
  if (weights.weights_size() > 0) {
    assembly_ = assemble(packing_, cell_mass(material_of(scene_).density(), packing_.radius),
                         split_weights(weights, packing_.x.size(), packing_.links.size()));
    if (assembly_.bonds.size() == 0)
      throw protocol::UserError(
          "interface.overlap",
          "leaves no bonded particles, their weight being 0 everywhere; let the packing "
          "reach into the overlap and beyond it on the particles' own side");
    const auto offered = coupling_.offer(
        assembly_.particles, {weights.x_min(), weights.x_max(), weights.y_min(), weights.y_max()});
    assign(*interface.mutable_points(), offered);
  }
  if (scene_.has_initial_stress()) set_initial_stress(scene_.initial_stress(), law_.stiffness, assembly_);
  const Particles& particles = assembly_.particles;
  const double tolerance = selection_tolerance(packing_.cells);
  interior_.loads = Loads(scene_.particles(), particles, tolerance);
  interior_.motions = Motions(scene_.particles(), particles, tolerance);
  contacts_ = Contacts(assembly_);
  team_.emplace(threads_ > 0 ? threads_ : useful_threads(particles.size()));
  tied_.assign(particles.size(), false);
  plan();
  histories_.emplace(scene_.particles(), particles, std::vector(particles.size(), packing_.radius));
  interface.set_particles(particles.size());
  interface.set_bonds(assembly_.bonds.size());
}

void DemParticipant::couple(const wire::Couple& couple, wire::Operator& op) {
  coupling_.tie(view(couple.points()), assembly_.particles, assembly_.bonds, interior_.motions);
  coupling_.fill(op);
  for (const std::uint32_t i : coupling_.particles()) tied_[i] = true;
  histories_->tie(coupling_.particles());
  interface_.loads = interior_.loads.take(tied_);
  interface_.motions = interior_.motions.take(tied_, assembly_.particles);
  plan();
}

void DemParticipant::plan() {
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
  interface_.sweep = {touching, of_interface, reached, team_->threads()};
  reached.flip();
  interior_.sweep = {others, of_interior, reached, team_->threads()};
}

void DemParticipant::correct(std::span<const double> impulses) {
  if (impulses.empty()) return;
  check_impulses(impulses, coupling_.size(), step_);
  coupling_.push(impulses, assembly_.particles, interface_.motions);
}

void DemParticipant::relax(bool stop, wire::Relaxation& answer) {
  if (!relaxation_) relaxation_.emplace(assembly_.particles);
  find_normal_forces(law_, assembly_.particles, assembly_.bonds);
  answer.set_unbalanced_force(relaxation_->measure(assembly_.particles, step_.kick()));
  answer.set_internal_force(internal_force(assembly_.bonds));
  answer.set_points(assembly_.particles.size());
  answer.set_elements(assembly_.bonds.size());
  if (!stop) return;
  this->stop();
  relaxation_->stopped(assembly_.particles);
}

void DemParticipant::stop() {
  Particles& p = assembly_.particles;
  for (auto* velocity : {&p.vx, &p.vy, &p.spin}) std::ranges::fill(*velocity, 0.0);
}

void DemParticipant::start_over() {
  relaxation_.reset();
  stop();
  assembly_.particles.settled_x = assembly_.particles.ux;
  assembly_.particles.settled_y = assembly_.particles.uy;
  released_ = 0;
  for (Part* part : {&interface_, &interior_}) {
    part->loads.start_over();
    part->motions.start_over();
  }
}

void DemParticipant::advance(const wire::Advance& advance, wire::Predicted& predicted) {
  Particles& particles = assembly_.particles;
  correct(view(advance.impulses()));
  take_peaks();
  step_.dt = checked_dt(advance, step_.dt);
  if (relaxation_ && !advance.relax()) start_over();
  if (advance.relax()) relax(advance.stop(), *predicted.mutable_relaxation());
  step_ = {advance.step(), advance.dt(), advance.relax(), advance.stop()};
  rest_left_ =
      coupling_.size() > 0 && !advance.relax() && !advance.want_energies() && !advance.want_histories();
  result_ = {};
  speed_ = 0;
  broken_.clear();
  histories_->remember(particles);
  if (advance.want_peaks()) {
    if (!peaks_) peaks_.emplace(particles.size());
    peaks_->remember({particles.vx, particles.vy});
    peaks_due_ = true;
  }

  if (contacts_.update(step_.dt, assembly_)) plan();
  if (advance.want_energies()) remember(particles, before_);
  pull(interface_);
  if (!rest_left_) pull(interior_);
  predict(interface_);
  if (!rest_left_) {
    predict(interior_);
    close_step();
  }
  if (advance.want_histories()) histories_->read(particles, step_, *predicted.mutable_histories());

  predicted.set_step(step_.number);
  predicted.mutable_velocities()->Resize(static_cast<int>(2 * coupling_.size()), 0.0);
  coupling_.read_velocities(particles,
                            {predicted.mutable_velocities()->mutable_data(), 2 * coupling_.size()});
  predicted.mutable_cracks()->Swap(unreported_.mutable_cracks());
  predicted.mutable_strongest()->Swap(unreported_.mutable_strongest());
  if (advance.relax()) predicted.mutable_relaxation()->set_kinetic_energy(kinetic_energy(particles));
  if (advance.want_energies()) report_energies(*predicted.mutable_energies());
}

void DemParticipant::take_peaks() {
  if (!peaks_due_) return;
  peaks_due_ = false;
  const Particles& p = assembly_.particles;
  const auto displacement = [&p](std::size_t i) {
    return std::array{p.ux[i] - p.settled_x[i], p.uy[i] - p.settled_y[i]};
  };
  peaks_->take(displacement, {p.vx, p.vy}, step_);
}

void DemParticipant::complete() {
  if (!rest_left_) return;
  rest_left_ = false;
  pull(interior_);
  predict(interior_);
  close_step();
}

void DemParticipant::pull(Part& part) {
  speed_ = std::max(speed_, part.sweep.run(*team_, law_, step_, assembly_, result_, broken_));
  add_contacts(law_.stiffness.normal, assembly_.bonds.rest_length, part.pairs, assembly_.particles,
               resultants_of(assembly_.particles));
  if (!std::isfinite(result_.max_normal_force)) {
    const Place place = middle_of_bond(assembly_, result_.strongest_bond);
    throw protocol::Unstable(fmt::format(
        "step {}: the normal force of the bond at ({:.6g}, {:.6g}) m is {} N; reduce time.dt_factor",
        step_.number, place.x, place.y, result_.max_normal_force));
  }
  part.loads.apply(step_, assembly_.particles);
}

void DemParticipant::predict(Part& part) {
  part.sweep.predict(*team_, step_.kick(), assembly_.particles);
  part.motions.impose(step_, assembly_.particles);
}

void DemParticipant::close_step() {
  released_ += result_.released;
  contacts_.moved(step_.dt, speed_);
  if (!step_.from_rest()) ++moves_;
  // What breaks in statics is broken when time begins.
  const std::uint64_t step = step_.relax ? 0 : step_.number;
  for (const std::uint32_t bond : broken_)
    report(crack_of_bond(assembly_, bond), step, *unreported_.add_cracks());
  if (step_.relax) return;
  const Place place = middle_of_bond(assembly_, result_.strongest_bond);
  wire::BondForce& strongest = *unreported_.add_strongest();
  strongest.set_step(step);
  strongest.set_force(result_.max_normal_force);
  strongest.set_x(place.x);
  strongest.set_y(place.y);
}

void DemParticipant::report_energies(wire::Energies& energies) {
  energies.set_kinetic(kinetic_energy(assembly_.particles, before_, step_.from_rest()));
  energies.set_strain(strain_of_bonds() + contact_energy(law_.stiffness.normal, assembly_.bonds.rest_length,
                                                         contacts_.pairs(), assembly_.particles));
  double work = 0;
  for (const Part* part : {&interface_, &interior_}) work += part->loads.work() + part->motions.work();
  energies.set_external_work(work);
  energies.set_released(released_);
}

double DemParticipant::strain_of_bonds() {
  std::array<double, 64> parts{};  // as many whoever computes them
  const std::span<const Run> runs = assembly_.bonds.runs;
  team_->run(parts.size(), [&](std::size_t part, std::size_t) {
    const std::size_t begin = runs.size() * part / parts.size(),
                      end = runs.size() * (part + 1) / parts.size();
    parts[part] = strain_energy(law_, runs.subspan(begin, end - begin), assembly_.particles, assembly_.bonds);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

void DemParticipant::snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) {
  correct(view(request.impulses()));
  find_normal_forces(law_, assembly_.particles, assembly_.bonds);
  if (coupling_.size() == 0 || !request.impulses().empty()) take_peaks();
  write_snapshot(assembly_, snapshot);
  if (peaks_) protocol::add_peak_fields(*peaks_, *snapshot.mutable_pieces(0)->mutable_point_fields());
}

void DemParticipant::finish(wire::Bye& bye) {
  bye.set_cpu_seconds(static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC);
  bye.set_updates(assembly_.particles.size() * moves_);
}

}  // namespace adit::dem
