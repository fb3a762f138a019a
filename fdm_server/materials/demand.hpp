// How much of its strength a stress uses: 0 without stress, 1 at the limit. Tension positive.
//
// Mohr and Coulomb, s1 >= s2 >= s3 the principal stresses, p = (s1 + s3)/2 and r = (s1 - s3)/2: the larger of
//   tension  s1 / t,
//   shear    r / (c cos phi - p sin phi) under a mean compression, p < 0,
//            (r + p sin phi) / (c cos phi) under a mean tension.
// Under compression this is the radius of Mohr's circle over the largest that the strength allows with the
// same mean stress. Under tension the mean counts as load, so that the share stays finite and reaches 1 at
// the apex of the cone. Both are 1 on the yield planes of mohr_coulomb.hpp, and between them only.
//
// A weak plane likewise, with the traction on it, normal s_n and shear tau: the larger of s_n / t and
//   |tau| / (c - s_n tan phi) for s_n < 0,   (|tau| + s_n tan phi) / c else.
#pragma once

#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/weak_plane.hpp"

namespace adit::fdm {

double demand(const YieldCone& cone, const PointStress& stress);
double demand(const PlaneStrength& plane, const PlaneDirection& direction, const PointStress& stress);

}  // namespace adit::fdm
