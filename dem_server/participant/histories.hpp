// Quantities over time at the particles nearest to the scene's points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/particles/assembly.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/participant/history.hpp"

namespace adit::dem {

// Displacement, velocity or acceleration.
bool is_motion(scene::Quantity quantity);

class Histories {
 public:
  enum class Others { kRefused, kLeftOut };
  // The nearest centre at rest; of two equally near ones the first. protocol::UserError for a place farther
  // than a diameter (2 radius[particle]) from all of them, and for quantities other than motions, unless they
  // are left out.
  Histories(const scene::Particles& scene, const Particles& particles, std::span<const double> radius,
            Others others = Others::kRefused);

  // The velocities of these particles await the correction by another model after every step.
  void tie(std::span<const std::uint32_t> particles);

  // Before every step, after the correction of the step before.
  void remember(const Particles& particles);

  // Adds the values at the step just made, in the scene's order and as scene.proto defines them.
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
