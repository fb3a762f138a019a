// How a facet moves with its cells, and what its forces do to them; facet_kernel.hpp has the derivation.
// Inlined into loops over facets.
#pragma once

#include <cmath>

namespace adit::dem {

// How far a facet has come.
struct FacetMotion {
  double jump_n, jump_t;  // D [m]
  double turn;            // 2 sin of half the turn of the second cell against the first
  double nx, ny, cosine;  // n now; of half that turn
};

// What a facet does to its cells: the force on the first one [N] and the moments on both [N m].
struct FacetAction {
  double x, y, moment_1, moment_2;
};

// The spreads of a facet's elastic jump in both cells.
struct Spread {
  double first, second;
};
[[gnu::always_inline]] inline Spread spread_of(double length, double skew, double n, double t) {
  const double straight = 0.5 * length * n, across = length * skew * t;
  return {straight + across, straight - across};
}

// Of two cells: the difference of the displacements [m], sines and versines.
struct Turns {
  double dx, dy, sine_1, versine_1, sine_2, versine_2;
};
// The square of the sum of both turned unit vectors, which is 2 cos(turn / 2) long.
[[gnu::always_inline]] inline double square_of_sum(const Turns& of) {
  const double s = of.sine_1 + of.sine_2, c = 2 - (of.versine_1 + of.versine_2);
  return c * c + s * s;
}
// Root and division are slow, and few cells turn by more than 0.06 rad against their neighbours. Below,
// 1 / (2 cos(turn / 2)) is (1 - x)^(-1/2) / 2 with x = sin^2(turn / 2) up to 1e-3, of which the binomial
// series has all digits here.
[[gnu::always_inline]] inline bool is_far_turned(double square) {
  return !(square > 4 * (1 - 1e-3));
}
[[gnu::always_inline]] inline double inverse_if_near(double square) {
  const double x = 1 - 0.25 * square;
  return 0.5 + x * (1.0 / 4 + x * (3.0 / 16 + x * (5.0 / 32 + x * (35.0 / 256 + x * (63.0 / 512)))));
}

// In the frame of n at rest, r_i = (h, e) and r_j = (-h, e), and D = u_j - u_i + (R_j - 1) r_j - (R_i - 1)
// r_i, R - 1 being the matrix of -versine, -sine, sine, -versine. `inverse`: 1 / sqrt(square).
[[gnu::always_inline]] inline FacetMotion motion_of(double nx, double ny, double half_distance, double skew,
                                                    const Turns& of, double square, double inverse) {
  const double h = half_distance, e = 2 * h * skew;
  const double s = of.sine_1 + of.sine_2, v = of.versine_1 + of.versine_2, c = 2 - v;
  const double n = of.dx * nx + of.dy * ny + h * v + e * (of.sine_1 - of.sine_2);
  const double t = of.dy * nx - of.dx * ny - h * s + e * (of.versine_1 - of.versine_2);
  const double mean_c = c * inverse, mean_s = s * inverse;
  return {.jump_n = mean_c * n + mean_s * t,
          .jump_t = mean_c * t - mean_s * n,
          .turn = 2 * inverse * (of.sine_2 * (1 - of.versine_1) - of.sine_1 * (1 - of.versine_2)),
          .nx = mean_c * nx - mean_s * ny,
          .ny = mean_c * ny + mean_s * nx,
          .cosine = 0.5 * square * inverse};
}

[[gnu::always_inline]] inline FacetMotion motion_of(double nx, double ny, double half_distance, double skew,
                                                    const Turns& of) {
  const double square = square_of_sum(of);
  return motion_of(nx, ny, half_distance, skew, of, square,
                   is_far_turned(square) ? 1 / std::sqrt(square) : inverse_if_near(square));
}

// What a facet's forces do in the frame of n: on lever arms to the middle between where both cells have
// brought its middle.
[[gnu::always_inline]] inline FacetAction action_of(double half_distance, double skew, double cosine,
                                                    double sine, double jump_n, double jump_t, double normal,
                                                    double shear, double moment, double nx, double ny) {
  const double h = half_distance, e = 2 * h * skew;
  const double arm_n = cosine * h + sine * e + 0.5 * jump_n;  // of the second cell: -arm_n
  const double middle_t = cosine * e - sine * h, half_t = 0.5 * jump_t, by_shear = arm_n * shear,
               bending = cosine * moment;  // both ends part by the sine of half the turn
  return {normal * nx - shear * ny, normal * ny + shear * nx,
          by_shear - (middle_t + half_t) * normal + bending,
          (middle_t - half_t) * normal + by_shear - bending};
}

}  // namespace adit::dem
