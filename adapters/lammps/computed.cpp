#include "adapters/lammps/computed.hpp"

#include <fmt/format.h>

#include "adapters/lammps/engine.hpp"
#include "protocol/scene/fields/computed.hpp"

namespace adit::lammps {

std::vector<std::string> computed() {
  std::vector<std::string> keys{"name", "description", "plane", "material", "time"};
  for (const char* key : {"packing", "square_packing", "random_packing", "placed", "within",
                          "remove_floaters", "engine.general", "material", "bonds", "between", "contacts",
                          "loads", "body_loads", "motions", "histories", "sections", "ovals"})
    keys.push_back(fmt::format("particles.{}", key));
  for (const char* key : {"name", "where", "number", "material", "bonds", "contacts", "bends_as_solid"})
    keys.push_back(fmt::format("particles.groups.{}", key));
  for (const char* key : {"from", "to", "bonds", "open", "name"})
    keys.push_back(fmt::format("particles.joints.{}", key));
  return keys;
}

std::string LammpsEngines::choose(const scene::Scene& scene, const dem::Model&) {
  const auto keys = computed();
  protocol::require_computed(scene, "particles", "particles", {keys.begin(), keys.end()}, kProgram);
  return fmt::format("LAMMPS, {} {}", orders_.ranks(), orders_.ranks() == 1 ? "rank" : "ranks");
}

std::unique_ptr<dem::Engine> LammpsEngines::make(const dem::Model& model) {
  return std::make_unique<LammpsEngine>(model, orders_);
}

}  // namespace adit::lammps
