// Which engine computes a model, and why.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "dem_server/engines/engine.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

struct EngineChoice {
  bool lattice;
  std::string reason;  // of the general engine: "friction is asked for"
  // "lattice", or "general: friction is asked for".
  std::string told() const { return lattice ? "lattice" : "general: " + reason; }
};

// Where the scene leaves it to us, the lattice's engine, which is faster, if it can compute the model.
// UserError at particles.engine where that is asked for and cannot.
EngineChoice choose_engine(scene::Particles::Engine wanted, const Model& model);

// Threads that share the computing, 0: as many as pay.
std::unique_ptr<Engine> make_engine(const EngineChoice& choice, const Model& model, std::size_t threads);

}  // namespace adit::dem
