// Mohr-Coulomb's return in closed form, without branches, so that loops over many points become vector code.
//
// In principal stresses s1 >= s2 >= s3 a stress beyond the strength lies in one of these regions; each
// returns to its plane, edge or corner by Koiter's rule (mohr_coulomb.hpp), the flow of unit plastic strain
// along m taking C m = lambda tr(m) + 2 G m from the stress (Clausen, Damkilde & Andersen 2006, Int. J.
// Numer. Meth. Eng. 66):
//   F_13 alone;  T_1 alone;  F_13 and T_1, where s1 = t and s3 is the cone's;
//   F_13 and F_23, where s1 = s2;  F_13 and F_12, where s2 = s3;
//   T_1 and T_2, where s1 = s2 = t;  T_1, T_2 and T_3, where all are t;
//   the corners where s1 = t or s1 = s2 = t meet the cone.
// On an edge between two planes that mirror each other, the difference of their flows follows from the
// difference of the two stresses and the sum of their flows from the mean of the two. Where the cut-off is
// the cone's own apex, all that does not return to the shear planes or their edges returns to the apex. A
// region is the stress's where its flows are not negative and no other plane is left, within rounding.
#pragma once

#include <cmath>
#include <cstdint>

#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

struct Principal {
  double s1, s2, s3;  // largest first [Pa]
};

inline constexpr std::int64_t kOpen = -1;  // instead of bits of Yield: not returned yet
struct ConeReturn {
  Principal stress;
  std::int64_t yields;
};

// In the plane mean + radius and mean - radius, across it `across`.
[[gnu::always_inline]] inline Principal sorted(double mean, double radius, double across) {
  const double a = mean + radius, b = mean - radius;
  return {across > a ? across : a, across > a ? a : across > b ? across : b, across > b ? b : across};
}

// `to` is what sorted(from) has become. The principal directions stay, so difference and shear shrink in the
// same ratio as the circle's radius.
[[gnu::always_inline]] inline PointStress turned_back(const PointStress& from, double radius,
                                                      const Principal& to) {
  const double a = from.mean + radius, b = from.mean - radius;
  const double first = from.across > a ? to.s2 : to.s1, second = from.across > b ? to.s3 : to.s2;
  const double across = from.across > a ? to.s1 : from.across > b ? to.s2 : to.s3;
  const double ratio = radius > 0 ? 0.5 * (first - second) / radius : 0;
  return {0.5 * (first + second), ratio * from.difference, ratio * from.shear, across};
}

// A cone with what its returns need.
struct ConeFlow {
  double up, down;            // 1 + sin phi, 1 - sin phi
  double flow_up, flow_down;  // the same of psi
  double twice_c_cos, tension;
  double lame, shear;  // elastic
  double volume;       // what a unit of shear flow takes from a stress that it does not strain
  double sheared;      // shear_measure() of the plastic strain that takes a unit from s1 in shear
};

[[gnu::always_inline]] inline ConeFlow cone_flow(const Elasticity& e, const YieldCone& c) {
  const double volume = e.lame() * 2 * c.sin_dilation, up = 1 + c.sin_dilation, down = 1 - c.sin_dilation;
  const double measure = std::sqrt(2 * (up * up + down * down) - (8.0 / 3) * c.sin_dilation * c.sin_dilation);
  return {1 + c.sin_friction, 1 - c.sin_friction, up,      down,   c.twice_c_cos,
          c.tension,          e.lame(),           e.shear, volume, measure / (volume + 2 * e.shear * up)};
}

// A region's return, and whether the stress is in the region. Flows times 2 G are stresses, to which
// `rounding` compares. A comparison with what is not finite is false: without a cut-off nothing returns to
// it.
struct Region {
  bool holds;
  ConeReturn to;
};

// The stress itself where it is admissible.
[[gnu::always_inline]] inline Region within_strength(const ConeFlow& c, const Principal& s) {
  const bool holds = (c.up * s.s1 - c.down * s.s3 <= c.twice_c_cos) & (s.s1 <= c.tension);
  return {holds, {s, kElastic}};
}

[[gnu::always_inline]] inline Region in_shear(const ConeFlow& c, const Principal& s) {
  const Principal away{c.volume + 2 * c.shear * c.flow_up, c.volume, c.volume - 2 * c.shear * c.flow_down};
  const double flow =
      (c.up * s.s1 - c.down * s.s3 - c.twice_c_cos) * (1 / (c.up * away.s1 - c.down * away.s3));
  const Principal to{s.s1 - flow * away.s1, s.s2 - flow * away.s2, s.s3 - flow * away.s3};
  const bool holds = (flow >= 0) & (to.s1 >= to.s2) & (to.s2 >= to.s3) & (to.s1 <= c.tension);
  return {holds, {to, kShearNow}};
}

// The smallest principal stress of the cone where the largest is at the cut-off.
[[gnu::always_inline]] inline double at_cut_off(const ConeFlow& c) {
  return (c.up * c.tension - c.twice_c_cos) * (1 / c.down);
}

[[gnu::always_inline]] inline Region cut_off(const ConeFlow& c, const Principal& s, double rounding) {
  const double flow = (s.s1 - c.tension) * (1 / (c.lame + 2 * c.shear));
  const double s2 = s.s2 - c.lame * flow, s3 = s.s3 - c.lame * flow;
  const bool holds = (flow >= 0) & (s2 <= c.tension + rounding) & (s3 >= at_cut_off(c) - rounding);
  return {holds, {{c.tension, s2, s3}, kTensionNow}};
}

[[gnu::always_inline]] inline Region shear_and_cut_off(const ConeFlow& c, const Principal& s,
                                                       double rounding) {
  const double twice = 2 * c.shear, modulus = c.lame + twice, s3 = at_cut_off(c);
  const double of_first = c.volume + twice * c.flow_up, of_third = c.volume - twice * c.flow_down;
  const double over = s.s1 - c.tension, under = s.s3 - s3;
  const double inverse = 1 / (of_first * c.lame - of_third * modulus);
  const double in_shear = (over * c.lame - under * modulus) * inverse;
  const double in_tension = (of_first * under - of_third * over) * inverse;
  const double s2 = s.s2 - in_shear * c.volume - in_tension * c.lame;
  const bool holds = (twice * in_shear >= -rounding) & (twice * in_tension >= -rounding) &
                     (s2 <= c.tension + rounding) & (s2 >= s3 - rounding);
  return {holds, {{c.tension, s2, s3}, kShearNow | kTensionNow}};
}

[[gnu::always_inline]] inline Region two_largest(const ConeFlow& c, const Principal& s, double rounding) {
  const double mean = 0.5 * (s.s1 + s.s2), of_mean = c.volume + c.shear * c.flow_up;
  const double of_third = c.volume - 2 * c.shear * c.flow_down;
  const double sum =
      (c.up * mean - c.down * s.s3 - c.twice_c_cos) * (1 / (c.up * of_mean - c.down * of_third));
  const double unequal = (s.s1 - s.s2) * (1 / (2 * c.shear * c.flow_up)), both = mean - sum * of_mean;
  const bool holds = (c.shear * (sum - unequal) >= -rounding) & (both <= c.tension + rounding);
  return {holds, {{both, both, s.s3 - sum * of_third}, kShearNow}};
}

[[gnu::always_inline]] inline Region two_smallest(const ConeFlow& c, const Principal& s, double rounding) {
  const double mean = 0.5 * (s.s2 + s.s3), of_mean = c.volume - c.shear * c.flow_down;
  const double of_first = c.volume + 2 * c.shear * c.flow_up;
  const double sum =
      (c.up * s.s1 - c.down * mean - c.twice_c_cos) * (1 / (c.up * of_first - c.down * of_mean));
  const double unequal = (s.s2 - s.s3) * (1 / (2 * c.shear * c.flow_down)), both = mean - sum * of_mean;
  const double s1 = s.s1 - sum * of_first;
  const bool holds = (c.shear * (sum - unequal) >= -rounding) & (s1 <= c.tension + rounding);
  return {holds, {{s1, both, both}, kShearNow}};
}

[[gnu::always_inline]] inline Region two_torn(const ConeFlow& c, const Principal& s, double rounding) {
  const double sum = (s.s1 + s.s2 - 2 * c.tension) * (1 / (2 * (c.lame + c.shear))), s3 = s.s3 - c.lame * sum;
  const bool holds = (c.shear * sum - 0.5 * (s.s1 - s.s2) >= -rounding) & (s3 <= c.tension + rounding) &
                     (s3 >= at_cut_off(c) - rounding);
  return {holds, {{c.tension, c.tension, s3}, kTensionNow}};
}

[[gnu::always_inline]] inline Region three_torn(const ConeFlow& c, const Principal& s, double rounding) {
  const double over = (s.s1 - c.tension) + (s.s2 - c.tension) + (s.s3 - c.tension);
  return {(s.s3 - c.tension) - c.lame * over * (1 / (3 * c.lame + 2 * c.shear)) >= -rounding,
          {{c.tension, c.tension, c.tension}, kTensionNow}};
}

// Where two stresses at the cut-off meet the cone: F_13, F_23, T_1 and T_2 share the sums of their flows, and
// the difference s1 - s2 within them.
[[gnu::always_inline]] inline Region two_torn_corner(const ConeFlow& c, const Principal& s, double rounding) {
  const double s3 = at_cut_off(c), over = 0.5 * (s.s1 + s.s2) - c.tension, under = s.s3 - s3;
  const double a_mean = c.volume + c.shear * c.flow_up, a_third = c.volume - 2 * c.shear * c.flow_down;
  const double t_mean = c.lame + c.shear, inverse = 1 / (a_mean * c.lame - a_third * t_mean);
  const double in_shear = (over * c.lame - under * t_mean) * inverse;
  const double in_tension = (a_mean * under - a_third * over) * inverse;
  const double borne = 2 * c.shear * (c.flow_up * in_shear + in_tension);
  const bool holds = (c.shear * in_shear >= -rounding) & (c.shear * in_tension >= -rounding) &
                     (s.s1 - s.s2 <= borne + rounding);
  return {holds, {{c.tension, c.tension, s3}, kShearNow | kTensionNow}};
}

// Where one does: F_13, F_12 and T_1.
[[gnu::always_inline]] inline Region one_torn_corner(const ConeFlow& c, const Principal& s, double rounding) {
  const double s3 = at_cut_off(c), over = s.s1 - c.tension, under = 0.5 * (s.s2 + s.s3) - s3;
  const double a_first = c.volume + 2 * c.shear * c.flow_up, a_mean = c.volume - c.shear * c.flow_down;
  const double modulus = c.lame + 2 * c.shear, inverse = 1 / (a_first * c.lame - a_mean * modulus);
  const double in_shear = (over * c.lame - under * modulus) * inverse;
  const double in_tension = (a_first * under - a_mean * over) * inverse;
  const bool holds = (c.shear * in_tension >= -rounding) &
                     (2 * c.shear * c.flow_down * in_shear - (s.s2 - s.s3) >= -rounding);
  return {holds, {{c.tension, s3, s3}, kShearNow | kTensionNow}};
}

// All that is left, where the cut-off is the apex of the cone.
[[gnu::always_inline]] inline Region own_apex(const ConeFlow& c) {
  return {(c.up - c.down) * c.tension >= c.twice_c_cos * (1 - 1e-12),
          {{c.tension, c.tension, c.tension}, kShearNow | kTensionNow}};
}

// Where the stress is in the region, that one's return instead of another.
[[gnu::always_inline]] inline ConeReturn first(const Region& region, const ConeReturn& other) {
  const auto& [holds, to] = region;
  return {{holds ? to.stress.s1 : other.stress.s1, holds ? to.stress.s2 : other.stress.s2,
           holds ? to.stress.s3 : other.stress.s3},
          holds ? to.yields : other.yields};
}

// The return of most stresses, which yield in shear if at all.
[[gnu::always_inline]] inline ConeReturn to_shear_plane(const ConeFlow& c, const Principal& s) {
  return first(within_strength(c, s), first(in_shear(c, s), {s, kOpen}));
}

// The return of any stress; kOpen only by rounding.
[[gnu::always_inline]] inline ConeReturn to_cone(const ConeFlow& c, const Principal& s) {
  const double rounding = 1e-12 * (std::abs(s.s1) + std::abs(s.s2) + std::abs(s.s3) + c.twice_c_cos);
  ConeReturn found{s, kOpen};
  found = first(own_apex(c), found);
  found = first(three_torn(c, s, rounding), found);
  found = first(one_torn_corner(c, s, rounding), found);
  found = first(two_torn_corner(c, s, rounding), found);
  found = first(two_torn(c, s, rounding), found);
  found = first(two_smallest(c, s, rounding), found);
  found = first(two_largest(c, s, rounding), found);
  found = first(shear_and_cut_off(c, s, rounding), found);
  found = first(cut_off(c, s, rounding), found);
  found = first(in_shear(c, s), found);
  return first(within_strength(c, s), found);
}

}  // namespace adit::fdm
