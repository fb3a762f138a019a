#include "fdm_server/structures/beam.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {

Chord chord(double x1, double y1, double x2, double y2) {
  const double length = std::hypot(x2 - x1, y2 - y1);
  return {(x2 - x1) / length, (y2 - y1) / length, length};
}

Beam::Beam(std::array<std::uint32_t, 2> points, std::array<std::uint32_t, 2> rotations, const Chord& chord,
           const Section& section)
    : points_(points),
      rotations_(rotations),
      chord_(chord),
      axial_(section.axial / chord.length),
      bending_(section.bending / chord.length),
      mass_(section.mass * chord.length / 2),
      inertia_(3 * section.rotary * chord.length / 2 + mass_ * section.offset * section.offset),
      // An infinite shear stiffness gives phi = 0, the beam of Euler and Bernoulli.
      phi_(12 * section.bending / (section.shear * chord.length * chord.length)),
      eccentricity_(section.eccentricity + section.offset),
      offset_(section.offset) {
  shear_ = 3 * bending_ / (1 + phi_);
}

double Beam::critical_step() const {
  const double extension = 2 * axial_ / mass_, bending = 2 * bending_ / inertia_;
  const double shear = shear_ * (8 / (mass_ * chord_.length * chord_.length) + 2 / inertia_);
  // An eccentric elongation turns the ends, too.
  const double turning = 2 * axial_ * eccentricity_ * eccentricity_ / inertia_;
  const double half = (extension + turning + bending) / 2,
               coupled = half + std::sqrt(half * half - extension * bending);
  return 2 / std::sqrt(std::max({turning > 0 ? coupled : extension, bending, shear}));
}

std::array<StrainForm, 3> Beam::strains() const {
  const auto [p, q] = points_;
  const auto [i, j] = rotations_;
  const auto [x, y, length] = chord_;
  const double lever = 2 / length;
  using enum Freedom::Kind;
  StrainForm elongation{axial_, {{{kX, p}, -x}, {{kY, p}, -y}, {{kX, q}, x}, {{kY, q}, y}}};
  if (eccentricity_ != 0) {
    elongation.shares.push_back({{kRotation, i}, -eccentricity_});
    elongation.shares.push_back({{kRotation, j}, eccentricity_});
  }
  return {elongation, StrainForm{bending_, {{{kRotation, i}, -1}, {{kRotation, j}, 1}}},
          StrainForm{shear_,
                     {{{kRotation, i}, 1},
                      {{kRotation, j}, 1},
                      {{kX, p}, -lever * y},
                      {{kY, p}, lever * x},
                      {{kX, q}, lever * y},
                      {{kY, q}, -lever * x}}}};
}

BeamStrains Beam::rates(const PointView& points, const RotationView& rotations) const {
  const auto [p, q] = points_;
  const auto [i, j] = rotations_;
  const double vx = points.vx[q] - points.vx[p], vy = points.vy[q] - points.vy[p];
  const double along = chord_.x * vx + chord_.y * vy, across = chord_.x * vy - chord_.y * vx;
  const double lever = 2 / chord_.length;
  const double bending = rotations.rate[j] - rotations.rate[i];
  return {along + offset_ * bending, bending, rotations.rate[i] + rotations.rate[j] - lever * across};
}

void Beam::add_forces(double dt, const PointView& points, const RotationView& rotations) {
  const auto [e, b, a] = rates(points, rotations);
  const auto& [thrust, couple, skew] = forces_;
  add_forces(BeamResultants{thrust + dt * axial_ * e, couple + dt * bending_ * b, skew + dt * shear_ * a},
             points, rotations);
}

BeamResultants Beam::resists(const BeamStrains& strains) const {
  return {axial_ * strains.e, bending_ * strains.b, shear_ * strains.a};
}

void Beam::add_forces(const BeamResultants& forces, const Chord& along, const PointView& points,
                      const RotationView& rotations) {
  forces_ = forces;
  const auto [n, b, s] = forces_;
  const auto [p, q] = points_;
  const auto [i, j] = rotations_;
  const double q_force = -2 / along.length * s;
  const double fx = along.x * n - along.y * q_force, fy = along.y * n + along.x * q_force;
  points.fx[p] += fx;
  points.fy[p] += fy;
  points.fx[q] -= fx;
  points.fy[q] -= fy;
  const double about_points = b + offset_ * n;
  rotations.couple[i] += about_points - s;
  rotations.couple[j] -= about_points + s;
}

BeamForces Beam::forces() const {
  const auto [n, b, s] = forces_;
  return {n, -2 / chord_.length * s, b - s, b + s};
}

double Beam::elastic_energy(const BeamResultants& forces) const {
  const auto& [n, b, s] = forces;
  return (n * n / axial_ + b * b / bending_ + s * s / shear_) / 2;
}

}  // namespace adit::fdm
