// The ground motion along the tunnel, from the scene's motion: through soil columns, or unchanged.
#pragma once

#include <array>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "protocol/motion/motion.hpp"
#include "simplified/scene/ground.hpp"

namespace adit::simplified {

// One direction of the ground's motion, absolute, at a few places along the tunnel and at every step; a row a
// step, from time 0. Between the places: along_chainage.hpp.
struct Shaking {
  std::size_t places = 0;
  std::vector<double> displacement, velocity, acceleration;  // [m], [m/s], [m/s^2]
  std::vector<double> rock;  // outcrop below the soil columns; empty without these [m/s^2]
  // In the middle of the wet sand of each layer that may liquefy, of the horizontal directions [Pa].
  std::vector<std::vector<double>> stress;
};

// The pore pressure of a layer that may liquefy, as a share of the effective vertical pressure at rest: 1
// where the layer has liquefied, 0 where it cannot; a row a step, as of Shaking.
struct LayerPressure {
  int number;  // from the surface down, from 0
  std::vector<double> ratio;
};

// The ground motion at the tunnel.
struct GroundField {
  std::vector<double> chainage;              // chainages of the places [m]
  std::array<Shaking, kDirections> shaking;  // empty for a direction that is not excited
  std::vector<LayerPressure> pressure;       // empty if no layer may liquefy
};

// The ground motion at the tunnel's axis, through soil columns if the scene asks for them, at time 0 and at
// `steps` steps after it.
GroundField shake(const scene::Simplified& scene, const motion::Motion& motion, double begin, double end,
                  std::size_t steps);

}  // namespace adit::simplified
