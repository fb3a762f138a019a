// Quantities over time at the particles nearest to the scene's points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/assembly.hpp"
#include "protocol/history.hpp"
#include "protocol/scene.pb.h"

namespace adit::dem {

class Histories {
 public:
  // The nearest centre at rest; of two equally near ones the first. protocol::UserError for a place farther
  // than a diameter (2 radius[particle]) from all of them, and for a quantity that particles do not have.
  Histories(const scene::Particles& scene, const Particles& particles, std::span<const double> radius);

  // The velocities of these particles await the correction by another model after every step.
  void tie(std::span<const std::uint32_t> particles);

  // Before every step, after the correction of the step before.
  void remember(const Particles& particles);

  // Values at the step just made, in the scene's order and as scene.proto defines them.
  void read(const Particles& particles, const protocol::Step& step,
            google::protobuf::RepeatedField<double>& values) const;

 private:
  struct History {
    scene::Quantity quantity;
    std::uint32_t particle;
    bool tied = false;
    protocol::HalfStepVelocity velocity;  // its component
  };
  std::vector<History> histories_;
};

}  // namespace adit::dem
