// What stages of excavation ask of a scene.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Stage 0, each in which something is excavated, begins, is installed, changed or moved, and each in which
// what an excavation has held is let go.
std::set<std::uint32_t> stages_of(const scene::Particles& particles);
std::set<std::uint32_t> stages_of(const scene::Continuum& continuum);
std::set<std::uint32_t> stages_of(const scene::Scene& scene);  // of all models

// Whether statics impose a displacement in this stage, on any model.
bool imposes_displacement(const scene::Scene& scene, std::uint32_t stage);

// UserError at `path`.stage for a stage after 0 in a scene without statics.
void require_statics(const scene::Scene& scene, std::uint32_t stage, const std::string& path);

// UserError where displacements shall count from a stage that the scene does not have.
void require_counted_stage(const scene::Scene& scene);

// The stage from whose beginning displacements count, where they do not count from the beginning of time.
struct CountedFrom {
  bool stage_given;     // else they count from the beginning of time
  std::uint32_t stage;  // 1 where the scene only keeps displacements
  // Whether what a step from one stage to another passes is the beginning of the count.
  bool begins(std::uint32_t from, std::uint32_t to) const { return from < stage && to >= stage; }
};
CountedFrom counted_from(const scene::Statics& statics);

}  // namespace adit::protocol
