// A joint of the beam model between two bodies of particles in plan.
#pragma once

#include "protocol/messages/scene.pb.h"
#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified {

// A hexagonal packing across the tunnel's axis at y = 0, the joint's line between two of its columns.
struct PlanPacking {
  double joint;  // chainage [m]
  double width;  // of all rows together [m]
  int rows;
  double radius() const;         // rows sqrt(3) R = width [m]
  double row(int number) const;  // y of its centres [m]
};

// Adds the joint's line, called `joint`, its springs and the histories of both. Gaskets and other springs
// along the axis act at their places across it, each shared by the two nearest rows: `gasket_1`, ... and
// `spring_1`, ... from the lowest row up; the lateral keys, `key_1`, ..., are spread over the faces. What the
// line parts does not touch: the bodies of an immersed tunnel stand apart by the gasket, which alone knows
// how they meet.
void add_joint(const beam::Joint& joint, const scene::Joints& group, const PlanPacking& packing,
               scene::Particles& particles);

}  // namespace adit::simplified
