// The springs between two neighbouring soil columns.
//
// The ground between the columns consists of two strips of length d/2, one with the properties of each
// column. A difference of the columns' displacements stretches or shears them, so at every depth they act as
// two springs in series,
//     1/k(z) = (d/2) / E_a(z) + (d/2) / E_b(z)        [Pa/m, per depth and width],
// where E = chi G is the modulus of the strip, with the modulus ratio chi of its layer (joined_columns.hpp).
// The damping of the two in series is, to first order in xi, k (1 + 2 i xi) with xi = (xi_a E_b + xi_b E_a) /
// (E_a + E_b). Below the shallower column its rock continues, with its modulus (infinite if rigid, so that
// k = 2 E/d) and without damping. Below both columns there is no spring. The energy 1/2 int k (u_a - u_b)^2
// dz, in the columns' coordinates u = x_0 + sum psi_n q_n, gives
//     aa = int k psi_a psi_a^T dz,   ab = -int k psi_a psi_b^T dz,   bb = int k psi_b psi_b^T dz,
// which are integrated exactly. In time, damping is represented by dashpots: each entry of the loss matrix
// int 2 xi k psi psi^T dz is divided by sqrt(omega_m omega_n), with the frequencies of its two coordinates. A
// coordinate that moves at its own frequency then dissipates as much as hysteretic damping would, as with the
// dashpots of the columns, and the matrix stays positive semi-definite. The coordinate of the base is given
// the fundamental frequency of its column.
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

// `distance` is the difference of the columns' chainages [m].
LongitudinalSprings longitudinal_springs(const ModalColumn& a, const ModalColumn& b, double distance);

}  // namespace adit::simplified::column
