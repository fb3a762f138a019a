#include "dem_server/engines/general/observe/participant.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "dem_server/engines/general/arrange.hpp"
#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/observe/branches.hpp"
#include "dem_server/engines/general/observe/crack.hpp"
#include "dem_server/engines/general/observe/fragments.hpp"
#include "dem_server/engines/general/observe/snapshot.hpp"
#include "dem_server/engines/lattice/sweep.hpp"
#include "dem_server/model/extent.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/participant/messages.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

constexpr double kFar = 10;  // extents of the model from where it stood: a disc has left

}  // namespace

void DiscsParticipant::set_up(const wire::Setup& setup, wire::Model& answer) {
  started_ = std::clock();
  scene_ = setup.scene();
  weighed_.model = read_model(scene_);
  weighed_.id = arrange(weighed_.model);
  const Model& model = weighed_.model;
  if (scene_.has_initial_stress())
    throw protocol::UserError(
        "initial_stress",
        "is given, but only a hexagonal lattice of contact bonds without further features can "
        "start under it; leave it out, or pack the particles under a stress that they keep");
  answer.set_critical_dt(critical_step(model));
  const Rectangle extent = extent_of(model.discs);
  answer.set_x_min(extent.x_min);
  answer.set_x_max(extent.x_max);
  answer.set_y_min(extent.y_min);
  answer.set_y_max(extent.y_max);
  for (const std::string& note : model.notes) answer.add_notes(note);
  std::vector<double> points;
  points.reserve(2 * (model.discs.size() + model.joined.size()));
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    points.insert(points.end(), {model.discs.x[i], model.discs.y[i]});
  for (const Joined& pair : model.joined) {
    const Place place = middle_of(model.discs, pair.first, pair.second);
    points.insert(points.end(), {place.x, place.y});
  }
  assign(*answer.mutable_sample_points(), points);
}

void DiscsParticipant::weigh(const wire::Weights& weights, wire::Interface& interface) {
  const bool coupled = weights.weights_size() > 0;
  if (coupled) {
    const Model& whole = weighed_.model;
    weighed_ = adit::dem::weigh(weighed_, split_weights(weights, whole.discs.size(), whole.joined.size()));
    if (weighed_.model.discs.size() == 0)
      throw protocol::UserError("interface.overlap",
                                "leaves no particles, their weight being 0 everywhere; let the packing "
                                "reach into the overlap and beyond it on the particles' own side");
  }
  const Model& model = weighed_.model;
  const std::size_t size = model.discs.size();
  solver_.emplace(model, threads_ > 0 ? threads_ : useful_threads(size), weighed_.weights);
  solver_->particles().id = weighed_.id;
  const Particles& particles = solver_->particles();
  if (coupled)
    assign(*interface.mutable_points(),
           coupling_.offer(particles, {weights.x_min(), weights.x_max(), weights.y_min(), weights.y_max()}));
  const Rectangle extent = extent_of(model.discs);
  const double tolerance = 1e-9 * std::max(extent.x_max - extent.x_min, extent.y_max - extent.y_min);
  scene::Particles loads = scene_.particles(), body_loads = loads;
  loads.clear_body_loads();
  body_loads.clear_loads();
  loads_ = Loads(loads, particles, tolerance);
  body_loads_ = Loads(body_loads, particles, tolerance);
  motions_ = Motions(scene_.particles(), particles, tolerance);
  histories_.emplace(scene_.particles(), *solver_);
  lists_ = solver_->neighbours().lists();
  interface.set_particles(size);
  interface.set_bonds(model.joined.size());
}

void DiscsParticipant::couple(const wire::Couple& couple, wire::Operator& op) {
  const Pairs& bonds = solver_->bonds();
  const double longest = bonds.size() > 0 ? std::ranges::max(bonds.rest_length) : 0;
  coupling_.tie(view(couple.points()), solver_->particles(), {bonds.first, bonds.second, longest}, motions_);
  coupling_.fill(op);
  histories_->tie(coupling_.particles());
}

void DiscsParticipant::correct(std::span<const double> impulses) {
  if (impulses.empty()) return;
  check_impulses(impulses, coupling_.size(), step_);
  coupling_.push(impulses, solver_->particles(), motions_);
}

void DiscsParticipant::relax(bool stop, wire::Relaxation& answer) {
  const Particles& p = solver_->particles();
  if (!relaxation_) relaxation_.emplace(p);
  answer.set_unbalanced_force(relaxation_->measure(p, step_.kick()));
  answer.set_internal_force(solver_->internal_force());
  answer.set_points(p.size());
  answer.set_elements(solver_->bonds().size() + solver_->contacts().size());
  if (!stop) return;
  solver_->stop();
  relaxation_->stopped(p);
}

void DiscsParticipant::start_over() {
  relaxation_.reset();
  solver_->start_over();
  loads_.start_over();
  body_loads_.start_over();
  motions_.start_over();
}

void DiscsParticipant::advance(const wire::Advance& advance, wire::Predicted& predicted) {
  correct(view(advance.impulses()));
  take_peaks();
  step_.dt = checked_dt(advance, step_.dt);
  if (relaxation_ && !advance.relax()) start_over();
  if (advance.relax()) relax(advance.stop(), *predicted.mutable_relaxation());
  step_ = {advance.step(), advance.dt(), advance.relax(), advance.stop()};
  const Particles& particles = solver_->particles();
  histories_->remember(particles);
  if (advance.want_peaks()) {
    if (!peaks_) peaks_.emplace(particles.size());
    peaks_->remember({particles.vx, particles.vy});
    peaks_due_ = true;
  }
  if (advance.want_energies()) remember(particles, before_);

  Loads* const loads[] = {&loads_, &body_loads_};
  solver_->step(step_, loads, motions_);
  check_finite();
  warn_of_escapes();
  if (!step_.from_rest()) ++moves_;

  predicted.set_step(step_.number);
  predicted.mutable_velocities()->Resize(static_cast<int>(2 * coupling_.size()), 0.0);
  coupling_.read_velocities(particles,
                            {predicted.mutable_velocities()->mutable_data(), 2 * coupling_.size()});
  report_events(predicted);
  if (advance.want_histories()) histories_->read(*solver_, step_, *predicted.mutable_histories());
  if (advance.relax()) predicted.mutable_relaxation()->set_kinetic_energy(kinetic_energy(particles));
  if (advance.want_energies()) report_energies(*predicted.mutable_energies());
}

void DiscsParticipant::check_finite() const {
  const Solver::Strongest& strongest = solver_->strongest();
  if (!std::isfinite(strongest.force))
    throw protocol::Unstable(
        fmt::format("step {}: the normal force between the particles at ({:.6g}, {:.6g}) m is {} N; reduce "
                    "time.dt_factor",
                    step_.number, strongest.x, strongest.y, strongest.force));
  if (!std::isfinite(solver_->ledger().pairs))
    throw protocol::Unstable(fmt::format(
        "step {}: the work of the particles' forces is not finite; reduce time.dt_factor", step_.number));
}

// Only what moves far makes new lists of neighbours.
void DiscsParticipant::warn_of_escapes() {
  if (escaped_ || solver_->neighbours().lists() == lists_) return;
  lists_ = solver_->neighbours().lists();
  const Rectangle extent = extent_of(weighed_.model.discs);
  const double far = kFar * std::hypot(extent.x_max - extent.x_min, extent.y_max - extent.y_min);
  const Particles& p = solver_->particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!(std::hypot(p.ux[i], p.uy[i]) > far)) continue;
    escaped_ = true;
    spdlog::warn(
        "step {}: particle {} has left the model: it is {:.3g} m from where it stood at ({:.6g}, {:.6g}) m; "
        "the run goes on, and further ones are not reported",
        step_.number, p.id[i], std::hypot(p.ux[i], p.uy[i]), p.x[i], p.y[i]);
    return;
  }
}

void DiscsParticipant::report_events(wire::Predicted& predicted) const {
  // What breaks in statics is broken when time begins.
  const std::uint64_t step = step_.relax ? 0 : step_.number;
  for (const std::uint32_t bond : solver_->broken())
    report(crack_of_bond(weighed_.model, *solver_, bond), step, *predicted.add_cracks());
  if (step_.relax) return;
  const Solver::Strongest& from = solver_->strongest();
  wire::BondForce& strongest = *predicted.add_strongest();
  strongest.set_step(step);
  strongest.set_force(from.force);
  strongest.set_x(from.x);
  strongest.set_y(from.y);
}

void DiscsParticipant::report_energies(wire::Energies& energies) const {
  const DiscLedger ledger = solver_->ledger();
  const Stored stored = solver_->stored();
  energies.set_kinetic(kinetic_energy(solver_->particles(), before_, step_.from_rest()));
  energies.set_strain(solver_->strain_energy());
  energies.set_released(ledger.released);
  energies.set_external_work(loads_.work() + body_loads_.work() + motions_.work() + solver_->walls().work() +
                             ledger.support);
  energies.set_dissipated(ledger.friction + ledger.dashpots + ledger.damping.local + ledger.damping.viscous +
                          ledger.damping.edges);
  const std::pair<const char*, double> shares[] = {{"contacts", stored.contacts},
                                                   {"contact_bonds", stored.contact_bonds},
                                                   {"parallel_bonds", stored.parallel_bonds},
                                                   {"joints", solver_->joints().strain_energy()},
                                                   {"springs", solver_->springs().strain_energy()},
                                                   {"loads", loads_.work()},
                                                   {"body_loads", body_loads_.work()},
                                                   {"motions", motions_.work()},
                                                   {"walls", solver_->walls().work()},
                                                   {"friction", ledger.friction},
                                                   {"contact_dashpots", ledger.dashpots},
                                                   {"local_damping", ledger.damping.local},
                                                   {"viscous_damping", ledger.damping.viscous},
                                                   {"quiet_edges", ledger.damping.edges},
                                                   {"time_step", solver_->time_step_share()}};
  for (const auto& [name, value] : shares) {
    wire::EnergyShare& share = *energies.add_shares();
    share.set_name(name);
    share.set_value(value);
  }
}

void DiscsParticipant::take_peaks() {
  if (!peaks_due_) return;
  peaks_due_ = false;
  const Particles& p = solver_->particles();
  const auto displacement = [&p](std::size_t i) {
    return std::array{p.ux[i] - p.settled_x[i], p.uy[i] - p.settled_y[i]};
  };
  peaks_->take(displacement, {p.vx, p.vy}, step_);
}

void DiscsParticipant::snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) {
  correct(view(request.impulses()));
  if (coupling_.size() == 0 || !request.impulses().empty()) take_peaks();
  write_snapshot(*solver_, weighed_.model, snapshot);
  if (peaks_) protocol::add_peak_fields(*peaks_, *snapshot.mutable_pieces(0)->mutable_point_fields());
}

void DiscsParticipant::finish(wire::Bye& bye) {
  bye.set_cpu_seconds(static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC);
  if (!solver_) return;
  const std::size_t size = solver_->particles().size();
  bye.set_updates(size * moves_);
  bye.set_fragments(fragments_of(size, whole_bonds(*solver_)).count());
}

}  // namespace adit::dem
