// Static equilibrium of a grid and a lattice that are joined over an overlap, with stiffnesses taken from the
// solvers' own kernels: K u + G' λ = 0, G u = 0, and prescribed displacements. No time, no messages.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "coupler/bridging/overlap.hpp"
#include "dem_server/model/calibration.hpp"
#include "fdm_server/grid/interpolation.hpp"
#include "fdm_server/grid/samples.hpp"
#include "fdm_server/zones/elastic/elastic_zones.hpp"
#include "tests/support/bond_forces.hpp"
#include "tests/support/weighted_lattice.hpp"

namespace adit::test {

// A grid as the outer model, a lattice as the inner one, in plane stress.
struct CoupledPatch {
  double young, poisson;
  fdm::Block block;
  fdm::ZoneKind zone = fdm::ZoneKind::kAssumedStrain;
  geometry::BoundingBox packed;
  double radius;
  double floor = 1e-6;  // of the weights

  std::function<Eigen::Vector2d(double x, double y)> exact;  // displacement, prescribed on what is held
  std::function<bool(double x, double y)> is_held_point, is_held_particle;
};

struct Equilibrium {
  fdm::Grid grid;
  dem::Assembly assembly;
  std::vector<Eigen::Vector2d> grid_points, particles;  // displacements
};

// Derivatives of forces(displacements), one displacement after another. Central differences: what is of
// second order in the displacement (bonds turn) cancels, what is of third order is below rounding.
inline Eigen::MatrixXd stiffness(Eigen::Index size,
                                 const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& forces) {
  constexpr double kStep = 1e-8;
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::VectorXd u = kStep * Eigen::VectorXd::Unit(size, i);
    matrix.col(i) = (forces(-u) - forces(u)) / (2 * kStep);
  }
  return matrix;
}

// The stiffness matrix of the lattice, for x, y and rotation of each particle.
inline Eigen::MatrixXd lattice_stiffness(const CoupledPatch& patch, const dem::Assembly& assembly) {
  const double infinity = std::numeric_limits<double>::infinity();
  const dem::ContactBond law{dem::calibrate(patch.young, patch.poisson, dem::Plane::kStress), infinity,
                             infinity};
  const auto size = static_cast<Eigen::Index>(assembly.particles.size());
  // One step of unit length: the velocities are the displacements, which is what shear increments see.
  return stiffness(3 * size, [&](const Eigen::VectorXd& u) {
    dem::Assembly a = assembly;
    for (Eigen::Index i = 0; i < size; ++i) {
      a.particles.ux[i] = a.particles.vx[i] = u[3 * i];
      a.particles.uy[i] = a.particles.vy[i] = u[3 * i + 1];
      a.particles.spin[i] = u[3 * i + 2];
    }
    std::vector<std::uint32_t> broken;
    dem::test::compute_bond_forces(law, 1.0, a.particles, a.bonds, broken);
    Eigen::VectorXd f(3 * size);
    for (Eigen::Index i = 0; i < size; ++i)
      f.segment<3>(3 * i) << a.particles.fx[i], a.particles.fy[i], a.particles.moment[i];
    return f;
  });
}

// The stiffness matrix of the grid, for x and y of each grid point.
inline Eigen::MatrixXd grid_stiffness(const CoupledPatch& patch, const fdm::Grid& grid,
                                      const std::vector<double>& weights) {
  const auto size = static_cast<Eigen::Index>(grid.x.size());
  return stiffness(2 * size, [&](const Eigen::VectorXd& u) {
    fdm::ElasticZones zones(patch.zone, grid, fdm::plane_stress(patch.young, patch.poisson), weights);
    std::vector<double> vx(size), vy(size), fx(size), fy(size);
    for (Eigen::Index i = 0; i < size; ++i) vx[i] = u[2 * i], vy[i] = u[2 * i + 1];
    zones.follow(vx.data(), vy.data());
    zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
    Eigen::VectorXd f(2 * size);
    for (Eigen::Index i = 0; i < size; ++i) f.segment<2>(2 * i) << fx[i], fy[i];
    return f;
  });
}

// The equations of equilibrium: displacements x, y of the grid's points, then x, y, rotation of the
// particles, then two multipliers for each coupled particle.
struct StaticSystem {
  Eigen::Index grid_values, values;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;

  Eigen::Index of_point(std::size_t j) const { return 2 * static_cast<Eigen::Index>(j); }
  Eigen::Index of_particle(std::size_t i) const { return grid_values + 3 * static_cast<Eigen::Index>(i); }
  void prescribe(Eigen::Index value, double displacement) {
    matrix.row(value).setZero();
    matrix(value, value) = 1;
    right[value] = displacement;
  }
};

inline StaticSystem stiffness_of(const CoupledPatch& patch, const Equilibrium& parts,
                                 const std::vector<double>& zone_weights, std::size_t coupled) {
  const auto grid_values = 2 * static_cast<Eigen::Index>(parts.grid.x.size());
  const auto values = grid_values + 3 * static_cast<Eigen::Index>(parts.assembly.particles.size());
  const Eigen::Index size = values + 2 * static_cast<Eigen::Index>(coupled);
  StaticSystem system{grid_values, values, Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  system.matrix.topLeftCorner(grid_values, grid_values) = grid_stiffness(patch, parts.grid, zone_weights);
  system.matrix.block(grid_values, grid_values, values - grid_values, values - grid_values) =
      lattice_stiffness(patch, parts.assembly);
  return system;
}

// The coupled particles move as the grid does at their places.
inline void tie_to_grid(const fdm::Grid& grid, const dem::Particles& particles,
                        const std::vector<std::size_t>& coupled, StaticSystem& system) {
  std::vector<double> places;
  for (const std::size_t i : coupled) places.insert(places.end(), {particles.x[i], particles.y[i]});
  const auto rows = fdm::interpolate(grid, places);
  for (std::size_t k = 0; k < coupled.size(); ++k)
    for (Eigen::Index direction = 0; direction < 2; ++direction) {
      const Eigen::Index row = system.values + 2 * static_cast<Eigen::Index>(k) + direction;
      for (std::size_t e = 0; e < rows[k].points.size(); ++e)
        if (rows[k].shares[e] != 0) system.matrix(row, 2 * rows[k].points[e] + direction) = rows[k].shares[e];
      system.matrix(row, system.of_particle(coupled[k]) + direction) = -1;
      system.matrix.col(row).head(system.values) = system.matrix.row(row).head(system.values);
    }
}

inline void hold(const CoupledPatch& patch, const fdm::Grid& grid, const dem::Particles& particles,
                 StaticSystem& system) {
  const auto as_exact = [&](Eigen::Index first, double x, double y) {
    for (int direction = 0; direction < 2; ++direction)
      system.prescribe(first + direction, patch.exact(x, y)[direction]);
  };
  for (std::size_t j = 0; j < grid.x.size(); ++j)
    if (patch.is_held_point(grid.x[j], grid.y[j])) as_exact(system.of_point(j), grid.x[j], grid.y[j]);
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (patch.is_held_particle(particles.x[i], particles.y[i])) {
      as_exact(system.of_particle(i), particles.x[i], particles.y[i]);
      system.prescribe(system.of_particle(i) + 2, 0);
    }
  // Bonds without shear stiffness resist no spin: it stays 0.
  const double stiffest = system.matrix.topLeftCorner(system.values, system.values).cwiseAbs().maxCoeff();
  for (Eigen::Index spin = system.grid_values + 2; spin < system.values; spin += 3)
    if (std::abs(system.matrix(spin, spin)) < 1e-12 * stiffest) system.prescribe(spin, 0);
}

inline Equilibrium equilibrium(const CoupledPatch& patch, const coupler::Overlap& overlap) {
  Equilibrium result{
      fdm::make_grid(patch.block),
      dem::test::weighted_lattice(dem::test::lattice_in(patch.packed, patch.radius), overlap, patch.floor),
      {},
      {}};
  fdm::Grid& grid = result.grid;
  const dem::Particles& particles = result.assembly.particles;
  auto weights =
      fdm::zone_weights(grid, adit::test::outer_weights(overlap, fdm::sample_points(grid)), patch.floor);
  fdm::compact(grid, weights);
  std::vector<std::size_t> coupled;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (overlap.contains(particles.x[i], particles.y[i])) coupled.push_back(i);

  StaticSystem system = stiffness_of(patch, result, weights, coupled.size());
  tie_to_grid(grid, particles, coupled, system);
  hold(patch, grid, particles, system);
  const Eigen::SparseMatrix<double> sparse = system.matrix.sparseView();
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(sparse);
  Eigen::VectorXd solution = factor.solve(system.right);
  for (int pass = 0; pass < 2; ++pass) solution += factor.solve(system.right - sparse * solution);

  for (std::size_t j = 0; j < grid.x.size(); ++j)
    result.grid_points.push_back(solution.segment<2>(system.of_point(j)));
  for (std::size_t i = 0; i < particles.size(); ++i)
    result.particles.push_back(solution.segment<2>(system.of_particle(i)));
  return result;
}

// Largest deviation of a displacement from the exact one.
inline double displacement_error(const CoupledPatch& patch, const Equilibrium& e) {
  double error = 0;
  for (std::size_t j = 0; j < e.grid.x.size(); ++j)
    error = std::max(error, (e.grid_points[j] - patch.exact(e.grid.x[j], e.grid.y[j])).cwiseAbs().maxCoeff());
  const dem::Particles& p = e.assembly.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    error = std::max(error, (e.particles[i] - patch.exact(p.x[i], p.y[i])).cwiseAbs().maxCoeff());
  return error;
}

// Weighted root mean square, over the bonds, of the deviation from the exact strain: of the relative
// displacement of a bond's particles over its length.
inline double strain_error(const CoupledPatch& patch, const Equilibrium& e) {
  const dem::Particles& p = e.assembly.particles;
  const dem::Bonds& bonds = e.assembly.bonds;
  const auto deviation = [&](std::uint32_t i) -> Eigen::Vector2d {
    return e.particles[i] - patch.exact(p.x[i], p.y[i]);
  };
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    sum += bonds.weight[k] * (deviation(bonds.second[k]) - deviation(bonds.first[k])).squaredNorm();
    weights += bonds.weight[k];
  }
  return std::sqrt(sum / weights) / bonds.rest_length;
}

}  // namespace adit::test
