#include "coupler/sides/set_up.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/bridging/overlap_checks.hpp"
#include "coupler/sides/time_step.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// Two histories of one name and quantity would be one column of the table.
void require_distinct_histories(const scene::Scene& scene, const std::vector<Side>& sides) {
  std::set<std::pair<std::string, int>> columns;
  for (const Side& side : sides) {
    const auto& histories = histories_of(scene, side.member);
    for (int i = 0; i < histories.size(); ++i)
      if (!columns.insert({histories[i].name(), histories[i].quantity()}).second)
        throw UserError(fmt::format("{}.histories[{}].name", side.member.path, i),
                        fmt::format("is `{}` a second time for the same quantity; choose another name",
                                    histories[i].name()));
  }
}

void ask_all(Model& model, wire::Frame::ContentCase expected) {
  for (Side& side : model.sides) side.peer->post(side.request);
  for (Side& side : model.sides) collect(side, expected);
}

void build_models(Model& model, const std::string& run_id) {
  for (Side& side : model.sides) {
    side.histories = histories_of(model.scene, side.member).size();
    auto& setup = *side.request.mutable_setup();
    setup.set_run_id(run_id);
    *setup.mutable_scene() = part_of(model.scene, side.member);
  }
  ask_all(model, wire::Frame::kModel);
  for (Side& side : model.sides) {
    side.model.Swap(side.reply.mutable_model());
    if (!(side.model.critical_dt() > 0) || !std::isfinite(side.model.critical_dt()))
      throw protocol::PeerLost(side.peer->name(), "sent no positive, finite critical time step");
  }
}

bool is_coupled(std::size_t side, const std::vector<Interface>& interfaces) {
  return std::any_of(interfaces.begin(), interfaces.end(), [side](const Interface& interface) {
    return interface.outer == side || interface.inner == side;
  });
}

void share_energy(Model& model) {
  for (const Interface& interface : model.interfaces)
    require_inside(interface.overlap, bounds(model.sides[interface.outer].model),
                   bounds(model.sides[interface.inner].model));
  require_one_owner(model.sides, model.interfaces);
  for (std::size_t s = 0; s < model.sides.size(); ++s) {
    Side& side = model.sides[s];
    auto& weights = *side.request.mutable_weights();
    if (!is_coupled(s, model.interfaces)) continue;
    const auto& points = side.model.sample_points();
    const auto values = weights_of(s, model.sides, model.interfaces, std::span(points.data(), points.size()));
    weights.mutable_weights()->Add(values.begin(), values.end());
    double floor = 1;
    for (const Interface& interface : model.interfaces)
      if (interface.outer == s || interface.inner == s)
        floor = std::min(floor, interface.given.weight_floor());
    weights.set_floor(floor);
    const BoundingBox box = overlap_bounds(s, model.sides, model.interfaces);
    weights.set_x_min(box.x_min);
    weights.set_x_max(box.x_max);
    weights.set_y_min(box.y_min);
    weights.set_y_max(box.y_max);
  }
  ask_all(model, wire::Frame::kInterface);
  for (Side& side : model.sides) side.counts.Swap(side.reply.mutable_interface());
}

// Each side is asked about the coupling points of all its interfaces in turn.
void couple(Model& model) {
  model.coupling_points = choose_coupling_points(model.sides, model.interfaces);
  for (std::size_t s = 0; s < model.sides.size(); ++s) {
    Side& side = model.sides[s];
    auto& points = *side.request.mutable_couple()->mutable_points();
    for (const Interface& interface : model.interfaces) {
      if (interface.coarse != s && interface.fine != s) continue;
      side.segments.push_back({.begin = static_cast<std::size_t>(points.size()) / 2,
                               .global = interface.begin,
                               .count = interface.end - interface.begin,
                               .coarse = interface.coarse == s});
      points.Add(model.coupling_points.begin() + 2 * static_cast<std::ptrdiff_t>(interface.begin),
                 model.coupling_points.begin() + 2 * static_cast<std::ptrdiff_t>(interface.end));
    }
  }
  ask_all(model, wire::Frame::kOperator);
  for (Side& side : model.sides) {
    const std::size_t count = side.segments.back().begin + side.segments.back().count;
    side.interpolation.emplace(side.reply.operator_(), count, side.peer->name());
    for (auto* vector : {&side.impulses, &side.predicted, &side.corrected}) vector->assign(2 * count, 0.0);
    side.own.assign(2 * side.interpolation->own_points(), 0.0);
  }
  model.constraint = std::make_unique<Constraint>(model.scene, model.sides, model.interfaces,
                                                  model.coupling_points, model.dt / model.substeps);
}

}  // namespace

bool has_particles(const Model& model) {
  return std::any_of(model.sides.begin(), model.sides.end(),
                     [](const Side& side) { return side.member.role == Role::kParticles; });
}

Model set_up(const scene::Scene& scene, std::vector<Side> sides, const std::string& run_id) {
  Model model;
  model.scene = scene;
  model.sides = std::move(sides);
  std::vector<Member> members;
  for (const Side& side : model.sides) members.push_back(side.member);
  for (const Join& join : joins(scene, members)) model.interfaces.emplace_back(join);
  for (const Interface& interface : model.interfaces)
    for (const std::size_t side : {interface.outer, interface.inner})
      model.sides[side].interface_path = interface.path;
  require_distinct_histories(scene, model.sides);
  build_models(model, run_id);
  choose_time_step(model);
  share_energy(model);
  if (!model.interfaces.empty()) couple(model);
  return model;
}

}  // namespace adit::coupler
