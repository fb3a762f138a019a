// The springs between two neighbouring columns of soil.
//
// Half of the ground between the columns is that of the one, half that of the other, each a strip of length
// d/2 that a difference of the columns' displacements stretches (or shears): two springs in series at every
// depth,
//     1/k(z) = (d/2) / (chi G_a(z)) + (d/2) / (chi G_b(z))        [Pa/m, per depth and width],
// chi the modulus ratio (joined_columns.hpp). Their loss is that of the two in series as well, to first
// order in xi: k (1 + 2 i xi), xi = (xi_a G_b + xi_b G_a) / (G_a + G_b). Below a shallower column stands its
// rock: its modulus (infinite where rigid, so that k = 2 chi G/d) and no loss; below both there is no spring.
// The energy 1/2 int k (u_a - u_b)^2 dz, in the columns' coordinates u = x_0 + sum psi_n q_n, gives
//     aa = int k psi_a psi_a^T dz,   ab = -int k psi_a psi_b^T dz,   bb = int k psi_b psi_b^T dz,
// integrated exactly. Dashpots in time: each entry of the loss matrix int 2 xi k psi psi^T over
// sqrt(omega_m omega_n), the frequencies of its two coordinates, which dissipates the hysteretic
// loss when a coordinate moves at its own frequency, as the columns' dashpots do, and leaves the matrix
// positive semi-definite; the base's coordinate counts with the column's fundamental frequency.
#pragma once

#include <Eigen/Core>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

struct CouplingBlocks {
  Eigen::MatrixXd aa, ab, bb;
};

struct LongitudinalSprings {
  CouplingBlocks stiffness;  // per width [Pa]
  CouplingBlocks dashpots;   // [Pa s]
};

// distance: between the columns' chainages [m].
LongitudinalSprings longitudinal_springs(const ModalColumn& a, const ModalColumn& b, double distance,
                                         double modulus_ratio);

}  // namespace adit::simplified::column
