#include "dem_server/participant/participant.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <numeric>

#include "dem_server/condensation/require_linear.hpp"
#include "dem_server/model/bond_springs.hpp"
#include "dem_server/model/initial_state/initial_state.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/model/sample_points.hpp"
#include "dem_server/model/solid/thin_strip.hpp"
#include "dem_server/model/solid/wet_ground.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/participant/messages.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/messages/spans.hpp"

namespace adit::dem {
namespace {

void tell(const Unrest::Farthest& farthest, std::span<const std::string> groups, wire::Relaxation& answer) {
  answer.set_largest_displacement(farthest.distance);
  answer.set_moved_x(farthest.x);
  answer.set_moved_y(farthest.y);
  const std::string group = farthest.group == 0 ? "" : groups[farthest.group];  // 0: the model's own
  answer.set_moved(fmt::format("{}{}{}",
                               farthest.body == 1
                                   ? "a particle that no bond holds"
                                   : fmt::format("a body of {} bonded particles", farthest.body),
                               group.empty() ? "" : " of group ", group));
}

}  // namespace

void DemParticipant::set_up(const wire::Setup& setup, wire::Model& answer) {
  scene_ = setup.scene();
  const std::vector<std::string> notes = fill_pores(scene_);
  model_ = read_model(scene_, progress(), engines_->threads());
  model_.notes.insert(model_.notes.end(), notes.begin(), notes.end());
  if (scene_.particles().has_begin()) require_linear(model_);
  const std::string engine = engines_->choose(scene_, model_);
  engine_ = engines_->make(model_);
  spdlog::info("the engine of the particles is {}", engine);
  critical_ = engine_->critical_element();
  if (!(critical_.step > 0) || !std::isfinite(critical_.step))
    throw protocol::UserError("particles",
                              fmt::format("have a critical time step of {} s; check the units of "
                                          "stiffness, radius and density",
                                          critical_.step));
  report(critical_, answer);
  answer.set_scales_masses(engine_->scales_masses());
  answer.set_slows(engine_->slows());
  report(wave_speeds(model_), answer);
  answer.set_highest_frequency(highest_frequency(model_));
  answer.set_x_min(model_.extent.x_min);
  answer.set_x_max(model_.extent.x_max);
  answer.set_y_min(model_.extent.y_min);
  answer.set_y_max(model_.extent.y_max);
  answer.set_engine(engine);
  for (const std::string& note : model_.notes) answer.add_notes(note);
  for (const std::string& group : model_.group_names) answer.add_groups(group);
  assign(*answer.mutable_sample_points(), sample_points(model_));
}

void DemParticipant::weigh(const wire::Weights& weights, wire::Interface& interface) {
  if (weights.weights_size() > 0) {
    const bool bonded = !model_.bonds.empty();
    const SampledWeights sampled = split_weights(weights, model_.discs.size(), model_.bonds.size());
    if (scene_.particles().packing().bends_as_solid() && !faces_are_free(model_.discs, sampled.centres))
      throw protocol::UserError("interface.overlap",
                                "covers the lower or upper face of a packing that bends as the solid, whose "
                                "faces must be free; leave out particles.packing.bends_as_solid");
    model_ = dem::weigh(model_, sampled);
    if (model_.discs.size() == 0 || (bonded && model_.bonds.empty()))
      throw protocol::UserError(
          "interface.overlap",
          "leaves no bonded particles, their weight being 0 everywhere; let the packing "
          "reach into the overlap and beyond it on the particles' own side");
    if (scene_.has_initial_stress()) balance_under_weights(sampled.centres);
    engine_ = engines_->make(model_);
    assign(*interface.mutable_points(),
           engine_->offer({weights.x_min(), weights.x_max(), weights.y_min(), weights.y_max()}));
  }
  engine_->watch(scene_.particles());
  if (scene_.statics().has_count_from_stage() && scene_.statics().count_from_stage() == 0)
    engine_->count_displacements();
  interface.set_particles(engine_->counts().particles);
  interface.set_bonds(engine_->counts().bonds);
  interface.set_breakable_bonds(breakable_bonds(model_));
  interface.set_mass(std::inner_product(model_.mass.begin(), model_.mass.end(), model_.weight.begin(), 0.0));
}

void DemParticipant::balance_under_weights(std::span<const double> centres) {
  std::vector<double> weights;
  for (const std::uint32_t place : model_.id) weights.push_back(centres[place]);
  balance_in_overlap(stated_stress(scene_), weights, model_);
}

void DemParticipant::couple(const wire::Couple& couple, wire::Operator& op) {
  engine_->tie(protocol::view(couple.points())).fill(op);
  assign(*op.mutable_inverse_masses(), engine_->tied_inverse_masses());
  coupling_points_ = static_cast<std::size_t>(couple.points_size()) / 2;
  if (!scene_.has_statics() || !engine_->scales_masses()) return;
  scale_masses(true);
  assign(*op.mutable_scaled_inverse_masses(), engine_->tied_inverse_masses());
  scale_masses(false);
}

void DemParticipant::scale_masses(bool scaled) {
  if (scaled == scaled_) return;
  scaled_ = scaled;
  engine_->scale_masses(scaled ? critical_.mass_per_stiffness : 0);
}

void DemParticipant::measure_unrest(const protocol::Step& last, wire::Relaxation& answer) {
  const Unrest unrest = engine_->unrest(last);
  answer.set_unbalanced_force(unrest.unbalanced_force);
  answer.set_internal_force(unrest.internal_force);
  answer.set_points(unrest.particles);
  answer.set_elements(unrest.elements);
  answer.set_largest_unbalanced_force(unrest.largest);
  answer.set_x(unrest.x);
  answer.set_y(unrest.y);
  answer.set_net_x(unrest.net_x);
  answer.set_net_y(unrest.net_y);
  answer.set_drag_x(unrest.drag_x);
  answer.set_drag_y(unrest.drag_y);
  if (unrest.farthest) tell(*unrest.farthest, model_.group_names, answer);
}

void DemParticipant::excavate(std::uint32_t stage) {
  if (stage <= stage_) return;
  const protocol::CountedFrom counted = protocol::counted_from(scene_.statics());
  if (counted.stage_given && counted.begins(stage_, stage)) engine_->count_displacements();
  scale_masses(false);  // a stage of another model alone changes no masses by itself
  engine_->begin_stage(stage);
  stage_ = stage;
}

void DemParticipant::prepare(const protocol::Step& step, const wire::Advance& wanted) {
  const double critical = step.relax ? critical_.static_step : critical_.step;
  if (step.dt > critical && !scene_.time().beyond_critical())
    throw protocol::UserError("time.dt", fmt::format("is {} s, above the particles' critical step of {} s; "
                                                     "give at most that",
                                                     step.dt, critical));
  engine_->prepare(wanted.want_energies());
}

void DemParticipant::condense_solver(const wire::Condense& request, wire::Condensed& answer) {
  const protocol::SparseRows ties({request.row_starts().begin(), request.row_starts().end()},
                                  {request.columns().begin(), request.columns().end()},
                                  {request.values().begin(), request.values().end()});
  const auto condensed = engine_->condense(ties, request.masters(), scene_.particles().begin().demand());
  if (const auto* reason = std::get_if<std::string>(&condensed)) return answer.set_reason(*reason);
  const auto& [stiffness, mass, force, strain_energy, demand] = std::get<Condensed>(condensed);
  for (Eigen::Index row = 0; row < stiffness.rows(); ++row)
    for (Eigen::Index column = 0; column <= row; ++column) {
      answer.add_stiffness(stiffness(row, column));
      answer.add_mass(mass(row, column));
    }
  assign(*answer.mutable_force(), std::span(force.data(), static_cast<std::size_t>(force.size())));
  answer.set_strain_energy(strain_energy);
  answer.set_demand(demand);
}

void DemParticipant::follow(const protocol::Step& step, const wire::Following& masters) {
  engine_->follow({protocol::view(masters.displacements()), protocol::view(masters.velocities_before()),
                   protocol::view(masters.velocities())},
                  step.dt);
}

double DemParticipant::arrive(const protocol::Step& step) {
  engine_->arrive(step);
  note_events(step);
  return engine_->demand();
}

void DemParticipant::step_interior(const protocol::Step& step) {
  engine_->step_interior(step);
  if (!step.from_rest()) ++moves_;
  note_events(step);
}

void DemParticipant::note_events(const protocol::Step& step) {
  // What breaks in statics is broken when time begins.
  const std::uint64_t number = step.relax ? 0 : step.number;
  for (const Crack& crack : engine_->broken()) {
    wire::Crack& told = *unreported_.add_cracks();
    report(crack, number, model_.group_names, told);
    told.set_stage(stage_);
    told.set_in_statics(step.relax);
  }
  if (!step.relax) report(engine_->strongest(), number, *unreported_.add_strongest());
}

void DemParticipant::read_energies(const protocol::Step& step, wire::Energies& energies) {
  report(engine_->energies(step), energies);
}

void DemParticipant::read_histories(const protocol::Step& step,
                                    google::protobuf::RepeatedField<double>& values) {
  histories_.clear();
  engine_->read_histories(step, histories_);
  assign(values, histories_);
}

void DemParticipant::read_events(wire::Predicted& predicted) {
  predicted.mutable_cracks()->Swap(unreported_.mutable_cracks());
  predicted.mutable_strongest()->Swap(unreported_.mutable_strongest());
}

void DemParticipant::exchange_solver(state::Archive& archive) {
  std::uint32_t stage = stage_;
  archive("stage", stage);
  if (archive.reads()) excavate(stage);  // builds what the engine has in this stage
  engine_->exchange(archive);
  archive("moves", moves_);
  std::string unreported = unreported_.SerializeAsString();
  archive("unreported", unreported);
  if (archive.reads()) unreported_.ParseFromString(unreported);
}

void DemParticipant::finish(wire::Bye& bye) {
  bye.set_updates(engine_->counts().particles * moves_);
  bye.set_fragments(engine_->fragments());
  for (const CrackPath& path : engine_->crack_paths()) report(path, *bye.add_crack_paths());
  for (const std::string& warning : engine_->warnings()) bye.add_warnings(warning);
  for (const auto& [name, value] : engine_->figures()) {
    wire::Figure& figure = *bye.add_figures();
    figure.set_name(name);
    figure.set_value(value);
  }
}

}  // namespace adit::dem
