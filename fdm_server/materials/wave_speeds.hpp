#pragma once

#include "fdm_server/materials/material.hpp"

namespace adit::fdm {

struct WaveSpeeds {
  double p, s;  // [m/s]
};

// Speeds of the fastest waves in the zones, elastic and of small strain: c_p = sqrt((kappa + mu) / density),
// c_s = sqrt(mu / density), in either plane condition; in wet ground with the stiffness of the water.
WaveSpeeds wave_speeds(const Ground& ground);

}  // namespace adit::fdm
