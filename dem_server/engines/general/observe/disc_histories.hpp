// Quantities over time of discs: motions at places (histories.hpp), means over circles, forces on walls.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/observe/circles.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/participant/histories.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

class DiscHistories {
 public:
  // protocol::UserError as Histories, for circles without radius or discs, for walls that do not exist, and
  // for quantities that are none of these.
  DiscHistories(const scene::Particles& scene, const Solver& solver);

  // As those of Histories.
  void tie(std::span<const std::uint32_t> particles) { motions_.tie(particles); }
  void remember(const Particles& particles) { motions_.remember(particles); }

  // Adds the values at the step just made, in the scene's order. Circles stay where they are; strain rates
  // are of the velocities of half a step later, NaN where fewer than three discs are left in the circle.
  void read(const Solver& solver, const protocol::Step& step,
            google::protobuf::RepeatedField<double>& values) const;

 private:
  struct Measure {
    std::size_t column;  // among all histories
    scene::Quantity quantity;
    Circle circle;
    std::size_t wall;
  };
  std::vector<double> measure(const Solver& solver) const;

  Histories motions_;
  std::vector<Measure> measures_;
};

}  // namespace adit::dem
