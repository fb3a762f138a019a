#include "fdm_server/model/grid/zone_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::fdm {
namespace {

// Of what the scene states of a stage: of each zone, none where nothing is stated.
struct Stated {
  std::vector<std::optional<double>> released;         // by the first excavation that holds it
  std::vector<std::optional<std::uint32_t>> material;  // of the last area that holds it
  explicit Stated(std::size_t zones) : released(zones), material(zones) {}
};

void refuse_later_zones(const scene::Continuum& scene) {
  const auto later = [](const auto& one) { return one.stage() > 0; };
  const auto refuse = [](const char* what) {
    throw protocol::UserError("continuum.foundations",
                              fmt::format("are given beside {} of later stages, but foundations hold what is "
                                          "there from the beginning; leave one of them out",
                                          what));
  };
  if (std::ranges::any_of(scene.excavations(), later)) refuse("excavations");
  if (std::ranges::any_of(scene.materials(), later)) refuse("materials");
}

std::map<std::uint32_t, Stated> read_stages(const scene::Scene& scene, const Grid& grid) {
  std::map<std::uint32_t, Stated> stages;
  const auto& continuum = scene.continuum();
  if (continuum.foundations_size() > 0) refuse_later_zones(continuum);
  const std::size_t zones = grid.zones.size();
  for (int i = 0; i < continuum.materials_size(); ++i) {
    const std::uint32_t stage = continuum.materials(i).stage();
    if (stage == 0) continue;
    const std::string path = fmt::format("continuum.materials[{}]", i);
    protocol::require_statics(scene, stage, path);
    protocol::require(!continuum.large_strain(), path + ".stage",
                      fmt::format("is {}, but zones change or come into being in small strain only; leave "
                                  "continuum.large_strain out, or give stage 0",
                                  stage));
    for (const auto zone : select_zones(grid, continuum.materials(i).where(), path + ".where"))
      stages.try_emplace(stage, zones).first->second.material[zone] = static_cast<std::uint32_t>(i) + 1;
  }
  const bool fills = !stages.empty();
  for (int i = 0; i < continuum.excavations_size(); ++i) {
    const std::uint32_t stage = continuum.excavations(i).stage();
    if (stage == 0 && !fills) continue;  // what nothing fills is no part of the grid
    const std::string path = fmt::format("continuum.excavations[{}]", i);
    protocol::require_statics(scene, stage, path);
    const double released = stage == 0 ? 1 : continuum.excavations(i).released();
    const auto& where = continuum.excavations(i).where();
    for (const auto zone :
         stage == 0 ? zones_in(grid, where, path + ".where") : select_zones(grid, where, path + ".where")) {
      auto& of_zone = stages.try_emplace(stage, zones).first->second.released[zone];
      of_zone = of_zone.value_or(released);
    }
  }
  return stages;
}

}  // namespace

ZoneStages::ZoneStages(const scene::Scene& scene, const Grid& grid, std::span<const std::uint32_t> of_zone)
    : zones_(grid.zones.size()) {
  std::vector<bool> there(zones_, true);
  std::vector<std::uint32_t> materials(of_zone.begin(), of_zone.end());
  for (const auto& [number, stated] : read_stages(scene, grid)) {
    Stage& stage = stages_[number];
    for (std::uint32_t z = 0; z < zones_; ++z) {
      if (stated.released[z] && there[z]) {
        stage.excavated.push_back({z, 1 - *stated.released[z]});
        there[z] = false;
      }
      if (!stated.material[z] || (there[z] && materials[z] == *stated.material[z])) continue;
      stage.renewed.push_back({z, *stated.material[z]});
      materials[z] = *stated.material[z];
      there[z] = true;
    }
    if (std::ranges::find(there, true) == there.end())
      throw protocol::UserError("continuum.excavations", "leave no zone; give smaller areas");
  }
}

std::vector<bool> ZoneStages::there(std::uint32_t stage) const {
  std::vector<bool> there(zones_, true);
  for (const auto& [number, changes] : stages_) {
    if (number > stage) break;
    for (const auto& excavated : changes.excavated) there[excavated.zone] = false;
    for (const auto& renewed : changes.renewed) there[renewed.zone] = true;
  }
  return there;
}

std::vector<bool> ZoneStages::there_at_last() const {
  return there(std::numeric_limits<std::uint32_t>::max());
}

void renew(const ZoneStages::Stage& stage, std::span<std::uint32_t> of_zone) {
  for (const auto& [zone, material] : stage.renewed) of_zone[zone] = material;
}

}  // namespace adit::fdm
