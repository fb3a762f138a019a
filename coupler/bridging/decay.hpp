// The rate at which the fine motion decays in the solve `split`.
//
// Damping that grows gradually reflects least, so the rate grows with the third power of the distance into
// the overlap. Its largest value was chosen by measurement (tests/verification/bridging/wave_test.cpp): a
// wave far too short for the grid is absorbed before it returns from the end of the fine side, while a wave
// with λ = 5h loses about 1 %. Both depend only on rate · width / wave speed, not on h, the size of the
// particles or the time step.
#pragma once

#include <span>
#include <vector>

namespace adit::coupler {

// Rate where the fine side ends [1/s], for an overlap of this width [m] and compression waves of this speed
// in the fine side [m/s].
double default_decay_rate(double wave_speed, double width);

// The share of the fine motion that each coupling point loses in a step: 1 − exp(−rate · across³ · dt).
// `across` is the position of a coupling point in the overlap: 0 where the coarse side ends, 1 where the fine
// side ends.
std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt);

}  // namespace adit::coupler
