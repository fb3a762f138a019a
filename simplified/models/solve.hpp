// Builds the models of a scene and computes their response.
#pragma once

#include <cstdint>

#include "protocol/messages/scene.pb.h"
#include "protocol/motion/excitation/ground_motion.hpp"
#include "simplified/beam/model/tunnel.hpp"
#include "simplified/chain/model/chain.hpp"
#include "simplified/output/response.hpp"
#include "simplified/scene/excitation.hpp"
#include "simplified/scene/joint.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {

struct Clock {
  double dt;  // [s]
  std::uint64_t steps;
  std::uint64_t stride;  // steps between two rows of the histories
};

// A checked scene, with everything that does not change during the run.
struct Setup {
  const scene::Simplified* scene = nullptr;
  Line line;                  // empty for the model column
  double begin = 0, end = 0;  // chainages between which the tunnel, or the soil profiles, reach [m]
  Clock clock{};
  motion::UsedMotion motion;
};

// Time between two records of the fields [s]. Velocities are derived from them, for motions up to 10 Hz.
inline constexpr double kFieldInterval = 0.02;

// The models of a checked scene, as plain numbers for the kernels.
beam::Tunnel beam_model(const scene::Simplified& scene, const Line& line);
chain::Chain chain_model(const scene::Simplified& scene, const Line& line);

// The flexibility of the lining between the centres of the two bodies beside a node. The hinge at the node
// contains it.
Flexibility lining_about(const scene::Simplified& scene, const Line& line, std::size_t node);

Response solve_beam(const scene::Simplified& scene, const Line& line, const GroundField& ground,
                    const Clock& clock);
Response solve_chain(const scene::Simplified& scene, const Line& line, const GroundField& ground,
                     const Clock& clock);
// The response of the ground at its surface.
Response solve_column(const scene::Simplified& scene, const GroundField& ground, const Clock& clock);

}  // namespace adit::simplified
