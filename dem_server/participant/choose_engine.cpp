#include "dem_server/participant/choose_engine.hpp"

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/model/lattice.hpp"
#include "protocol/errors.hpp"

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

std::unique_ptr<Engine> make_engine(const EngineChoice& choice, const Model& model, std::size_t threads) {
  if (choice.lattice) return std::make_unique<LatticeEngine>(model, threads);
  return std::make_unique<GeneralEngine>(model, threads);
}

}  // namespace adit::dem
