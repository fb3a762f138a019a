// The Riccati sweep: solves the linear equations of one step in O(n), with 3x3 matrices only.
//
// The unknowns are the corrections y_i of the bodies' centres (integrator.hpp): for body i, with the dynamic
// stiffness D_i = A diag(m, m, J) + K + C C_g, the hinges' K'_j = K + C C_h and the ports' matrices G,
//   D_i y_i + G_I^T K'_(i-1) (G_I y_i - G_O y_(i-1)) - G_O^T K'_i (G_I y_(i+1) - G_O y_i) = r_i.
// The transfer-matrix form (section 3.1 of the paper) has for the force f and the motion e at a port
//   body  f_O = G_O^-T (D y + G_I^T f_I - r),  hinge  f = K' (e_after - e_before),
// The part of the chain before that port has the Riccati transform f = S e + p. At the outgoing port of body
// i, referred to its centre, S is B_i = D_i + G_I^T S_I G_I and p is -b_i with b_i = r_i - G_I^T p_I. The
// hinge then gives
//   y_i = X_i (b_i + G_O^T K' G_I y_(i+1)),   X_i = (B_i + G_O^T K' G_O)^-1,
//   S' = K' G_O X_i B_i G_O^-1,   p' = -K' G_O X_i b_i     (W of the transform is G_O X_i G_O^T),
//   b_(i+1) = r_(i+1) + L_i b_i,  y_i = X_i b_i + L_i^T y_(i+1),  L_i = G_I(i+1)^T K' G_O X_i.
// Only sums of positive definite matrices occur, so no digits are lost, however long the chain is and however
// stiff or soft a hinge is; its stiffness may even be zero, whereas the plain product needs T12 = 1/K'. L and
// X change only with the tangents of the hinges and with dt; as long as these do not change, a step consists
// of the two recursions.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "simplified/chain/model/model.hpp"

namespace adit::simplified::chain {

class RiccatiSweep {
 public:
  explicit RiccatiSweep(const Model& model);

  // Computes L and X from hinge `changed` on; 0 computes all of them.
  void factor(const Model& model, double A, double C, std::size_t changed);
  // Finds the corrections y for the unbalanced forces r in two sweeps: forward over all bodies, then back.
  // Each sweep may be made in blocks of the bodies begin … end - 1, forward upwards from body 1, back
  // downwards from body n. The corrections of the abutments, 0 and n + 1, are 0.
  void forward(const Components& r, std::size_t begin, std::size_t end);
  void back(Components& y, std::size_t begin, std::size_t end) const;

 private:
  struct Place {
    std::array<double, 9> L;  // by rows
    std::array<double, 6> X;  // xx, xy, yy, xr, yr, rr
  };
  std::vector<Place> places_;
  std::vector<Matrix3> B_;
  std::vector<std::array<double, 3>> b_;
};

}  // namespace adit::simplified::chain
