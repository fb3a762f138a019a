#include "protocol/ground/stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

template <class Entries>
void add(const Entries& entries, std::set<std::uint32_t>& stages) {
  for (const auto& entry : entries) stages.insert(entry.stage());
}

// What an excavation does not release at once it releases in the stage that follows.
template <class Model>
std::set<std::uint32_t> stages_of_excavations(const Model& model) {
  std::set<std::uint32_t> stages{0};
  add(model.excavations(), stages);
  for (const scene::Excavation& excavation : model.excavations())
    if (excavation.stage() > 0 && excavation.released() < 1) stages.insert(excavation.stage() + 1);
  return stages;
}

}  // namespace

std::set<std::uint32_t> stages_of(const scene::Particles& particles) {
  std::set<std::uint32_t> stages = stages_of_excavations(particles);
  add(particles.groups(), stages);
  add(particles.joints(), stages);
  add(particles.springs(), stages);
  add(particles.bars(), stages);
  return stages;
}

std::set<std::uint32_t> stages_of(const scene::Continuum& continuum) {
  std::set<std::uint32_t> stages = stages_of_excavations(continuum);
  add(continuum.linings(), stages);
  add(continuum.bolts(), stages);
  add(continuum.members(), stages);
  add(continuum.motions(), stages);
  add(continuum.materials(), stages);
  return stages;
}

std::set<std::uint32_t> stages_of(const scene::Scene& scene) {
  std::set<std::uint32_t> stages;
  const auto merge = [&stages](const auto& part) {
    stages.merge(stages_of(part.continuum()));
    stages.merge(stages_of(part.particles()));
  };
  merge(scene);
  for (const scene::Region& region : scene.regions()) merge(region);
  add(scene.water().places(), stages);
  return stages;
}

bool imposes_displacement(const scene::Scene& scene, std::uint32_t stage) {
  const auto imposes = [stage](const auto& part) {
    return std::ranges::any_of(part.continuum().motions(), [stage](const scene::GridMotion& motion) {
      return motion.has_displacement() && motion.stage() == stage;
    });
  };
  return imposes(scene) || std::ranges::any_of(scene.regions(), imposes);
}

void require_counted_stage(const scene::Scene& scene) {
  const std::set<std::uint32_t> stages = stages_of(scene);
  if (!scene.statics().has_count_from_stage() || stages.contains(scene.statics().count_from_stage())) return;
  throw UserError("statics.count_from_stage",
                  fmt::format("is {}, but the stages of the scene are {}; give one of them",
                              scene.statics().count_from_stage(), fmt::join(stages, ", ")));
}

void require_statics(const scene::Scene& scene, std::uint32_t stage, const std::string& path) {
  if (stage == 0 || scene.has_statics()) return;
  throw UserError(path + ".stage",
                  fmt::format("is {}, but stages begin when the ground is at rest, and the scene has no "
                              "statics; give `statics: {{unbalanced_ratio: 1e-5}}`, or stage 0",
                              stage));
}

CountedFrom counted_from(const scene::Statics& statics) {
  return {statics.has_count_from_stage() || statics.keep_displacements(),
          statics.has_count_from_stage() ? statics.count_from_stage() : 1};
}

}  // namespace adit::protocol
