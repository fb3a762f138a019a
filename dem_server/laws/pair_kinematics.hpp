// Where two particles stand to each other and how they move: what the laws of bonds and contacts take.
//
// n is the unit vector from the first centre to the second, t its left normal, L the distance. A law gives
// the forces N along n and S along t on the first particle, tension positive, and the moment M of a bond:
//   first:  + N n + S t, moment  S arm_1 + M,     second:  - N n - S t, moment  S arm_2 - M.
// The arms reach from the centres to where the two meet and add up to L, so that linear and angular momentum
// are kept to rounding, and the power of the pair is -(N stretch_rate + S slip_rate + M turn_rate).
// (Cundall & Strack 1979, Geotechnique 29, 47.)
#pragma once

#include <cmath>

namespace adit::dem {

struct PairForces {
  double normal = 0, shear = 0, moment = 0;  // N, S, M: [N], [N], [N m]
  bool operator==(const PairForces&) const = default;
};

// Rates are of the second particle against the first.
struct PairKinematics {
  double nx, ny, length;  // n, L [m]
  double elongation;    // L - L0 [m]; L0 of a contact is the sum of the radii: its gap, negative: an overlap
  double arm_1, arm_2;  // [m]
  double stretch_rate, slip_rate, turn_rate;  // along n and t where the two meet [m/s], [rad/s]
};

// Components of a vector along n and t, and the vector that has them.
inline double along(double nx, double ny, double x, double y) {
  return x * nx + y * ny;
}
inline double across(double nx, double ny, double x, double y) {
  return y * nx - x * ny;
}
struct PlaneVector {
  double x, y;
};
inline PlaneVector vector_of(double nx, double ny, double along, double across) {
  return {along * nx - across * ny, along * ny + across * nx};
}

// Kernels take one division for 1 / L and the elongation, as divisions bound vector code. Elsewhere each
// quotient is divided, and so rounded, by itself.
enum class Division { kShared, kEach };

struct PairShape {
  double nx, ny, length, inverse_length, elongation;
};

// L^2 - L0^2 = u.(d0 + d), where u has led from d0, of length L0, to d = d0 + u. No digits are lost where u
// is small.
inline double growth_of_square(double rest_x, double rest_y, double dx, double dy, double ux, double uy) {
  return ux * (rest_x + dx) + uy * (rest_y + dy);
}

// A bond whose second particle has moved by u more than its first: L - L0 = (L^2 - L0^2) / (L + L0).
template <Division kDivision>
inline PairShape bond_shape(double rest_x, double rest_y, double rest_length, double ux, double uy) {
  const double dx = rest_x + ux, dy = rest_y + uy;
  const double length = std::sqrt(dx * dx + dy * dy), sum = length + rest_length;
  const double growth = growth_of_square(rest_x, rest_y, dx, dy, ux, uy);
  if constexpr (kDivision == Division::kEach)
    return {dx / length, dy / length, length, 1 / length, growth / sum};
  const double quotient = 1 / (length * sum), inverse_length = quotient * sum;
  return {dx * inverse_length, dy * inverse_length, length, inverse_length, growth * (quotient * length)};
}

// A contact, whose surfaces touch at the distance `touching`, wherever it was listed.
template <Division kDivision>
inline PairShape contact_shape(double rest_x, double rest_y, double touching, double ux, double uy) {
  const double dx = rest_x + ux, dy = rest_y + uy, length = std::sqrt(dx * dx + dy * dy);
  const double inverse_length = 1 / length, gap = length - touching;
  if constexpr (kDivision == Division::kEach) return {dx / length, dy / length, length, inverse_length, gap};
  return {dx * inverse_length, dy * inverse_length, length, inverse_length, gap};
}

// Two discs meet in the middle of their gap or overlap; `half_difference` is (r1 - r2) / 2.
struct Arms {
  double first, second;
};
inline Arms arms_of(double length, double half_difference) {
  return {0.5 * length + half_difference, 0.5 * length - half_difference};
}

// Speed along -t at which spins move the surfaces past each other.
inline double rolling_speed(const Arms& arms, double spin_1, double spin_2) {
  return arms.first * spin_1 + arms.second * spin_2;
}

// Slip by the shape that velocities have led to; `across` is (v2 - v1).t. Breaking takes it, and the lattice
// engine, with one arm for discs of one size: its bonds strain by less than a thousandth until they break and
// carry no shear then, so that the middle of the step would change nothing that matters.
inline double slip_rate(double across, const Arms& arms, double spin_1, double spin_2) {
  return across - rolling_speed(arms, spin_1, spin_2);
}
inline double slip_rate(double across, double arm, double spin_1, double spin_2) {
  return across - (spin_1 + spin_2) * arm;
}
// Of two discs, by the sum of their spins and the rate of turning.
inline double slip_rate(double across, double length, double half_difference, double spin_sum,
                        double turn_rate) {
  return across - (0.5 * length * spin_sum - half_difference * turn_rate);
}

// Slip by the shape in the middle of the step, where velocities stand: forces that grow by it are of second
// order, however far contacts roll and slide. The pair was shorter by `half` = dt stretch_rate / 2, of which
// the first arm has the share `share_1`; n was turned back by dt (v2 - v1).t / 2 L, which makes the velocity
// along t larger by the share `half_over_length` = half / L.
inline double mid_step_slip_rate(double across, double half, double half_over_length, const Arms& arms,
                                 double share_1, double spin_1, double spin_2) {
  return slip_rate(across * (1 + half_over_length),
                   Arms{arms.first - share_1 * half, arms.second - (1 - share_1) * half}, spin_1, spin_2);
}

// Of two discs, whose arms change by half as much each.
inline double mid_step_slip_rate(double across, double half, double half_over_length, double length,
                                 double half_difference, double spin_sum, double turn_rate) {
  return slip_rate(across * (1 + half_over_length), length - half, half_difference, spin_sum, turn_rate);
}

}  // namespace adit::dem
