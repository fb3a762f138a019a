// The participant from stage to stage of excavation.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fdm_server/participant/participant.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::fdm {

// A state of a later stage is read after all stages before it, because each finds what they left.
void FdmParticipant::excavate(std::uint32_t stage) {
  if (stage <= stage_) return;
  const auto& stages = zone_stages_.stages();
  for (auto next = stages.upper_bound(stage_); next != stages.end() && next->first < stage; ++next)
    begin_stage(next->first);
  begin_stage(stage);
}

void FdmParticipant::begin_stage(std::uint32_t stage) {
  const auto found = zone_stages_.stages().find(stage);
  const ZoneStages::Stage changes =
      found == zone_stages_.stages().end() ? ZoneStages::Stage{} : found->second;
  for (const auto& excavated : changes.excavated) weights_[excavated.zone] = 0;
  std::vector<std::uint32_t> renewed;
  for (const auto& one : changes.renewed) {
    weights_[one.zone] = 1;  // none of them lies in an overlap
    renewed.push_back(one.zone);
  }
  renew(changes, setup_.ground.of_zone);
  zones_there_ = grid_.zones.size() - static_cast<std::size_t>(std::ranges::count(weights_, 0.0));
  if (protocol::counted_from(scene_.statics()).begins(stage_, stage)) continuum_->reset_displacements();
  stage_ = stage;
  const auto masses = this->masses();
  continuum_->excavate(changes.excavated, masses, loads(masses), stage);
  if (!renewed.empty()) {
    continuum_->renew(setup_.kind, grid_, setup_.ground, renewed);
    zone_steps_.clear();
  }
  if (scene_.has_water()) continuum_->zones().set_rest(water_at_rest().pressures());
  scaled_ = false;
  if (relaxes_) set_masses();  // of the contacts that stand now
  relaxation_.emplace(grid_, weights_);
  travel_.reset();
}

std::vector<std::uint32_t> FdmParticipant::zone_kinds() const {
  std::vector<std::uint32_t> kinds = setup_.ground.of_zone;  // wet ground is of another kind than dry
  for (const auto& [number, stage] : zone_stages_.stages()) renew(stage, kinds);
  const std::vector<bool> there = zone_stages_.there_at_last();
  for (std::size_t z = 0; z < kinds.size(); ++z)
    if (z >= grid_.own_zones() || !there[z]) kinds[z] = kNoGround;
  return kinds;
}

template <class Test>
void FdmParticipant::refuse_excavated(const Test& is_tied, std::string_view why) const {
  for (const auto& [stage, changes] : zone_stages_.stages())
    for (const auto& one : changes.excavated) {
      if (!is_tied(one.zone)) continue;
      const auto [x, y] = centroid(corners(grid_, one.zone));
      throw protocol::UserError(
          "continuum.excavations",
          fmt::format("take away the zone at ({:g}, {:g}) m in stage {}, {}", x, y, stage, why));
    }
}

template <class Test>
void FdmParticipant::refuse_renewed(const Test& is_tied, std::string_view why) const {
  for (const auto& [stage, changes] : zone_stages_.stages())
    for (const auto& one : changes.renewed) {
      if (!is_tied(one.zone)) continue;
      const auto [x, y] = centroid(corners(grid_, one.zone));
      throw protocol::UserError(fmt::format("continuum.materials[{}].stage", one.material - 1),
                                fmt::format("is {}, but the zone at ({:g}, {:g}) m, {}", stage, x, y, why));
    }
}

// The coupler knows the masses at the coupling points once and for all.
void FdmParticipant::require_interface_stays() const {
  std::vector<bool> coupled(grid_.x.size(), false);
  for (const auto point : operator_.points()) coupled[point] = true;
  const auto is_coupled = [&](std::uint32_t zone) {
    return std::ranges::any_of(grid_.zones[zone], [&](auto point) { return coupled[point]; });
  };
  refuse_excavated(is_coupled, "which the interface ties; keep a zone between excavations and overlap");
  refuse_renewed(is_coupled,
                 "which the overlap ties, keeps its material; keep a zone between this area and the overlap");
  if (const auto point = supports_.structures.later_point(coupled))
    throw protocol::UserError("continuum.linings",
                              fmt::format("members or bolts are attached at ({:g}, {:g}) m after stage 0, "
                                          "where the interface ties the grid; "
                                          "keep a zone between them and the overlap",
                                          grid_.x[*point], grid_.y[*point]));
}

// What boundaries absorb and interfaces bear follows from the zones that they found.
void FdmParticipant::require_renewed_apart() const {
  refuse_renewed([&](std::uint32_t zone) { return absorbing_[zone]; },
                 "beside dashpots of a boundary, keeps its material; keep a zone between this area and the "
                 "boundary, or give stage 0");
  std::vector<bool> joined(grid_.x.size(), false);
  supports_.contacts.mark_points(joined);
  refuse_renewed(
      [&](std::uint32_t zone) {
        return std::ranges::any_of(grid_.zones[zone], [&](auto point) { return joined[point]; });
      },
      "at an interface, keeps its material; keep a zone between this area and interfaces, or give stage 0");
  constexpr double kWhole = 1 - 1e-9;  // to the rounding of weights
  refuse_renewed([&](std::uint32_t zone) { return weights_[zone] < kWhole; },
                 "in the overlap with another model, keeps its material; keep this area out of the overlap");
}

// Which move by mean acceleration, and have other masses in statics than the coupler knows.
void FdmParticipant::require_apart_from_contacts() const {
  std::vector<bool> joined(grid_.x.size(), false);
  continuum_->contacts().mark_points(joined);
  for (const auto point : operator_.points())
    if (joined[point])
      throw protocol::UserError(
          "continuum.interfaces",
          fmt::format("meet at ({:g}, {:g}) m what the overlap ties; keep a zone between interfaces of the "
                      "continuum or of its linings and the overlap",
                      grid_.x[point], grid_.y[point]));
}

// A free field is ground that goes on as the side does: an opening there would go on, too.
void FdmParticipant::require_free_field_stays() const {
  std::vector<bool> beside(grid_.zones.size(), false);
  for (const FreeFieldColumn& column : columns_)
    for (const BoundaryEdge& edge : column.edges) beside[edge.zone] = true;
  refuse_excavated([&](std::uint32_t zone) { return beside[zone]; },
                   "beside the column of continuum.free_field; keep a zone between excavations and this "
                   "side, or leave the free field out there");
}

}  // namespace adit::fdm
