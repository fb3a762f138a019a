#include "coupler/set_up.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/bridging/overlap_checks.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// Two histories of one name and quantity would be one column of the table.
void require_distinct_histories(const scene::Scene& scene) {
  std::set<std::pair<std::string, int>> columns;
  for (const Role role : roles(scene))
    for (int i = 0; i < histories_of(scene, role).size(); ++i) {
      const scene::History& history = histories_of(scene, role)[i];
      if (!columns.insert({history.name(), history.quantity()}).second)
        throw UserError(
            fmt::format("{}.histories[{}].name", to_string(role), i),
            fmt::format("is `{}` a second time for the same quantity; choose another name", history.name()));
    }
}

void ask_all(Model& model, wire::Frame::ContentCase expected) {
  for (Side& side : model.sides) side.peer->post(side.request);
  for (Side& side : model.sides) collect(side, expected);
}

// A participant gets what concerns it: nothing of the other side, of the interface, of the results.
scene::Scene part_of(const scene::Scene& scene, Role role) {
  scene::Scene part = scene;
  part.clear_interface();
  part.clear_output();
  part.clear_base();
  if (role == Role::kContinuum) part.clear_particles();
  if (role == Role::kParticles) part.clear_continuum();
  return part;
}

void build_models(Model& model, const std::string& run_id) {
  for (Side& side : model.sides) {
    side.histories = histories_of(model.scene, side.role).size();
    auto& setup = *side.request.mutable_setup();
    setup.set_run_id(run_id);
    *setup.mutable_scene() = part_of(model.scene, side.role);
  }
  ask_all(model, wire::Frame::kModel);
  for (Side& side : model.sides) {
    side.model.Swap(side.reply.mutable_model());
    if (!(side.model.critical_dt() > 0) || !std::isfinite(side.model.critical_dt()))
      throw protocol::PeerLost(side.peer->name(), "sent no positive, finite critical time step");
  }
}

BoundingBox bounds(const wire::Model& model) {
  return {model.x_min(), model.x_max(), model.y_min(), model.y_max()};
}

void share_energy(Model& model) {
  for (Side& side : model.sides) {
    auto& weights = *side.request.mutable_weights();
    if (!model.overlap) continue;
    const auto& points = side.model.sample_points();
    const std::span samples(points.data(), points.size());
    const auto values = side.role == Role::kContinuum ? model.overlap->outer_weights(samples)
                                                      : model.overlap->inner_weights(samples);
    weights.mutable_weights()->Add(values.begin(), values.end());
    weights.set_floor(model.scene.interface().weight_floor());
    const BoundingBox box = model.overlap->bounds(bounds(side.model));
    weights.set_x_min(box.x_min);
    weights.set_x_max(box.x_max);
    weights.set_y_min(box.y_min);
    weights.set_y_max(box.y_max);
  }
  ask_all(model, wire::Frame::kInterface);
  for (Side& side : model.sides) side.counts.Swap(side.reply.mutable_interface());
}

void choose_coupling_points(Model& model) {
  for (const Side& side : model.sides) {
    const auto& points = side.counts.points();
    for (int i = 0; i + 1 < points.size(); i += 2)
      if (model.overlap->contains(points[i], points[i + 1]))
        model.coupling_points.insert(model.coupling_points.end(), {points[i], points[i + 1]});
  }
  if (model.coupling_points.empty())
    throw UserError("interface.overlap", "holds no particle; widen it to several particle diameters");
}

void couple(Model& model) {
  choose_coupling_points(model);
  const std::size_t count = model.coupling_points.size() / 2;
  for (Side& side : model.sides) {
    auto& points = *side.request.mutable_couple()->mutable_points();
    points.Add(model.coupling_points.begin(), model.coupling_points.end());
  }
  ask_all(model, wire::Frame::kOperator);
  for (Side& side : model.sides) {
    side.interpolation.emplace(side.reply.operator_(), count, side.peer->name());
    for (auto* vector : {&side.impulses, &side.predicted, &side.corrected}) vector->assign(2 * count, 0.0);
    side.own.assign(2 * side.interpolation->own_points(), 0.0);
  }
  model.solve = make_multiplier_solve(model.scene.interface().solve(), *model.sides[0].interpolation,
                                      *model.sides[1].interpolation);
}

// The duration is a whole number of steps, so that the last step ends on it.
void choose_time_step(Model& model) {
  const auto& slowest = *std::min_element(
      model.sides.begin(), model.sides.end(),
      [](const Side& a, const Side& b) { return a.model.critical_dt() < b.model.critical_dt(); });
  model.critical_dt = slowest.model.critical_dt();
  const auto& time = model.scene.time();
  if (time.has_dt() && time.dt() > model.critical_dt)
    throw UserError("time.dt",
                    fmt::format("is {:g} s, above {:g} s, the critical time step of the {}; give a smaller "
                                "one, or leave it out and state dt_factor",
                                time.dt(), model.critical_dt, to_string(slowest.role)));
  const double wanted = time.has_dt() ? time.dt() : time.dt_factor() * model.critical_dt;
  const double steps = std::ceil(time.duration() / wanted);
  if (steps > 1e15)
    throw UserError("time.duration", fmt::format("takes {:g} steps of {:g} s; shorten it", steps, wanted));
  model.steps = static_cast<std::uint64_t>(std::max(steps, 1.0));
  model.dt = time.duration() / static_cast<double>(model.steps);
}

}  // namespace

const google::protobuf::RepeatedPtrField<scene::History>& histories_of(const scene::Scene& scene, Role role) {
  return role == Role::kContinuum ? scene.continuum().histories() : scene.particles().histories();
}

std::vector<Role> roles(const scene::Scene& scene) {
  if (scene.has_simplified())
    throw UserError("simplified", "is computed by the program `simplified`, not by `coupler`");
  if (!scene.has_continuum() && !scene.has_particles())
    throw UserError("continuum", "is missing, and so is `particles`; give at least one of them");
  if (!scene.has_material())
    throw UserError("material",
                    "is missing; write for example `material: {young_modulus: 30 GPa, poisson_ratio: 0.25, "
                    "density: 2.5 t/m^3}`");
  const bool both = scene.has_continuum() && scene.has_particles();
  if (both && !scene.has_interface())
    throw UserError("interface", "is missing; state the overlap that joins `continuum` and `particles`");
  if (!both && scene.has_interface())
    throw UserError("interface", fmt::format("joins two models, but the scene has no `{}`",
                                             scene.has_continuum() ? "particles" : "continuum"));
  if (both) return {Role::kContinuum, Role::kParticles};
  return {scene.has_continuum() ? Role::kContinuum : Role::kParticles};
}

Model set_up(const scene::Scene& scene, std::vector<Side> sides, const std::string& run_id) {
  Model model;
  model.scene = scene;
  model.sides = std::move(sides);
  if (scene.has_interface()) model.overlap.emplace(scene.interface(), "interface");
  require_distinct_histories(scene);
  build_models(model, run_id);
  choose_time_step(model);
  if (model.overlap)
    require_inside(*model.overlap, bounds(model.sides[0].model), bounds(model.sides[1].model));
  share_energy(model);
  if (model.overlap) couple(model);
  return model;
}

}  // namespace adit::coupler
