// Which engine computes a model, and why.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "dem_server/engines/engine.hpp"
#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

struct EngineChoice {
  bool lattice;
  std::string reason;  // of the general engine: "friction is asked for"
  // "lattice", or "general: friction is asked for".
  std::string told() const { return lattice ? "lattice" : "general: " + reason; }
};

// Supplies the engines of one run.
class EngineMaker {
 public:
  virtual ~EngineMaker() = default;
  // Before any engine is made. Returns what the user is told of the choice. UserError for a scene that no
  // engine here computes.
  virtual std::string choose(const scene::Scene& scene, const Model& model) = 0;
  // Of the model, and again where an overlap has weighed it.
  virtual std::unique_ptr<Engine> make(const Model& model) = 0;
  // Names the states that its engines exchange, see protocol/participant/participant.hpp.
  virtual std::string state_format() const = 0;
  // Threads that may share what is done before there is an engine, 0: as many as pay.
  virtual std::size_t threads() const { return 1; }
};

// Where the scene leaves it to us, the lattice's engine, which is faster, if it can compute the model.
// UserError at particles.engine where that is asked for and cannot.
EngineChoice choose_engine(scene::Particles::Engine wanted, const Model& model);

// Engines whose particles lie in this process's arrays. Threads share the computing, 0: as many as pay.
class LocalEngines final : public EngineMaker {
 public:
  explicit LocalEngines(std::size_t threads) : threads_(threads) {}
  std::string choose(const scene::Scene& scene, const Model& model) override;
  std::unique_ptr<Engine> make(const Model& model) override;
  std::string state_format() const override;
  std::size_t threads() const override { return threads_; }

 private:
  std::size_t threads_;
  EngineChoice choice_{};
};

}  // namespace adit::dem
