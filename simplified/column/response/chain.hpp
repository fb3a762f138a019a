// The chain of masses and springs that is exactly equivalent to the parallel oscillators of a modal column:
// the same frequencies, the same force at the base, whatever the base does.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

// Mass 0 hangs on the base by spring 0, mass i on mass i - 1 by spring i. The masses stand at no particular
// depth; the deposit's motion follows from theirs through `oscillators`.
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

// The same functions as those of the oscillators (modal_column.hpp), with hysteretic springs, from the
// chain's own equations.
std::complex<double> base_stiffness(const Chain& chain, double frequency);
// Displacement over the base's, where the shapes psi_n are those given (shapes_at).
std::complex<double> base_transfer(const Chain& chain, double frequency, const std::vector<double>& shapes);

}  // namespace adit::simplified::column
