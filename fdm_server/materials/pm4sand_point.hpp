// One point of PM4Sand (pm4sand.hpp), to be compiled for many at once.
//
// A deviatoric tensor a of the report is the vector of its axx and axy, its n is the unit vector u over
// sqrt(2): a:n = sqrt(2) a.u. The shear strain that flows along u is g = sqrt(2) L, so that
//   ds = G (de - g u),   dp = (K + G/3) d(ev) - K D/sqrt(2) g,
//   g = (G u.de - (s.u/p) (K + G/3) d(ev)) / (G + K_p/2 - K D/sqrt(2) (s.u/p)),
// de being the increments of (exx - eyy, gamma) and ev the compaction. The bounding and dilatancy surfaces
// meet u at alpha^b = (M^b - m)/2 u and alpha^d = (M^d - m)/2 u.
#pragma once

#include "fdm_server/materials/pm4sand.hpp"
#include "fdm_server/materials/vector_functions.hpp"

namespace adit::fdm::pm4sand {

using namespace vectors;

// The report's defaults of the other secondary parameters.
inline constexpr double kAtmosphere = 101.3e3;             // pA [Pa]
inline constexpr double kQ = 10, kR = 1.5;                 // of the critical state line
inline constexpr double kCritical = 2 * kPm4SandSine;      // M
inline constexpr double kBounding = 0.5, kDilating = 0.1;  // n^b, n^d
inline constexpr double kYield = 0.01;                     // m
inline constexpr double kFabricRate = 250;                 // c_z
inline constexpr double kFabricSoftening = 2;              // C_GD
inline constexpr double kMostVoids = 0.8, kLeastVoids = 0.5;

inline constexpr double kRoot2 = std::numbers::sqrt2;

// What follows from the parameters.
struct Constants {
  double modulus;                // G0 pA [Pa]
  double largest_pressure;       // beyond which G stays [Pa]
  double contraction;            // h_po
  double hardening;              // h_0
  double density_by_compaction;  // d(D_R)/d(ev)
  double fabric_shear;           // C_DR
  double fabric_stiffening;      // C_kaf
  double dilatancy_loss;         // c_eps^2
  double least_reduction;        // the least F_sed: 1 if the shaking goes on
};

[[gnu::always_inline]] inline double dot(PlaneVector a, PlaneVector b) {
  return a.t * b.t + a.s * b.s;
}
// a:n
[[gnu::always_inline]] inline double along(PlaneVector a, PlaneVector u) {
  return kRoot2 * dot(a, u);
}
[[gnu::always_inline]] inline double length(PlaneVector a) {
  return root(dot(a, a));
}
[[gnu::always_inline]] inline PlaneVector operator+(PlaneVector a, PlaneVector b) {
  return {a.t + b.t, a.s + b.s};
}
[[gnu::always_inline]] inline PlaneVector operator-(PlaneVector a, PlaneVector b) {
  return {a.t - b.t, a.s - b.s};
}
[[gnu::always_inline]] inline PlaneVector operator*(double f, PlaneVector a) {
  return {f * a.t, f * a.s};
}
// Of length 1, or 0 where the vector has none.
[[gnu::always_inline]] inline PlaneVector unit(PlaneVector a) {
  return 1 / larger(length(a), 1e-300) * a;
}
[[gnu::always_inline]] inline PlaneVector choose(bool first, PlaneVector a, PlaneVector b) {
  return {vectors::choose(first, a.t, b.t), vectors::choose(first, a.s, b.s)};
}

struct Surfaces {
  double xi, bounding, dilatancy;  // xi_R, M^b, M^d
};
[[gnu::always_inline]] inline Surfaces surfaces(double density, double p) {
  const double xi = kR / (kQ - logarithm(100 / kAtmosphere * p)) - density;
  const bool dense = xi <= 0;
  return {xi, kCritical * exponential(vectors::choose(dense, -kBounding, -kBounding / 4) * xi),
          kCritical * exponential(vectors::choose(dense, kDilating, 4 * kDilating) * xi)};
}

// G, which falls with the stress ratio's share of M^b, and with the fabric.
[[gnu::always_inline]] inline double shear_modulus(const Constants& c, const Pm4SandState& q,
                                                   const Pm4SandStress& stress, double bounding) {
  const double p = larger(stress.pressure, q.least_pressure), z_max = q.largest_fabric;
  const double share = smaller(4 * dot(stress.shear, stress.shear) / square(p * bounding), 1);  // squared
  return c.modulus * root(smaller(p, c.largest_pressure) * (1 / kAtmosphere)) * (1 - 0.5 * square(share)) *
         (z_max + q.fabric_sum) / (z_max + kFabricSoftening * q.fabric_sum);
}

// F_sed, M^d being `dilating`. (p/(20 p_sed))^2 in one division: by p_sed^2 (z_cum + z_max)^2.
[[gnu::always_inline]] inline double reduction(const Constants& c, const Pm4SandState& q,
                                               const Pm4SandStress& stress, double dilating) {
  const double p = larger(stress.pressure, q.least_pressure), z_sum = q.fabric_sum;
  const double below = positive(1 - 2 * length(stress.shear) / (p * dilating));  // 1 - M_cur/M^d
  const double share = square(stress.pressure * (z_sum + q.largest_fabric)) /
                       larger(square(4 * kAtmosphere * z_sum) * root(below), 1e-30);
  return smaller(c.least_reduction + (1 - c.least_reduction) * share, 1);
}

// Plastic loading along u.
struct Loading {
  double plastic_modulus;  // K_p/2
  double dilatancy;        // D/sqrt(2): compaction by shear strain
  double pull;             // of alpha towards alpha^b, by shear strain
  double fabric_rate;      // of z towards -z_max u/sqrt(2), by shear strain
  double bounding;         // M^b
  double dilating;         // M^d
};

[[gnu::always_inline]] inline Loading loading(const Constants& c, const Pm4SandState& q,
                                              const Pm4SandStress& stress, PlaneVector u) {
  const double p_min = q.least_pressure, p = larger(stress.pressure, p_min), by_p = 1 / p;
  const double z_max = q.largest_fabric, by_z = 1 / z_max, z_sum = q.fabric_sum, z_peak = q.fabric_peak;
  const auto [xi, bounding, dilating] = surfaces(q.density, p);
  const double alpha = along(q.alpha, u), z = along(q.fabric, u);
  const double opposed = kRoot2 * by_z * positive(-z) / 2, aligned = positive(z);
  const double to_bounding = (bounding - kYield) / kRoot2 - alpha;  // (alpha^b - alpha):n
  const double to_dilating = (dilating - kYield) / kRoot2 - alpha;
  const double since_apparent = alpha - along(q.apparent, u), from_apparent = positive(since_apparent);
  const double from_start = positive(alpha - along(q.start, u));
  const double c_zpk1 = z_peak / (z_sum + z_max / 5);
  const double c_zpk2 = smaller(z_peak / (z_sum + z_max / 100), 1 - 1e-10);

  // K_p. On a way that goes on beyond where the one before began, the way since the true reversal counts.
  const double lost = positive(q.fabric_pressure - p), c_g1 = c.hardening / 200;
  const double c_ka =
      1 + c.fabric_stiffening * lost * c_zpk1 / ((1 + square(2.5 * from_start)) * (lost + p_min));
  const double by_apparent =
      vectors::choose(alpha - along(q.before, u) <= 0, (from_apparent + c_g1) / (from_start + c_g1), 1);
  const double hardening =  // 2/3 h p
      q.reduction * q.shear_modulus * c.hardening * c_ka * by_apparent /
      ((exponential(from_apparent) - 1 + c_g1) * larger(root(to_bounding), 1e-5) *
       (1 + 2 * by_z * z_peak * positive(to_bounding) * root(1 - c_zpk2)));
  const double plastic = hardening * to_bounding;

  // The dilatancy surface, turned by the fabric.
  const double c_zin1 = 1 - exponential(-2 * by_z * std::abs(along(q.fabric_start, u) - z));
  const double to_turned = (dilating / (1 + 2 * opposed * (1 - c_zin1)) - kYield) / kRoot2 - alpha;
  const bool dilates = to_turned <= 0;

  // D where sand dilates.
  const double r = 2.5 * p / q.fabric_pressure, r2 = r * r, c_pzp = 1 / (1 + r2 * r2 * r);
  const double c_pmin = 1 / (1 + square(10 * p_min * by_p));
  const double since_peak = c_zin1 * (z_sum - z_peak) * by_z;
  const double c_zin2 = (1 + since_peak / 3) / (1 + since_peak);
  const double free = 1 - opposed * z_max / z_peak;
  const double a_d =
      q.dilatancy * c_zin2 /
      (z_sum * z_sum * by_z * (free * free * free) * c.dilatancy_loss * c_pzp * c_pmin * c_zin1 + 1);
  const double plain = a_d * to_dilating, turned = a_d * opposed * to_turned / c.fabric_shear;
  const double room = positive(bounding - 2 * by_p * length(stress.shear));
  const double dilation =
      vectors::choose(plain > turned, plain + (turned - plain) * room / (room + 0.01), plain);
  const double at_low_pressure = -3.5 * q.dilatancy * positive(bounding - dilating) * (2 - p / p_min);

  // D where it contracts.
  const double h_p = c.contraction * exponential(-0.7 + 7 * square(positive(0.5 - xi)));
  const double c_rot2 = 1 - c_zpk2;
  const double c_dz = larger((z_max - c_rot2 * kRoot2 * z_peak) / (z_max + c_rot2 * z_sum), 2 / (2 + z_max));
  const double a_dc = q.dilatancy * (1 + aligned) / (h_p * c_dz), c_in = kRoot2 * by_z * aligned;
  const double c_pmin2 = smaller(positive(p / p_min - 2) / 16, 1);
  const double contraction = smaller(a_dc * square(since_apparent + c_in), 1.5 * q.dilatancy) * to_dilating /
                             (to_dilating + 0.16) * c_pmin2;

  const double dilatancy = vectors::choose(
      dilates, vectors::choose(p <= 2 * p_min, smaller(dilation, at_low_pressure), dilation), contraction);
  const bool fabric_grows = (to_dilating < 0) & (dilatancy < 0);
  return {0.5 * vectors::choose(dilates, plastic, positive(plastic)),
          dilatancy / kRoot2,
          hardening * by_p / kRoot2,
          vectors::choose(fabric_grows, kFabricRate / kRoot2 / (1 + positive(z_sum * by_z / 2 - 1)), 0),
          bounding,
          dilating};
}

// Where loading turns back: alpha has gone back, along the new u, behind where the way began. The apparent
// alpha_in, by component, is what keeps a small loop from being as stiff as a first loading: the least that
// alpha_in ever was on the side where the loading goes, but alpha itself where sxy changes sides.
[[gnu::always_inline]] inline void reverse(double pressure, PlaneVector u, Pm4SandState& q) {
  const bool reverses = dot(q.alpha - q.start, u) < 0;
  const double p = larger(pressure, q.least_pressure), product = kRoot2 * length(q.fabric) * p;
  const bool largest = reverses & (product > q.fabric_product) & (p > q.fabric_pressure);
  q.fabric_product = vectors::choose(largest, product, q.fabric_product);
  q.fabric_pressure = vectors::choose(largest, p, q.fabric_pressure);
  const bool same_side = q.alpha.s * q.apparent.s > 0;
  q.before = choose(reverses, q.apparent, q.before);
  q.start = choose(reverses, q.alpha, q.start);
  q.fabric_start = choose(reverses, q.fabric, q.fabric_start);
  const auto component = [&](double alpha, double along, double& apparent, double& least, double& most) {
    least = vectors::choose(reverses & (apparent >= 0), smaller(least, alpha), least);
    most = vectors::choose(reverses & (apparent <= 0), larger(most, alpha), most);
    const double of_history = vectors::choose(along > 0, positive(least), smaller(most, 0));
    apparent = vectors::choose(reverses, vectors::choose(same_side, of_history, alpha), apparent);
  };
  component(q.alpha.t, u.t, q.apparent.t, q.least.t, q.most.t);
  component(q.alpha.s, u.s, q.apparent.s, q.least.s, q.most.s);
}

// Elastic until the yield surface is met, then a step of Euler's.
[[gnu::always_inline]] inline void strain(const Constants& c, double compaction, PlaneVector shear,
                                          Pm4SandStress& stress, Pm4SandState& q) {
  const double g = q.reduction * q.shear_modulus, k = kPm4SandBulk * g, p = stress.pressure;
  // With K + G/3 ~ sqrt(p) to its end.
  const double squeezed = p * (square(positive(1 + (k + g / 3) * compaction / (2 * p))) - 1);
  q.density += c.density_by_compaction * compaction;
  const PlaneVector from = stress.shear - p * q.alpha, by = g * shear - squeezed * q.alpha;
  const double radius = 0.5 * kYield * (p + squeezed);
  const bool yields = length(from + by) > radius;
  reverse(p, unit(from + by), q);

  // The share of the strain at which |from + share by| is the radius.
  const double by2 = dot(by, by), way = dot(by, from), inside = positive(radius * radius - dot(from, from));
  const double met = (root(way * way + by2 * inside) - way) / larger(by2, 1e-300);
  const double elastic = vectors::choose(yields, smaller(positive(met), 1), 1), rest = 1 - elastic;
  // Where the elastic end leads, not where the surface is met: strain along the surface turns u, too, and may
  // be larger in a step than the surface is wide.
  const PlaneVector u = unit(from + by);
  stress.pressure += elastic * squeezed;
  stress.shear = stress.shear + elastic * g * shear;

  const Loading l = loading(c, q, stress, u);
  const double ratio = dot(stress.shear, u) / larger(stress.pressure, q.least_pressure);
  const double slip = positive(rest * (g * dot(shear, u) - ratio * squeezed) /
                               larger(g + l.plastic_modulus - k * l.dilatancy * ratio, 0.01 * g));
  q.alpha = q.alpha + smaller(l.pull * slip, 1) * (0.5 * (l.bounding - kYield) * u - q.alpha);
  const PlaneVector grown = -l.fabric_rate * slip * (q.largest_fabric / kRoot2 * u + q.fabric);
  q.fabric = q.fabric + grown;
  q.fabric_sum += length(grown);
  q.fabric_peak = larger(q.fabric_peak, length(q.fabric));

  // The end is on the yield surface where u leads. The sum of the increments of s misses it by second order,
  // which may be more than the surface is wide, and would then look like a reversal.
  stress.pressure = larger(stress.pressure + rest * squeezed - k * l.dilatancy * slip, q.least_pressure / 5);
  stress.shear = choose(yields, stress.pressure * (q.alpha + 0.5 * kYield * u), stress.shear);
  q.shear_modulus = shear_modulus(c, q, stress, l.bounding);
  q.reduction = reduction(c, q, stress, l.dilating);
}

}  // namespace adit::fdm::pm4sand
