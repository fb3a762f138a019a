// Requirement (physics of the method): a uniform strain passes through the overlap, so that neither the
// weights nor the multipliers make forces of their own. Static equilibrium of the whole coupled system, with
// stiffnesses taken from the solvers' own kernels, must give that strain to 1e-12 of it.
//
// Zones are whole multiples of the lattice's spacings (5 x 2R wide, 2 rows high), so that the sums over
// particles equal the integrals over zones. With ν = 1/3 slanting bonds carry nothing in uniaxial stress: for
// any other ν a lattice with n rows has only n − 1 layers of them, so that its free surfaces alone make it
// strain otherwise than a continuum of the same height, coupled or not.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "coupler/bridging/overlap.hpp"
#include "dem_server/assembly.hpp"
#include "dem_server/contact_forces.hpp"
#include "dem_server/packing.hpp"
#include "fdm_server/grid.hpp"
#include "fdm_server/interpolation.hpp"
#include "fdm_server/zones.hpp"

namespace adit {
namespace {

constexpr double kYoung = 1.0, kPoisson = 1.0 / 3;
constexpr double kRadius = 0.5, kLength = 40.0;
constexpr double kHeight = 6 * std::numbers::sqrt3 * kRadius;
constexpr double kBegin = 15.0, kEnd = 25.0;  // of the overlap
constexpr double kStrain = 1e-3;

scene::Overlap overlap_message() {
  scene::Overlap overlap;
  overlap.mutable_particles_begin()->set_x(kBegin);
  overlap.mutable_particles_begin()->set_y(0);
  overlap.mutable_continuum_ends()->set_x(kEnd);
  overlap.mutable_continuum_ends()->set_y(0);
  return overlap;
}

// Derivatives of forces(displacements), one displacement after another. Central differences: what is of
// second order in the displacement (bonds turn) cancels, what is of third order is below rounding.
Eigen::MatrixXd stiffness(Eigen::Index size,
                          const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& forces) {
  constexpr double kStep = 1e-8;
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::VectorXd u = kStep * Eigen::VectorXd::Unit(size, i);
    matrix.col(i) = (forces(-u) - forces(u)) / (2 * kStep);
  }
  return matrix;
}

struct Lattice {
  dem::Assembly assembly;
  Eigen::MatrixXd stiffness;  // x, y, rotation of each particle
};

Lattice make_lattice(const coupler::Overlap& overlap) {
  const dem::Packing packing = dem::pack_hexagonally({0, kLength, 0, kHeight}, kRadius);
  std::vector<double> centres, midpoints;
  for (std::size_t i = 0; i < packing.x.size(); ++i)
    centres.insert(centres.end(), {packing.x[i], packing.y[i]});
  for (const auto& link : packing.links) {
    midpoints.push_back((packing.x[link.first] + packing.x[link.second]) / 2);
    midpoints.push_back((packing.y[link.first] + packing.y[link.second]) / 2);
  }
  const auto at_centres = overlap.particle_weights(centres),
             at_midpoints = overlap.particle_weights(midpoints);
  Lattice lattice;
  lattice.assembly = dem::assemble(packing, 1.0, {at_centres, at_midpoints, 1e-6});
  const double infinity = std::numeric_limits<double>::infinity();
  const dem::BondLaw law{dem::calibrate(kYoung, kPoisson, dem::Plane::kStress), infinity, infinity};
  const auto size = static_cast<Eigen::Index>(lattice.assembly.particles.size());
  // One step of unit length: the velocities are the displacements, which is what shear increments see.
  lattice.stiffness = stiffness(3 * size, [&](const Eigen::VectorXd& u) {
    dem::Assembly a = lattice.assembly;
    for (Eigen::Index i = 0; i < size; ++i) {
      a.particles.ux[i] = a.particles.vx[i] = u[3 * i];
      a.particles.uy[i] = a.particles.vy[i] = u[3 * i + 1];
      a.particles.spin[i] = u[3 * i + 2];
    }
    std::vector<std::uint32_t> broken;
    dem::compute_contact_forces(law, 1.0, a.particles, a.bonds, broken);
    Eigen::VectorXd f(3 * size);
    for (Eigen::Index i = 0; i < size; ++i)
      f.segment<3>(3 * i) << a.particles.fx[i], a.particles.fy[i], a.particles.moment[i];
    return f;
  });
  return lattice;
}

struct Mesh {
  fdm::Grid grid;
  Eigen::MatrixXd stiffness;  // x, y of each grid point
};

Mesh make_mesh(const coupler::Overlap& overlap, fdm::ZoneKind kind) {
  const fdm::Block block{0, kLength, 0, kHeight, 8, 3};
  Mesh mesh{fdm::make_grid(block), {}};
  auto weights = fdm::zone_weights(block, overlap.continuum_weights(fdm::sample_points(block)), 1e-6);
  fdm::compact(mesh.grid, weights);
  const auto size = static_cast<Eigen::Index>(mesh.grid.x.size());
  mesh.stiffness = stiffness(2 * size, [&](const Eigen::VectorXd& u) {
    const auto zones = fdm::make_zones(kind, mesh.grid, fdm::plane_stress(kYoung, kPoisson), weights);
    std::vector<double> vx(size), vy(size), fx(size), fy(size);
    for (Eigen::Index i = 0; i < size; ++i) vx[i] = u[2 * i], vy[i] = u[2 * i + 1];
    zones->add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
    Eigen::VectorXd f(2 * size);
    for (Eigen::Index i = 0; i < size; ++i) f.segment<2>(2 * i) << fx[i], fy[i];
    return f;
  });
  return mesh;
}

// The uniform uniaxial stress state along x.
Eigen::Vector2d exact(double x, double y) {
  return {kStrain * x, -kPoisson * kStrain * (y - kHeight / 2)};
}

class PatchTest : public testing::TestWithParam<fdm::ZoneKind> {};

TEST_P(PatchTest, UniformStrainPassesThroughTheOverlap) {
  const coupler::Overlap overlap(overlap_message());
  const Lattice lattice = make_lattice(overlap);
  const Mesh mesh = make_mesh(overlap, GetParam());
  const dem::Particles& particles = lattice.assembly.particles;
  const auto grid_values = 2 * static_cast<Eigen::Index>(mesh.grid.x.size());
  const auto particle_values = 3 * static_cast<Eigen::Index>(particles.size());

  std::vector<std::size_t> coupled;
  std::vector<double> points;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (overlap.contains(particles.x[i], particles.y[i])) {
      coupled.push_back(i);
      points.insert(points.end(), {particles.x[i], particles.y[i]});
    }
  const auto rows = fdm::interpolate(mesh.grid, points);

  // Equilibrium with multipliers (K u + Gᵀ λ = 0, G u = 0) and prescribed ends.
  const Eigen::Index values = grid_values + particle_values;
  const auto multipliers = 2 * static_cast<Eigen::Index>(coupled.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(values + multipliers, values + multipliers);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(values + multipliers);
  system.topLeftCorner(grid_values, grid_values) = mesh.stiffness;
  system.block(grid_values, grid_values, particle_values, particle_values) = lattice.stiffness;
  for (Eigen::Index k = 0; k < multipliers / 2; ++k)
    for (Eigen::Index direction = 0; direction < 2; ++direction) {
      const Eigen::Index row = values + 2 * k + direction;
      for (std::size_t e = 0; e < rows[k].points.size(); ++e)
        system(row, 2 * rows[k].points[e] + direction) = rows[k].shares[e];
      system(row, grid_values + 3 * static_cast<Eigen::Index>(coupled[k]) + direction) = -1;
      system.col(row).head(values) = system.row(row).head(values);
    }
  const auto prescribe = [&](Eigen::Index value, double displacement) {
    system.row(value).setZero();
    system(value, value) = 1;
    right[value] = displacement;
  };
  for (std::size_t j = 0; j < mesh.grid.x.size(); ++j)
    if (mesh.grid.x[j] < 1e-9)
      for (int direction = 0; direction < 2; ++direction)
        prescribe(2 * static_cast<Eigen::Index>(j) + direction,
                  exact(mesh.grid.x[j], mesh.grid.y[j])[direction]);
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.x[i] > kLength - 2.1 * kRadius) {
      const Eigen::Index first = grid_values + 3 * static_cast<Eigen::Index>(i);
      for (int direction = 0; direction < 2; ++direction)
        prescribe(first + direction, exact(particles.x[i], particles.y[i])[direction]);
      prescribe(first + 2, 0);
    }

  const Eigen::FullPivLU<Eigen::MatrixXd> factor(system);
  Eigen::VectorXd solution = factor.solve(right);
  solution += factor.solve(right - system * solution);

  const double scale = kStrain * kLength;  // the largest displacement
  double error = 0;
  for (std::size_t j = 0; j < mesh.grid.x.size(); ++j)
    error = std::max(
        error, (solution.segment<2>(2 * j) - exact(mesh.grid.x[j], mesh.grid.y[j])).cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < particles.size(); ++i)
    error = std::max(error, (solution.segment<2>(grid_values + 3 * i) - exact(particles.x[i], particles.y[i]))
                                .cwiseAbs()
                                .maxCoeff());
  EXPECT_LE(error, 1e-12 * scale);
}

INSTANTIATE_TEST_SUITE_P(BothZones, PatchTest,
                         testing::Values(fdm::ZoneKind::kAssumedStrain, fdm::ZoneKind::kMixedDiscretization),
                         [](const auto& info) {
                           return info.param == fdm::ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                              : "MixedDiscretization";
                         });

}  // namespace
}  // namespace adit
