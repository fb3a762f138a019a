// How fast the solve `split` lets the fine motion decay.
//
// The rate is measured (tests/verification/bridging/wave_test.cpp): damping that sets in gently reflects
// least, so it grows with the third power of the way through the overlap; a wave far too short for the grid
// is then absorbed before it comes back from the end of the fine side, while of one with λ = 5h about 1 % is
// lost. Both depend on rate · width / wave speed alone, whatever h, the particles' size and the time step
// are.
#pragma once

#include <span>
#include <vector>

namespace adit::coupler {

// Rate where the fine side ends [1/s], for an overlap of this width [m] and compression waves of this speed
// in the fine side [m/s].
double default_decay_rate(double wave_speed, double width);

// The share of the fine motion that each coupling point loses in a step: 1 − exp(−rate · across³ · dt).
// `across`: how far into the overlap a coupling point lies, 0 where the coarse side ends, 1 where the fine
// side ends.
std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt);

}  // namespace adit::coupler
