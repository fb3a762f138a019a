// A scene that can be computed.
#pragma once

#include "protocol/messages/scene.pb.h"
#include "protocol/motion/excitation/ground_motion.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {

// A checked scene, with everything that does not change during the run.
struct Setup {
  const scene::Simplified* scene = nullptr;
  Line line;                  // empty for the model column
  double begin = 0, end = 0;  // chainages between which the tunnel, or the soil profiles, reach [m]
  Clock clock{};
  motion::UsedMotion motion;
};

}  // namespace adit::simplified
