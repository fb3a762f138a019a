// Lattices of contact bonds that close on themselves, so that plane waves live in them alone; and what theory
// says of those waves.
//
// Particle (i, j) lies at i A + j B; waves go along i, the phase does not change along j. A bond joins (i, j)
// to (i + di, j + dj), at d = di A + dj B. With a = |d|, n = d / a, t its left normal and R = a / 2, a wave
// (u, spin) exp(i phase) stretches a bond by n.u (e - 1) and lets it slip by t.u (e - 1) - R spin (e + 1),
// where e = exp(i phi), phi the phase from one end to the other. The strain energy is sum (kn |stretch|^2 +
// ks |slip|^2) / 2, and with s = sin(phi/2), c = cos(phi/2), spin = -i psi the dynamical matrix of (u, psi)
// is real:
//   sum over the bonds of a cell of   4 s^2 (kn n n' + ks t t')   2 ks R sin(phi) t
//                                     2 ks R sin(phi) t'          4 ks R^2 c^2
// against the masses m, m, J: omega^2 are its eigenvalues, of P, S and rotation.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "dem_server/particles/integrate.hpp"
#include "tests/support/bond_forces.hpp"

namespace adit::dem::test {

struct BondOfCell {
  int di, dj;
};

// A lattice of discs of radius R = 0.5, seen along one of its directions.
struct LatticeDirection {
  std::string name;
  Eigen::Vector2d a, b;  // steps of i and j; b is at right angles to the wave
  std::vector<BondOfCell> bonds;
  double cell_area;
  Eigen::Vector2d rest(const BondOfCell& bond) const { return bond.di * a + bond.dj * b; }
  // Along the wave from one i to the next [m].
  double advance() const { return std::abs(a.x() * b.y() - a.y() * b.x()) / b.norm(); }
};

inline const double kRow = std::numbers::sqrt3 / 2;  // height of a row of the hexagonal lattice
inline const std::vector<LatticeDirection> kLatticeDirections = {
    {"HexagonalAlongARow", {0.5, kRow}, {0, 2 * kRow}, {{2, -1}, {1, 0}, {-1, 1}}, kRow},
    {"HexagonalAcrossTheRows", {0.5, kRow}, {1, 0}, {{0, 1}, {1, 0}, {1, -1}}, kRow},
    {"SquareAlongARow", {1, 0}, {0, 1}, {{1, 0}, {0, 1}}, 1},
    {"SquareAlongADiagonal", {1, 0}, {-1, 1}, {{1, 0}, {1, 1}}, 1}};

// The eigenmodes of the wave whose phase advances by so much from one i to the next: omega^2 ascending, and
// their vectors (u, psi) with unit masses.
struct Branches {
  Eigen::Vector3d omega_squared;
  Eigen::Matrix3d modes;  // columns
};

inline Branches in_theory(const LatticeDirection& lattice, const BondStiffness& k, double mass,
                          double phase) {
  constexpr double kRadius = 0.5;
  Eigen::Matrix3d dynamical = Eigen::Matrix3d::Zero();
  for (const BondOfCell& bond : lattice.bonds) {
    const Eigen::Vector2d n = lattice.rest(bond).normalized(), t(-n.y(), n.x());
    const double phi = bond.di * phase, s = std::sin(phi / 2), c = std::cos(phi / 2);
    dynamical.topLeftCorner<2, 2>() +=
        4 * s * s * (k.normal * n * n.transpose() + k.shear * t * t.transpose());
    dynamical.topRightCorner<2, 1>() += 2 * k.shear * kRadius * std::sin(phi) * t;
    dynamical(2, 2) += 4 * k.shear * kRadius * kRadius * c * c;
  }
  dynamical.bottomLeftCorner<1, 2>() = dynamical.topRightCorner<2, 1>().transpose();
  const double inertia = mass * kRadius * kRadius / 2;
  const Eigen::Vector3d by_root(1 / std::sqrt(mass), 1 / std::sqrt(mass), 1 / std::sqrt(inertia));
  const Eigen::Matrix3d scaled = by_root.asDiagonal() * dynamical * by_root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
  return {solver.eigenvalues(), by_root.asDiagonal() * solver.eigenvectors()};
}

// `count` particles along i, two along j, both closed.
inline Assembly periodic(const LatticeDirection& lattice, std::uint32_t count, double mass) {
  constexpr std::uint32_t kWidth = 2;
  Assembly assembly;
  Particles& p = assembly.particles;
  for (std::uint32_t j = 0; j < kWidth; ++j)
    for (std::uint32_t i = 0; i < count; ++i) {
      p.id.push_back(j * count + i);
      p.x.push_back(i * lattice.a.x() + j * lattice.b.x());
      p.y.push_back(i * lattice.a.y() + j * lattice.b.y());
    }
  for (auto* zeroed :
       {&p.ux, &p.uy, &p.settled_x, &p.settled_y, &p.vx, &p.vy, &p.spin, &p.fx, &p.fy, &p.moment})
    zeroed->assign(p.size(), 0.0);
  p.radius.assign(p.size(), 0.5);
  p.weight.assign(p.size(), 1.0);
  p.mass.assign(p.size(), mass);
  p.inertia.assign(p.size(), mass / 8);
  p.inverse_mass.assign(p.size(), 1 / mass);
  p.inverse_inertia.assign(p.size(), 8 / mass);

  Bonds& b = assembly.bonds;
  b.rest_length = 1;
  const auto wrapped = [](std::uint32_t number, int by, std::uint32_t size) {
    return static_cast<std::uint32_t>((static_cast<int>(number + size) + by) % static_cast<int>(size));
  };
  for (const BondOfCell& bond : lattice.bonds)
    for (std::uint32_t j = 0; j < kWidth; ++j)
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t first = j * count + i;
        const std::uint32_t second = wrapped(j, bond.dj, kWidth) * count + wrapped(i, bond.di, count);
        const Eigen::Vector2d rest = lattice.rest(bond);
        b.runs.push_back({static_cast<std::uint32_t>(b.size()), 1, first, second, rest.x(), rest.y()});
        b.first.push_back(first);
        b.second.push_back(second);
      }
  b.finish();
  return assembly;
}

// omega^2 of a mode as the lattice swings in it, corrected for the time step, and how much of the motion has
// left the mode at the end.
struct Swing {
  double omega_squared, astray;
};

// Struck at rest with a mode's velocities; the leap-frog's q(n) = q sin(n w dt) obeys
// q(n+1) - 2 q(n) + q(n-1) = -(omega dt)^2 q(n) exactly, omega being the lattice's.
inline Swing swing(const ContactBond& law, double phase, const Eigen::Vector3d& mode, int steps, Assembly a) {
  constexpr double kAmplitude = 1e-9, kShift = 0.7;  // [m/s], of phase: no particle is on a node by symmetry
  Particles& p = a.particles;
  const std::size_t count = p.size() / 2;
  std::vector<double> shape_x(p.size()), shape_y(p.size());
  const double dt = 0.5 * critical_step(a, law.stiffness);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double here = phase * static_cast<double>(i % count) + kShift;
    p.vx[i] = kAmplitude * mode[0] * std::cos(here);
    p.vy[i] = kAmplitude * mode[1] * std::cos(here);
    p.spin[i] = kAmplitude * mode[2] * std::sin(here);
  }
  // The mode's own coordinate: velocities weighed by mass.
  const Particles start = p;
  const auto along = [&](const std::vector<double>& vx, const std::vector<double>& vy,
                         const std::vector<double>& spin) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      sum += p.mass[i] * (start.vx[i] * vx[i] + start.vy[i] * vy[i]) + p.inertia[i] * start.spin[i] * spin[i];
    return sum;
  };
  const double norm = along(start.vx, start.vy, start.spin);
  const protocol::IndexRange all{0, static_cast<std::uint32_t>(p.size())};
  std::vector<std::uint32_t> broken;
  std::vector<double> rates{1};
  for (int n = 0; n < steps; ++n) {
    move(dt, {&all, 1}, p);
    compute_bond_forces(law, dt, p, a.bonds, broken);
    kick(protocol::Step{1, dt}, {&all, 1}, resultants_of(p), p);
    rates.push_back(along(p.vx, p.vy, p.spin) / norm);
  }
  double curved = 0, squared = 0;
  for (std::size_t n = 1; n + 1 < rates.size(); ++n) {
    curved -= rates[n] * (rates[n + 1] - 2 * rates[n] + rates[n - 1]);
    squared += rates[n] * rates[n];
  }
  double astray = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double q = rates.back();
    astray += p.mass[i] * (std::pow(p.vx[i] - q * start.vx[i], 2) + std::pow(p.vy[i] - q * start.vy[i], 2)) +
              p.inertia[i] * std::pow(p.spin[i] - q * start.spin[i], 2);
  }
  return {curved / squared / (dt * dt), std::sqrt(astray / norm)};
}

}  // namespace adit::dem::test
