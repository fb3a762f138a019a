#include "dem_server/model/stages/read_stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dem_server/model/placement/groups.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::dem {
namespace {

// An excavation and the discs that it takes.
struct Taken {
  std::uint32_t stage;
  double held;  // share of the forces
  std::vector<std::uint32_t> discs;
};

// By stage.
std::vector<Taken> read_excavations(const scene::Particles& particles, const Placement& placement) {
  std::vector<Taken> taken;
  for (int k = 0; k < particles.excavations_size(); ++k) {
    const auto& excavation = particles.excavations(k);
    taken.push_back(
        {excavation.stage(), 1 - excavation.released(),
         select(excavation.where(), placement, fmt::format("particles.excavations[{}].where", k))});
  }
  std::ranges::stable_sort(taken, {}, &Taken::stage);
  return taken;
}

void require_statics(const scene::Scene& scene) {
  const auto require = [&](const char* list, const auto& entries) {
    for (int k = 0; k < entries.size(); ++k)
      protocol::require_statics(scene, entries[k].stage(), fmt::format("particles.{}[{}]", list, k));
  };
  const auto& particles = scene.particles();
  require("excavations", particles.excavations());
  require("groups", particles.groups());
  require("joints", particles.joints());
  require("springs", particles.springs());
  require("bars", particles.bars());
}

// Sets which discs are there, and what those that vanish leave behind.
void excavate(const scene::Particles& particles, const std::vector<Taken>& taken, const ParticleStage* before,
              ParticleStage& stage) {
  for (const Taken& one : taken) {
    if (one.stage > stage.number) break;
    for (const std::uint32_t i : one.discs) {
      const std::uint32_t begins = begin_of_group(particles, stage.group[i]);
      stage.present[i] = begins > 0 && begins >= one.stage;
      stage.held[i] =
          one.stage == stage.number && before && before->present[i] && !stage.present[i] ? one.held : 0;
    }
  }
  if (std::ranges::find(stage.present, true) == stage.present.end())
    throw protocol::UserError("particles.excavations", "leave no particle; give smaller areas");
}

}  // namespace

std::vector<ParticleStage> read_stages(const scene::Scene& scene, const Placement& placement) {
  const auto& particles = scene.particles();
  const std::size_t discs = placement.discs.size();
  const auto taken = read_excavations(particles, placement);
  require_statics(scene);
  std::vector<ParticleStage> stages;
  for (const std::uint32_t number : protocol::stages_of(particles)) {
    ParticleStage stage{number, std::vector<bool>(discs, true), assign_groups(particles, placement, number),
                        std::vector<double>(discs, 0.0)};
    excavate(particles, taken, stages.empty() ? nullptr : &stages.back(), stage);
    stage.fresh.resize(discs, false);
    if (!stages.empty())
      for (std::size_t i = 0; i < discs; ++i)
        stage.fresh[i] =
            stage.present[i] && (!stages.back().present[i] || stages.back().group[i] != stage.group[i]);
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace adit::dem
