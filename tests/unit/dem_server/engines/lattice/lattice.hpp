// Small lattices for the tests, and the stiffness matrix that the kernel itself produces.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/integrate.hpp"
#include "tests/support/bond_forces.hpp"
#include "tests/support/lattice_model.hpp"

namespace adit::dem::test {

// Rows of touching, bonded discs, the first, third, … with `discs` of them, from the origin.
inline Model rows_of(int rows, int discs, double radius = 0.5) {
  return lattice_in({0, 2 * radius * discs, 0, std::numbers::sqrt3 * radius * rows}, radius);
}

// Two particles at rest with one bond along x.
inline Assembly pair_of_particles(double mass = 2.0, double radius = 0.5) {
  return assemble(rows_of(1, 2, radius), mass);
}

inline std::pair<BondResult, std::vector<std::uint32_t>> compute(const ContactBond& law, double dt,
                                                                 Assembly& a) {
  std::vector<std::uint32_t> broken;
  const BondResult result = compute_bond_forces(law, dt, a.particles, a.bonds, broken);
  return {result, broken};
}

// Random numbers in [-amplitude, amplitude], the same in every run.
inline void fill_randomly(std::vector<double>& values, double amplitude, unsigned seed) {
  std::mt19937 generator(seed);
  for (double& value : values)
    value = amplitude * (2.0 * static_cast<double>(generator()) / std::mt19937::max() - 1);
}

// Energies at the present step, followed by the kick to the next half step.
struct Ledger {
  double kinetic = 0, strain = 0, released = 0;
  double total() const { return kinetic + strain + released; }
};

// One step of a free lattice; `start` for the step that does not move.
inline void step(const ContactBond& law, double dt, bool start, Assembly& a, Ledger& ledger) {
  const protocol::IndexRange all{0, static_cast<std::uint32_t>(a.particles.size())};
  if (!start) move(dt, {&all, 1}, a.particles);
  ledger.released += compute(law, dt, a).first.released;
  Velocities before;
  remember(a.particles, before);
  kick(protocol::Step{1, dt}, {&all, 1}, resultants_of(a.particles), a.particles);
  ledger.kinetic = kinetic_energy(a.particles, before, false);
  ledger.strain = strain_energy(law, a.bonds.runs, a.particles, a.bonds);
}

// Force on every degree of freedom (x, y, spin of particle 0, then 1, …) per unit of each one, about rest:
// minus the stiffness matrix, column by column through the kernel. Displacements are tiny, so that the
// lattice's geometric nonlinearity stays below 1e-8.
inline Eigen::SparseMatrix<double> stiffness_matrix(const ContactBond& law, Assembly a) {
  const double small = 1e-9 * a.bonds.rest_length, dt = 1.0;
  Particles& p = a.particles;
  const int n = static_cast<int>(p.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < 3 * n; ++column) {
    for (auto* values : {&p.ux, &p.uy, &p.vx, &p.vy, &p.spin}) std::fill(values->begin(), values->end(), 0.0);
    std::fill(a.bonds.shear_force.begin(), a.bonds.shear_force.end(), 0.0);
    const int i = column / 3;
    if (column % 3 == 0) p.ux[i] = small, p.vx[i] = small / dt;
    if (column % 3 == 1) p.uy[i] = small, p.vy[i] = small / dt;
    if (column % 3 == 2) p.spin[i] = small / dt;
    compute(law, dt, a);
    for (int j = 0; j < n; ++j) {
      const double forces[] = {p.fx[j], p.fy[j], p.moment[j]};
      for (int component = 0; component < 3; ++component)
        if (forces[component] != 0)
          entries.emplace_back(3 * j + component, column, -forces[component] / small);
    }
  }
  Eigen::SparseMatrix<double> k(3 * n, 3 * n);
  k.setFromTriplets(entries.begin(), entries.end());
  return (k + Eigen::SparseMatrix<double>(k.transpose())) / 2;
}

inline Eigen::VectorXd mass_diagonal(const Particles& p) {
  Eigen::VectorXd m(3 * static_cast<Eigen::Index>(p.size()));
  for (std::size_t i = 0; i < p.size(); ++i)
    m.segment(3 * static_cast<Eigen::Index>(i), 3) << p.mass[i], p.mass[i], p.inertia[i];
  return m;
}

}  // namespace adit::dem::test
