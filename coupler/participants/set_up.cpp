#include "coupler/participants/set_up.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "coupler/answers/operator.hpp"
#include "coupler/bridging/overlap_checks.hpp"
#include "coupler/bridging/overlap_notes.hpp"
#include "coupler/participants/time_step.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/ground/statics_notes.hpp"
#include "protocol/log/log.hpp"
#include "protocol/log/waiting.hpp"
#include "protocol/participant/warnings.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// Two histories of one name and quantity would be one column of the table.
void require_distinct_histories(const scene::Scene& scene, const std::vector<Participant>& participants) {
  std::set<std::pair<std::string, int>> columns;
  for (const Participant& participant : participants) {
    const auto& histories = histories_of(scene, participant.member);
    for (int i = 0; i < histories.size(); ++i)
      if (!columns.insert({histories[i].name(), histories[i].quantity()}).second)
        throw UserError(fmt::format("{}.histories[{}].name", participant.member.path, i),
                        fmt::format("is `{}` a second time for the same quantity; choose another name",
                                    histories[i].name()));
  }
}

// `work`: what they do for it, which may take hours.
void ask_all(Model& model, wire::Frame::ContentCase expected, std::string_view work) {
  for (Participant& participant : model.participants) participant.connection->post(participant.request);
  for (Participant& participant : model.participants) {
    const protocol::Waiting waiting(fmt::format("{} {}", participant.connection->name(), work),
                                    [&] { return participant.connection->progress(); });
    collect(participant, expected);
  }
}

void build_models(Model& model, const std::string& run_id) {
  protocol::log_run(run_id);
  for (Participant& participant : model.participants) {
    for (const scene::History& history : histories_of(model.scene, participant.member))
      participant.histories.push_back(history.quantity());
    auto& setup = *participant.request.mutable_setup();
    setup.set_run_id(protocol::one_line(run_id));  // a folder's name may be any bytes
    *setup.mutable_scene() = part_of(model.scene, participant.member);
    setup.set_alone(model.interfaces.empty());
  }
  ask_all(model, wire::Frame::kModel, "builds its model");
  for (Participant& participant : model.participants) {
    participant.model.Swap(participant.reply.mutable_model());
    for (const std::string_view note : participant.model.notes()) {
      const bool warns = note.starts_with(protocol::kWarning);
      const auto text = note.substr(warns ? protocol::kWarning.size() : 0);
      (warns ? model.warnings : model.notes).push_back(fmt::format("{}: {}", participant.member.name, text));
    }
  }
}

void note_what_statics_leave_out(Model& model) {
  if (!model.scene.has_statics()) return;
  for (const Participant& participant : model.participants) {
    const scene::Scene part = part_of(model.scene, participant.member);
    const std::string& path = participant.member.path;
    const auto notes = participant.member.role == Role::kContinuum
                           ? protocol::notes_on_statics(part.continuum(), path)
                           : protocol::notes_on_statics(part.particles(), path);
    model.notes.insert(model.notes.end(), notes.begin(), notes.end());
  }
}

bool is_coupled(std::size_t participant, const std::vector<Interface>& interfaces) {
  return std::any_of(interfaces.begin(), interfaces.end(), [participant](const Interface& interface) {
    return interface.outer == participant || interface.inner == participant;
  });
}

Filled filled_by(const Participant& participant) {
  const auto& samples = participant.model.sample_points();
  return {bounds(participant.model), std::span(samples.data(), static_cast<std::size_t>(samples.size()))};
}

// Without them the energy of the overlap would be there twice.
void require_sample_points(const Model& model) {
  for (std::size_t s = 0; s < model.participants.size(); ++s)
    if (const Participant& participant = model.participants[s];
        is_coupled(s, model.interfaces) && participant.model.sample_points().empty())
      throw protocol::PeerLost(participant.connection->name(),
                               fmt::format("sent no sample points, at which `{}` needs weights of `{}`",
                                           participant.interface_path, participant.member.name));
}

void check_overlaps(Model& model) {
  for (const Interface& interface : model.interfaces) {
    Participant &outer = model.participants[interface.outer], &inner = model.participants[interface.inner];
    require_inside(interface.overlap, filled_by(outer), filled_by(inner));
    for (const std::string& note :
         overlap_notes(interface.overlap, side_of(model.scene, outer), side_of(model.scene, inner)))
      model.notes.push_back(inner.member.name + ": " + note);
  }
}

bool waits(const Model& model, std::size_t participant) {
  const Member& member = model.participants[participant].member;
  return member.role == Role::kParticles && particles_of(model.scene, member).has_begin();
}

// How far beside an overlap grid points move particles that wait: they are corners of zones that the overlap
// cuts, which are not wider than it [m].
double reach_of_waiting(const Model& model, std::size_t s) {
  double reach = 0;
  for (const Interface& interface : model.interfaces)
    if (model.participants[s].member.role == Role::kContinuum &&
        ((interface.outer == s && waits(model, interface.inner)) ||
         (interface.inner == s && waits(model, interface.outer))))
      reach = std::max(reach, interface.overlap.width());
  return reach;
}

// The points of this grid, of those that it offered, that may move particles which wait.
std::vector<double> nodes_around_waiting(const Model& model, std::size_t s) {
  std::vector<double> nodes;
  const double reach = reach_of_waiting(model, s);
  const std::vector<double>& offered = model.participants[s].candidates;
  for (std::size_t i = 0; reach > 0 && i < offered.size(); i += 2)
    for (std::size_t k = 0; k < model.coupling_points.size(); k += 2)
      if (std::hypot(offered[i] - model.coupling_points[k], offered[i + 1] - model.coupling_points[k + 1]) <=
          1.5 * reach) {
        nodes.insert(nodes.end(), {offered[i], offered[i + 1]});
        break;
      }
  return nodes;
}

void share_energy(Model& model) {
  require_sample_points(model);
  check_overlaps(model);
  require_one_owner(model.participants, model.interfaces);
  for (std::size_t s = 0; s < model.participants.size(); ++s) {
    Participant& participant = model.participants[s];
    auto& weights = *participant.request.mutable_weights();
    if (!is_coupled(s, model.interfaces)) continue;
    const auto& points = participant.model.sample_points();
    const auto values =
        weights_of(s, model.participants, model.interfaces, std::span(points.data(), points.size()));
    weights.mutable_weights()->Add(values.begin(), values.end());
    double floor = 1;
    for (const Interface& interface : model.interfaces)
      if (interface.outer == s || interface.inner == s)
        floor = std::min(floor, interface.given.weight_floor());
    weights.set_floor(floor);
    const BoundingBox box = overlap_bounds(s, model.participants, model.interfaces);
    const double beside = reach_of_waiting(model, s);
    weights.set_x_min(box.x_min - beside);
    weights.set_x_max(box.x_max + beside);
    weights.set_y_min(box.y_min - beside);
    weights.set_y_max(box.y_max + beside);
  }
  ask_all(model, wire::Frame::kInterface, "weighs its model");
  for (Participant& participant : model.participants) {
    participant.counts.Swap(participant.reply.mutable_interface());
    participant.candidates.assign(participant.counts.points().begin(), participant.counts.points().end());
    participant.counts.clear_points();
  }
}

// Each participant is asked about the coupling points of all its interfaces in turn.
void couple(Model& model) {
  model.coupling_points = choose_coupling_points(model.participants, model.interfaces);
  for (std::size_t s = 0; s < model.participants.size(); ++s) {
    Participant& participant = model.participants[s];
    auto& points = *participant.request.mutable_couple()->mutable_points();
    for (const Interface& interface : model.interfaces) {
      if (interface.coarse != s && interface.fine != s) continue;
      participant.segments.push_back({.begin = static_cast<std::size_t>(points.size()) / 2,
                                      .global = interface.begin,
                                      .count = interface.end - interface.begin,
                                      .coarse = interface.coarse == s});
      points.Add(model.coupling_points.begin() + 2 * static_cast<std::ptrdiff_t>(interface.begin),
                 model.coupling_points.begin() + 2 * static_cast<std::ptrdiff_t>(interface.end));
    }
    participant.nodes_begin = static_cast<std::size_t>(points.size()) / 2;
    const std::vector<double> nodes = nodes_around_waiting(model, s);
    points.Add(nodes.begin(), nodes.end());
  }
  ask_all(model, wire::Frame::kOperator, "looks for its coupling points");
  for (Participant& participant : model.participants) {
    const auto& points = participant.request.couple().points();
    participant.places.assign(points.begin(), points.end());
    const std::size_t count = participant.places.size() / 2;
    participant.interpolation =
        interpolation_of(participant.reply.operator_(), count, participant.connection->name());
    participant.correction = Correction(count);
    for (auto* vector : {&participant.predicted, &participant.corrected}) vector->assign(2 * count, 0.0);
    participant.own.assign(2 * participant.interpolation->own_points(), 0.0);
  }
  model.constraint = std::make_unique<Constraint>(model.participants, model.interfaces, model.coupling_points,
                                                  model.dt / model.substeps);
}

}  // namespace

Side side_of(const scene::Scene& scene, const Participant& participant) {
  return {participant.member.name, participant.member.path, part_of(scene, participant.member),
          filled_by(participant).samples};
}

bool has_particles(const Model& model) {
  return std::any_of(
      model.participants.begin(), model.participants.end(),
      [](const Participant& participant) { return participant.member.role == Role::kParticles; });
}

Model set_up(const scene::Scene& scene, std::vector<Participant> participants, const std::string& run_id,
             double dt) {
  Model model;
  model.scene = scene;
  model.participants = std::move(participants);
  std::vector<Member> members;
  for (const Participant& participant : model.participants) members.push_back(participant.member);
  for (const Join& join : joins(scene, members)) model.interfaces.emplace_back(join);
  for (const Interface& interface : model.interfaces)
    for (const std::size_t participant : {interface.outer, interface.inner})
      model.participants[participant].interface_path = interface.path;
  require_distinct_histories(scene, model.participants);
  protocol::require_counted_stage(scene);
  build_models(model, run_id);
  note_what_statics_leave_out(model);
  choose_time_step(model);
  if (dt > 0) keep_time_step(model, dt);
  compare_time_step(model);
  share_energy(model);
  if (!model.interfaces.empty()) couple(model);
  return model;
}

}  // namespace adit::coupler
