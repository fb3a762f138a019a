// Ground whose grains move closer when it is sheared to and fro: each half cycle of the amplitude g of shear
// strain compacts it by
//   d(ev) = g/2 C1 exp(-C2 ev / g),
// ev being the compaction until then, positive where the ground is denser (Martin, Finn & Seed 1975, J.
// Geotech. Eng. Div. ASCE 101; the form and the constants of Byrne 1991, Int. Conf. on Recent Advances in
// Geotechnical Earthquake Engineering).
//
// A half cycle leads from one reversal to the next. Strain is the vector (exx - eyy, gamma) in the plane of
// shear, whose length is the engineering shear strain in whichever direction; it begins with a reversal. The
// distance D of the farthest point from the last reversal is 2 g at the end. A reversal counts once the
// strain has come back from the farthest point, where it was, by G = 2 r M, M being its largest distance from
// the begin: by the share r of a half cycle about the begin. The half cycle's compaction is spread over its
// way,
//   d(ev) = C1/4 exp(-C2 ev0 / a) dW,   W = 0 for D < G, 2 (D - G) for D < 2 G, D beyond,
// with the compaction ev0 at the last reversal and the amplitude a, half the larger of D and D', which is the
// distance of the half cycle before. The way to the first reversal is the second half of a half cycle: D' is
// twice as long. Equal cycles compact by Byrne's formula to rounding, and nothing jumps when a reversal
// counts late: the way back to there is made up for until 2 G. Way to and fro that is too short for a
// reversal, as that of noise, neither compacts nor ends the half cycle.
//
// r is a twentieth. The way out to M alone has compacted by C1 M/4, so that by Byrne's formula a half cycle
// of the distance G leaves exp(-0.1/r) = 14 % of what it did at the begin, and less after each further one. M
// must not forget: what a half cycle is would follow from the half cycles before, and noise, once it counts,
// would count for ever.
#pragma once

#include <cmath>
#include <cstdint>

#include "fdm_server/materials/vector_functions.hpp"

namespace adit::fdm {

struct Compaction {
  double c1, c2;
};

// Byrne's ratio of the constants.
inline Compaction compaction(double c1) {
  return {c1, 0.4 / c1};
}

// Byrne's constants for a blow count (N1)60.
inline Compaction from_blow_count(double blows) {
  return compaction(8.7 * std::pow(blows, -1.25));
}

inline constexpr double kReversalShare = 0.05;  // r

// What is known of the strain. t is exx - eyy, s is gamma.
struct HalfCycle {
  double t, s;            // now
  double from_t, from_s;  // at the last reversal
  double far_t, far_s;    // at the farthest point from there
  double distance;        // D
  double largest;         // M
  double before;          // D'
};

// sqrt(t^2 + s^2)
[[gnu::always_inline]] inline double shear_size(double t, double s) {
  return std::sqrt(t * t + s * s);
}

// A step of the strain follows in this order. It is `larger` than M; a reversal counts, and begins the next
// half cycle; the strain goes on from the farthest point. Lengths are compared by their squares where this
// saves the root.
[[gnu::always_inline]] inline bool larger(const HalfCycle& h) {
  return h.t * h.t + h.s * h.s > h.largest * h.largest;
}
// G is that of the larger of M and the strain's size.
[[gnu::always_inline]] inline bool reverses(const HalfCycle& h) {
  const auto square = [](double t, double s) { return t * t + s * s; };
  const double size = square(h.t, h.s), most = h.largest * h.largest, largest = size > most ? size : most;
  return (square(h.t - h.from_t, h.s - h.from_s) <= h.distance * h.distance) &
         (square(h.t - h.far_t, h.s - h.far_s) > 4 * kReversalShare * kReversalShare * largest);
}
[[gnu::always_inline]] inline void reverse(HalfCycle& h) {
  h.before = h.before > 0 ? h.distance : 2 * h.distance;
  h.from_t = h.far_t;
  h.from_s = h.far_s;
  h.distance = 0;
}

struct Way {
  double length;        // dW
  std::int64_t widens;  // 1 where a grows, else 0: of a width with which loops over zones become vector code
};
[[gnu::always_inline]] inline Way advance(HalfCycle& h) {
  const double counts = 2 * kReversalShare * h.largest;
  const auto way = [counts](double d) { return vectors::positive(vectors::smaller(2 * (d - counts), d)); };
  const double from = h.distance, to = shear_size(h.t - h.from_t, h.s - h.from_s);
  const bool advances = to > from;
  h.far_t = advances ? h.t : h.far_t;
  h.far_s = advances ? h.s : h.far_s;
  h.distance = vectors::larger(to, from);
  return {way(h.distance) - way(from), to > vectors::larger(from, h.before)};
}

// d(ev)/dW, which is constant while a is; `settled` is ev0. 0 before any way.
[[gnu::always_inline]] inline double compaction_by_way(const Compaction& law, const HalfCycle& h,
                                                       double settled) {
  const double amplitude = (h.distance > h.before ? h.distance : h.before) / 2;
  return amplitude > 0 ? law.c1 / 4 * vectors::exponential(-law.c2 * settled / amplitude) : 0;
}

}  // namespace adit::fdm
