// Quantities over time at the particles nearest to the scene's points.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/assembly.hpp"
#include "dem_server/energy.hpp"
#include "protocol/scene.pb.h"

namespace adit::dem {

class Histories {
 public:
  // The nearest centre at rest; of two equally near ones the first. A place farther than a diameter from all
  // of them is a protocol::UserError.
  Histories(const scene::Particles& scene, const Particles& particles);

  // Values at step n in the scene's order: displacements at n since time began, and the velocities `before`,
  // those at n - 1/2 (the last final ones).
  void read(const Particles& particles, const Velocities& before,
            google::protobuf::RepeatedField<double>& values) const;

 private:
  struct History {
    scene::Quantity quantity;
    std::uint32_t particle;
  };
  std::vector<History> histories_;
};

}  // namespace adit::dem
