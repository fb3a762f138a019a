// Linings without ground: grid points without zones.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/solver/relaxation.hpp"
#include "fdm_server/supports/lining.hpp"

namespace adit::fdm::test {

inline constexpr double kConcrete = 30e9, kNu = 0.2, kRho = 2500;

// A wall of this thickness in plane strain.
inline Section wall(double thickness, bool shear_flexible = true) {
  return make_section(lining_material(true, kConcrete, kNu, kRho), thickness, std::pow(thickness, 3) / 12,
                      shear_flexible);
}

// Beams on the points of a grid without zones.
inline Continuum beams_alone(const Grid& grid, const Structures& structures, std::span<const double> masses,
                             std::vector<Load> loads, std::vector<PrescribedMotion> motions) {
  return {ZoneSet(ZoneKind::kAssumedStrain, grid, plane_strain(kConcrete, kNu), {}),
          masses,
          std::move(loads),
          std::move(motions),
          1,
          structures};
}

struct Frame {
  Grid grid;
  Structures structures{};
  Lining lining{};

  Frame(Grid points, bool closed, const Section& section, std::vector<LiningJoint> joints = {},
        std::array<bool, 2> held = {})
      : grid(std::move(points)) {
    Path path{{}, closed};
    for (std::uint32_t i = 0; i < grid.x.size(); ++i) path.points.push_back(i);
    lining = add_lining({"lining", path, section, std::move(joints), held[0], held[1]}, grid, structures);
  }

  std::vector<double> masses() const {
    std::vector<double> masses(grid.x.size(), 0.0);
    structures.add_masses(masses);
    return masses;
  }
  Continuum continuum(std::vector<Load> loads, std::vector<PrescribedMotion> motions = {}) const {
    return beams_alone(grid, structures, masses(), std::move(loads), std::move(motions));
  }
};

// Along x from the origin, or at this angle.
inline Grid line(double length, std::size_t beams, double angle = 0) {
  Grid grid;
  for (std::size_t i = 0; i <= beams; ++i) {
    const double s = length * static_cast<double>(i) / static_cast<double>(beams);
    grid.x.push_back(s * std::cos(angle));
    grid.y.push_back(s * std::sin(angle));
  }
  return grid;
}

// Counter-clockwise from the right.
inline Grid circle(double radius, std::size_t beams) {
  Grid grid;
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(beams);
    grid.x.push_back(radius * std::cos(angle));
    grid.y.push_back(radius * std::sin(angle));
  }
  return grid;
}

inline double constant(double /*t*/) {
  return 1;
}
inline PrescribedMotion fixed(std::vector<std::uint32_t> points, Axis axis) {
  return {std::move(points), axis, 0.0, constant};
}

// Kinetic damping, as statics do it, from step `first` on until the energy at its peaks is this share of the
// strain energy.
inline void settle(Continuum& continuum, double dt, std::uint64_t first = 0, double share = 1e-22) {
  double before = 0;
  bool stop = false;
  for (std::uint64_t n = first; n < first + 20'000'000; ++n) {
    if (stop) continuum.stop();
    Energies e{};
    continuum.step({n, dt, true, stop}, &e);
    const double now = kinetic_energy(continuum);
    stop = n > first && now < before;
    if (stop && before < share * e.strain) return;
    before = stop ? 0 : now;
  }
  FAIL() << "does not come to rest";
}

// Stiffness of all beams, measured on the kernel: translations x0 y0 x1 y1 …, then rotations.
inline Eigen::MatrixXd stiffness(std::span<const Beam> beams, std::size_t points, std::size_t rotations) {
  const std::size_t size = 2 * points + rotations;
  Eigen::MatrixXd k(size, size);
  for (std::size_t column = 0; column < size; ++column) {
    std::vector<double> vx(points), vy(points), fx(points), fy(points), rate(rotations), couple(rotations);
    (column >= 2 * points ? rate[column - 2 * points] : (column % 2 ? vy : vx)[column / 2]) = 1;
    for (Beam beam : beams)
      beam.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()}, {rate.data(), couple.data()});
    for (std::size_t i = 0; i < points; ++i) {
      k(2 * i, column) = -fx[i];
      k(2 * i + 1, column) = -fy[i];
    }
    for (std::size_t i = 0; i < rotations; ++i) k(2 * points + i, column) = -couple[i];
  }
  return k;
}

inline Eigen::VectorXd inertias(std::span<const Beam> beams, std::size_t points, std::size_t rotations) {
  Eigen::VectorXd m = Eigen::VectorXd::Zero(2 * points + rotations);
  for (const Beam& beam : beams)
    for (int end = 0; end < 2; ++end) {
      m[2 * beam.points()[end]] += beam.end_mass();
      m[2 * beam.points()[end] + 1] += beam.end_mass();
      m[2 * points + beam.rotations()[end]] += beam.end_inertia();
    }
  return m;
}

// Squares of the circular frequencies of the free degrees of freedom, ascending.
inline Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& k, const Eigen::VectorXd& m,
                                   const std::vector<Eigen::Index>& free) {
  const Eigen::VectorXd root = m(free).array().rsqrt();
  const Eigen::MatrixXd scaled = root.asDiagonal() * k(free, free) * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
}

inline std::vector<Eigen::Index> all(const Eigen::VectorXd& m) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < m.size(); ++i) free.push_back(i);
  return free;
}

}  // namespace adit::fdm::test
