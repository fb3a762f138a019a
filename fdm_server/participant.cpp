#include "fdm_server/participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "fdm_server/critical_step.hpp"
#include "fdm_server/snapshot.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

constexpr std::uint64_t kFiniteCheckInterval = 100;  // steps

std::span<const double> view(const google::protobuf::RepeatedField<double>& field) {
  return {field.data(), static_cast<std::size_t>(field.size())};
}

// One weight a zone from the wire's samples; all 1 where there are none.
std::vector<double> read_weights(const wire::Weights& weights, const Block& block) {
  if (weights.weights().empty()) return std::vector<double>(std::size_t{block.zones_x} * block.zones_y, 1.0);
  const std::size_t samples = (2 * std::size_t{block.zones_x} + 1) * (2 * std::size_t{block.zones_y} + 1);
  const auto in_range = [](double value) { return value >= 0 && value <= 1; };
  if (static_cast<std::size_t>(weights.weights_size()) != samples)
    throw std::invalid_argument(
        fmt::format("got {} weights for {} sample points", weights.weights_size(), samples));
  if (!std::ranges::all_of(weights.weights(), in_range) || !in_range(weights.floor()))
    throw std::invalid_argument("got a weight or a floor outside [0, 1]");
  return zone_weights(block, view(weights.weights()), weights.floor());
}

}  // namespace

void FdmParticipant::set_up(const wire::Setup& setup, wire::Model& model) {
  started_ = std::clock();
  scene_ = setup.scene();
  setup_ = read_setup(scene_);
  grid_ = make_grid(setup_.block);
  critical_dt_ = critical_step(setup_.kind, grid_, setup_.law, setup_.density);
  model.set_critical_dt(critical_dt_);
  model.set_x_min(setup_.block.x_min);
  model.set_x_max(setup_.block.x_max);
  model.set_y_min(setup_.block.y_min);
  model.set_y_max(setup_.block.y_max);
  const auto samples = sample_points(setup_.block);
  model.mutable_sample_points()->Assign(samples.begin(), samples.end());
}

void FdmParticipant::weigh(const wire::Weights& weights, wire::Interface& interface) {
  weights_ = read_weights(weights, setup_.block);
  compact(grid_, weights_);
  if (grid_.zones.empty())
    throw protocol::UserError(
        "interface.overlap",
        "leaves no zone of the continuum; move it so that continuum_ends lies inside or "
        "behind the block, seen from particles_begin");
  const auto masses = lumped_masses(grid_, weights_, setup_.density);
  const auto& conditions = scene_.continuum();
  continuum_ = std::make_unique<Continuum>(make_zones(setup_.kind, grid_, setup_.law, weights_), masses,
                                           resolve_loads(conditions, setup_.block, grid_, masses),
                                           resolve_motions(conditions, setup_.block, grid_));
  probes_ = resolve_histories(conditions, setup_.block, grid_);
  probe_before_.resize(probes_.size());
  interface.clear_points();
  interface.set_zones(grid_.zones.size());
  interface.set_grid_points(grid_.x.size());
}

void FdmParticipant::couple(const wire::Couple& couple, wire::Operator& op) {
  if (couple.points_size() % 2 != 0 ||
      !std::ranges::all_of(couple.points(), [](double value) { return std::isfinite(value); }))
    throw std::invalid_argument("got coupling points that are no finite pairs x y");
  operator_ = InterfaceOperator(grid_, view(couple.points()));
  const auto starts = operator_.row_starts(), columns = operator_.columns();
  const auto values = operator_.values();
  op.mutable_row_starts()->Assign(starts.begin(), starts.end());
  op.mutable_columns()->Assign(columns.begin(), columns.end());
  op.mutable_values()->Assign(values.begin(), values.end());
  op.clear_inverse_masses();
  for (const auto point : operator_.grid_points()) {
    op.add_inverse_masses(continuum_->inverse_mass_x()[point]);
    op.add_inverse_masses(continuum_->inverse_mass_y()[point]);
  }
}

void FdmParticipant::advance(const wire::Advance& advance, wire::Predicted& predicted) {
  if (next_step_ == 0) dt_ = advance.dt();
  check(advance);
  push(advance.impulses());
  if (advance.want_histories()) remember_probes();

  Energies energies{};
  continuum_->step(advance.step(), advance.dt(), advance.want_energies() ? &energies : nullptr);
  next_step_ = advance.step() + 1;

  predicted.set_step(advance.step());
  const int count = 2 * static_cast<int>(operator_.rows());
  predicted.mutable_velocities()->Resize(count, 0.0);
  operator_.velocities(*continuum_,
                       {predicted.mutable_velocities()->mutable_data(), static_cast<std::size_t>(count)});
  predicted.clear_energies();
  if (advance.want_energies()) {
    predicted.mutable_energies()->set_kinetic(energies.kinetic);
    predicted.mutable_energies()->set_strain(energies.strain);
    predicted.mutable_energies()->set_external_work(energies.external_work);
  }
  predicted.clear_histories();
  if (advance.want_histories()) fill_histories(predicted);
  check_finite(advance.step(), predicted);
}

void FdmParticipant::check(const wire::Advance& advance) const {
  if (advance.step() != next_step_)
    throw std::invalid_argument(
        fmt::format("was asked for step {}, but the next one is {}", advance.step(), next_step_));
  if (!(advance.dt() > 0) || advance.dt() != dt_)
    throw std::invalid_argument(
        fmt::format("was asked to advance by {} s in a run of {} s a step", advance.dt(), dt_));
  if (dt_ > critical_dt_)
    throw protocol::UserError("time.dt", fmt::format("is {} s, above the continuum's critical step of {} s; "
                                                     "give at most that",
                                                     dt_, critical_dt_));
}

void FdmParticipant::push(const google::protobuf::RepeatedField<double>& impulses) {
  if (impulses.empty()) return;
  if (next_step_ == 0 || static_cast<std::size_t>(impulses.size()) != 2 * operator_.rows())
    throw std::invalid_argument(fmt::format("got {} impulse components for {} coupling points before step {}",
                                            impulses.size(), operator_.rows(), next_step_));
  operator_.apply(view(impulses), *continuum_);
}

void FdmParticipant::remember_probes() {
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const auto [quantity, point] = probes_[i];
    probe_before_[i] = quantity == scene::VELOCITY_Y ? continuum_->vy()[point] : continuum_->vx()[point];
  }
}

void FdmParticipant::fill_histories(wire::Predicted& predicted) const {
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const auto [quantity, point] = probes_[i];
    if (quantity == scene::DISPLACEMENT_X)
      predicted.add_histories(continuum_->ux()[point]);
    else if (quantity == scene::DISPLACEMENT_Y)
      predicted.add_histories(continuum_->uy()[point]);
    else
      predicted.add_histories(probe_before_[i]);
  }
}

void FdmParticipant::check_finite(std::uint64_t step, const wire::Predicted& predicted) const {
  const auto finite = [](double value) { return std::isfinite(value); };
  const bool energies_finite = !predicted.has_energies() || (finite(predicted.energies().kinetic()) &&
                                                             finite(predicted.energies().strain()));
  if (step % kFiniteCheckInterval != 0 && energies_finite &&
      std::ranges::all_of(predicted.velocities(), finite))
    return;
  if (const auto point = std::as_const(*continuum_).first_non_finite()) {
    const Continuum& continuum = *continuum_;
    throw protocol::Unstable(
        fmt::format("step {}: the velocity of the grid point at ({}, {}) m is ({}, {}) m/s; lower time.dt "
                    "and look at the "
                    "loads",
                    step, grid_.x[*point], grid_.y[*point], continuum.vx()[*point], continuum.vy()[*point]));
  }
  if (!energies_finite)
    throw protocol::Unstable(fmt::format(
        "step {}: the continuum's energy is not finite (kinetic {} J, strain {} J); lower time.dt "
        "and look at the loads",
        step, predicted.energies().kinetic(), predicted.energies().strain()));
}

void FdmParticipant::snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) {
  push(request.impulses());
  fill_snapshot(grid_, *continuum_, weights_, snapshot);
}

void FdmParticipant::finish(wire::Bye& bye) {
  bye.set_cpu_seconds(static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC);
  bye.set_updates(grid_.zones.size() * next_step_);
}

}  // namespace adit::fdm
