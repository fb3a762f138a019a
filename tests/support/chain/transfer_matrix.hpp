// The plain product of transfer matrices: the same equations as riccati.hpp, solved as the method was first
// written down. It loses digits with every hinge, which is why the library takes the Riccati sweep.
//
// The state z = (e, f) at a port goes through a body, e_O = G_O G_I^-1 e_I, f_O = G_O^-T (D y + G_I^T f_I -
// r), and through a hinge, e += K'^-1 f. From the first body's motion y_1, unknown, each body's is y_i = E_i
// y_1 + eps_i; the condition at the end gives y_1. E_i grows by exp(acosh(1 + s/2k)) a hinge (s: body, k:
// hinge, one direction), and y_i is the small difference of large numbers: that many digits are gone.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "simplified/chain/model/model.hpp"

namespace adit::simplified::chain::test {

class TransferMatrixSweep {
 public:
  explicit TransferMatrixSweep(const Model& model);

  // Multiplies the matrices. Throws protocol::UserError where a hinge has no stiffness in some direction.
  void factor(const Model& model, double A, double C);
  void solve(const Components& r, Components& y);

 private:
  struct Place {
    Matrix3 D, in, out, flexibility;  // flexibility K'^-1 of the hinge after the body
    Matrix3 E;
  };
  std::vector<Place> places_;
  std::vector<Vector3> eps_;
  Matrix3 end_stiffness_;  // of the last hinge, and
  Matrix3 end_;            // y_1 = -end^-1 (its force where y_1 = 0)
};

// Digits lost over all hinges between bodies: the sum of log10 of the largest eigenvalue of each cell, body
// and hinge after it: acosh(1 + s/2k)/ln 10 in axial direction, s the body's dynamic stiffness m A + K + C
// C_g, k the hinge's.
double predicted_digits_lost(const Model& model, double A, double C);

// How many of the 15.65 decimal digits of a double the product loses in the solution for r, against the
// Riccati sweep: between 0 and all of them.
double measured_digits_lost(const Model& model, double A, double C, const Components& r);
inline const double kAllDigits = -std::log10(std::numeric_limits<double>::epsilon());

}  // namespace adit::simplified::chain::test
