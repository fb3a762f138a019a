// The chain of masses and springs that is exactly equivalent to the parallel oscillators of a modal column:
// it has the same frequencies and the same force at the base for any motion of the base.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

// Spring 0 connects mass 0 with the base, spring i connects mass i with mass i - 1. The masses do not belong
// to particular depths; the motion of the deposit follows from theirs through `oscillators`.
struct Chain {
  Eigen::VectorXd masses;     // per area [kg/m^2]; their sum is that of the effective masses
  Eigen::VectorXd springs;    // per area [Pa/m]
  Eigen::MatrixXd stiffness;  // tridiagonal, of the springs [Pa/m]
  Eigen::MatrixXd loss;       // imaginary part of the stiffness in frequency [Pa/m]; 2 xi times the stiffness
                         // where all modes have the damping xi: the same factor 1 + 2 i xi on each spring
  Eigen::MatrixXd dashpots;  // in time [Pa s/m]: the oscillators' dashpots link every mass with every other
  Eigen::MatrixXd oscillators;  // q = oscillators * v, v the masses' displacement relative to the base
  double rigid_mass;            // fixed to the base [kg/m^2]
};

Chain equivalent_chain(const ModalColumn& column);

// The same functions as for the oscillators (modal_column.hpp), with hysteretic springs, computed from the
// equations of the chain.
std::complex<double> base_stiffness(const Chain& chain, double frequency);
// Displacement divided by that of the base, at the place with the given shapes psi_n (shapes_at).
std::complex<double> base_transfer(const Chain& chain, double frequency, const std::vector<double>& shapes);

}  // namespace adit::simplified::column
