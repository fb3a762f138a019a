// The motion of the ground ends of the soil springs; each point of the tunnel has its own ground motion.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace adit::simplified::beam {

// Ground at the support points, by direction then point.
struct GroundState {
  std::array<std::vector<double>, 3> displacement;  // [m]
  std::array<std::vector<double>, 3> velocity;      // [m/s]
  // By point: the share of the effective pressure at rest that the pore pressure has taken, 1 in liquefied
  // ground.
  std::vector<double> pressure_ratio;
};

// Fills the state, which has the size of `chainages` [m] (ascending, the same in every call of a run), for a
// time [s]. The pressure ratio may be left as it is, at first 0.
using GroundMotion = std::function<void(double time, std::span<const double> chainages, GroundState& state)>;

// Motions known at stations and equal steps of time; linear between stations and between steps, constant
// beyond the outer stations.
struct StationMotions {
  double dt = 0;                  // [s]
  std::vector<double> chainages;  // [m] strictly increasing
  // By direction (Direction of tunnel.hpp), station, step; an empty direction stands still.
  std::array<std::vector<std::vector<double>>, 3> displacement, velocity;
};

// Throws UserError (path "stations…") if sizes differ, chainages do not increase, or no step is given. The
// motion itself throws UserError if it is asked for a time after the last step.
GroundMotion interpolated(StationMotions motions);

GroundMotion still();  // no motion

}  // namespace adit::simplified::beam
