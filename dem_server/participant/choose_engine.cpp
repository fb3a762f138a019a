#include "dem_server/participant/choose_engine.hpp"

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/model/lattice.hpp"
#include "protocol/errors.hpp"
#include "protocol/release.hpp"

namespace adit::dem {

EngineChoice choose_engine(scene::Particles::Engine wanted, const Model& model) {
  if (wanted == scene::Particles::GENERAL) return {false, "the scene asks for it"};
  const auto beyond = why_more_than_lattice(model);
  if (!beyond) return {true, ""};
  if (wanted == scene::Particles::LATTICE)
    throw protocol::UserError("particles.engine", "is lattice, but " + *beyond +
                                                      ", which it does not compute; change that, or choose "
                                                      "general or automatic");
  return {false, *beyond};
}

std::string LocalEngines::choose(const scene::Scene& scene, const Model& model) {
  choice_ = choose_engine(scene.particles().engine(), model);
  return choice_.told();
}

std::unique_ptr<Engine> LocalEngines::make(const Model& model) {
  if (choice_.lattice) return std::make_unique<LatticeEngine>(model, threads_);
  return std::make_unique<GeneralEngine>(model, threads_);
}

std::string LocalEngines::state_format() const {
  return "dem_server " + std::string(protocol::release());
}

}  // namespace adit::dem
