// The tangent stiffness of particles in a state, measured: what a small motion of one of them changes of the
// forces on those near it, by the very code that computes the forces in a step. So every law of theirs is in
// it, with all terms.
//
// Particles far enough from each other are moved at once, since no force on a third one tells of both: as
// many motions as colours are needed in which no two particles of one colour lie within twice the reach.
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace adit::dem {

// Of all particles: x, y and turn of the first, of the second … [m], [rad]; forces and moments likewise.
inline constexpr std::size_t kFreedoms = 3;

// The forces on all particles after this motion from the state, which stays as it is [N], [N m].
using ForcesAfter = std::function<std::vector<double>(std::span<const double> motion)>;

// For each particle, ascending: those of which two bonds or fewer lie between, with itself.
using Neighbourhood = std::vector<std::vector<std::uint32_t>>;
Neighbourhood neighbourhood_of(std::size_t particles, std::span<const std::uint32_t> first,
                               std::span<const std::uint32_t> second);

struct Tangent {
  Eigen::SparseMatrix<double> stiffness;  // symmetric [N/m], [N], [N m]
  std::vector<double> forces;             // in the state
  // The share of the forces by a motion of all particles that has one sign for both signs of the motion: 0 of
  // a linear model. One in which something slides, opens or closes is far from it.
  double one_sidedness;
};

// `radius`: of the particles [m]; `reach` says whose forces a particle's motion changes.
Tangent tangent_of(std::span<const double> radius, const Neighbourhood& reach,
                   const ForcesAfter& forces_after);

}  // namespace adit::dem
