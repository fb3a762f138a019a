#include "simplified/chain/riccati.hpp"

#include <algorithm>

namespace adit::simplified::chain {
namespace {

// The matrix without the asymmetry that rounding errors cause.
Matrix3 symmetric(const Matrix3& m) {
  return 0.5 * (m + m.transpose());
}

// The inverse by L D L^T with the rotation last. Unlike cofactors, it loses no digits if bodies are long.
Matrix3 inverse(const Matrix3& a) {
  const double l10 = a(1, 0) / a(0, 0), l20 = a(2, 0) / a(0, 0);
  const double d1 = a(1, 1) - l10 * a(1, 0);
  const double l21 = (a(2, 1) - l20 * a(1, 0)) / d1;
  const double d2 = a(2, 2) - l20 * a(2, 0) - l21 * l21 * d1;
  Matrix3 m = Matrix3::Identity();  // the inverse of L
  m(1, 0) = -l10;
  m(2, 1) = -l21;
  m(2, 0) = l10 * l21 - l20;
  const Vector3 d(1 / a(0, 0), 1 / d1, 1 / d2);
  return m.transpose() * d.asDiagonal() * m;
}

}  // namespace

RiccatiSweep::RiccatiSweep(const Model& model)
    : places_(model.bodies + 1, Place{}),
      B_(model.bodies + 1, Matrix3::Zero()),
      b_(model.bodies + 1, std::array<double, 3>{}) {}

void RiccatiSweep::factor(const Model& model, double A, double C, std::size_t changed) {
  const std::size_t n = model.bodies;
  if (changed == 0) {
    // The correction of an abutment is 0, so hinge 0 acts on body 1 like a spring to a fixed point.
    const Matrix3 in = model.ingoing_port(1);
    B_[1] = model.dynamic_stiffness(1, A, C) + in.transpose() * model.hinge_stiffness(0, C) * in;
  }
  for (std::size_t i = std::max<std::size_t>(changed, 1); i <= n; ++i) {
    const Matrix3 K = model.hinge_stiffness(i, C), out = model.outgoing_port(i);
    const Matrix3 X = inverse(B_[i] + symmetric(out.transpose() * K * out)), in = model.ingoing_port(i + 1);
    const Matrix3 KGX = K * out * X, L = in.transpose() * KGX;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) places_[i].L[3 * row + column] = L(row, column);
    places_[i].X = {X(0, 0), X(0, 1), X(1, 1), X(0, 2), X(1, 2), X(2, 2)};
    if (i == n) break;
    // G_O^-1 = G_I, because the ports lie opposite each other.
    const Matrix3 S = symmetric(KGX * B_[i] * model.ingoing_port(i));
    B_[i + 1] = model.dynamic_stiffness(i + 1, A, C) + symmetric(in.transpose() * S * in);
  }
}

void RiccatiSweep::forward(const Components& r, std::size_t begin, std::size_t end) {
  const double *rx = r[0].data(), *ry = r[1].data(), *rr = r[2].data();
  // The blocks of a sweep follow each other: the last block has left b here, and place 0 holds zero.
  auto [b0, b1, b2] = b_[begin - 1];
  for (std::size_t i = begin; i < end; ++i) {
    const auto& L = places_[i - 1].L;  // zero before the first body
    const double next0 = rx[i] + (L[0] * b0 + L[1] * b1 + L[2] * b2);
    const double next1 = ry[i] + (L[3] * b0 + L[4] * b1 + L[5] * b2);
    const double next2 = rr[i] + (L[6] * b0 + L[7] * b1 + L[8] * b2);
    b_[i] = {b0 = next0, b1 = next1, b2 = next2};
  }
}

void RiccatiSweep::back(Components& y, std::size_t begin, std::size_t end) const {
  double y0 = y[0][end], y1 = y[1][end], y2 = y[2][end];
  for (std::size_t i = end - 1; i >= begin; --i) {
    const auto& [L, X] = places_[i];
    const auto& b = b_[i];
    const double next0 = (X[0] * b[0] + X[1] * b[1] + X[3] * b[2]) + (L[0] * y0 + L[3] * y1 + L[6] * y2);
    const double next1 = (X[1] * b[0] + X[2] * b[1] + X[4] * b[2]) + (L[1] * y0 + L[4] * y1 + L[7] * y2);
    const double next2 = (X[3] * b[0] + X[4] * b[1] + X[5] * b[2]) + (L[2] * y0 + L[5] * y1 + L[8] * y2);
    y[0][i] = y0 = next0;
    y[1][i] = y1 = next1;
    y[2][i] = y2 = next2;
  }
}

}  // namespace adit::simplified::chain
