// What this participant computes of a scene, and the engines of a run that it takes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/lammps/ranks/orders.hpp"
#include "dem_server/participant/choose_engine.hpp"

namespace adit::lammps {

// Paths of keys (wire.proto, Hello).
std::vector<std::string> computed();

class LammpsEngines final : public dem::EngineMaker {
 public:
  explicit LammpsEngines(Orders& orders) : orders_(orders) {}
  std::string choose(const scene::Scene& scene, const dem::Model& model) override;
  std::unique_ptr<dem::Engine> make(const dem::Model& model) override;
  std::string state_format() const override { return ""; }  // a stopped run does not go on

 private:
  Orders& orders_;
};

}  // namespace adit::lammps
