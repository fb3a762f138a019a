#include "tests/support/chain/transfer_matrix.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "simplified/chain/riccati.hpp"

namespace adit::simplified::chain::test {
namespace {

void check_stiffness(const Model& model, double C) {
  for (std::size_t j = 1; j < model.bodies; ++j)
    for (std::size_t d = 0; d < 3; ++d)
      if (!(model.stiffness[d][j] + C * model.dashpot[d][j] > 0))
        throw protocol::UserError(fmt::format("chain.hinges[{}].{}", j - 1,
                                              d == 0   ? "axial"
                                              : d == 1 ? "shear"
                                                       : "rotation"),
                                  "has neither stiffness nor dashpot: the plain transfer-matrix product "
                                  "cannot pass it, take the Riccati "
                                  "sweep");
}

}  // namespace

TransferMatrixSweep::TransferMatrixSweep(const Model& model)
    : places_(model.bodies + 1), eps_(model.bodies + 1) {}

void TransferMatrixSweep::factor(const Model& model, double A, double C) {
  check_stiffness(model, C);
  const std::size_t n = model.bodies;
  end_stiffness_ = model.hinge_stiffness(n, C);
  Matrix3 E = Matrix3::Identity(), f = model.hinge_stiffness(0, C) * model.ingoing_port(1);
  for (std::size_t i = 1; i <= n; ++i) {
    Place& place = places_[i];
    place.D = model.dynamic_stiffness(i, A, C);
    place.in = model.ingoing_port(i);
    place.out = model.outgoing_port(i);
    place.E = E;
    // G_O^-1 = G_I for ports on opposite sides of the centre.
    f = place.in.transpose() * (place.D * E + place.in.transpose() * f);
    if (i == n) break;
    place.flexibility = model.hinge_stiffness(i, C).inverse();
    E = model.outgoing_port(i + 1) * (place.out * E + place.flexibility * f);
  }
  end_ = f + end_stiffness_ * places_[n].out * E;
}

void TransferMatrixSweep::solve(const Components& r, Components& y) {
  const std::size_t n = places_.size() - 1;
  Vector3 e = Vector3::Zero(), f = Vector3::Zero();
  for (std::size_t i = 1; i <= n; ++i) {
    const Place& place = places_[i];
    eps_[i] = e;
    f = place.in.transpose() * (place.D * e + place.in.transpose() * f - Vector3(r[0][i], r[1][i], r[2][i]));
    if (i < n) e = places_[i + 1].out * (place.out * e + place.flexibility * f);
  }
  const Vector3 first = -end_.partialPivLu().solve(f + end_stiffness_ * places_[n].out * e);
  for (std::size_t i = 1; i <= n; ++i) {
    const Vector3 motion = places_[i].E * first + eps_[i];
    for (int c = 0; c < 3; ++c) y[c][i] = motion[c];
  }
}

double predicted_digits_lost(const Model& model, double A, double C) {
  double digits = 0;
  for (std::size_t i = 1; i < model.bodies; ++i) {
    const Matrix3 D = model.dynamic_stiffness(i, A, C), in = model.ingoing_port(i),
                  out = model.outgoing_port(i);
    const Matrix3 K = model.hinge_stiffness(i, C);
    if (!(K.diagonal().minCoeff() > 0)) return INFINITY;
    const double unit = K.maxCoeff();  // of the forces, so that both halves of the state are of one size
    Eigen::Matrix<double, 6, 6> cell;
    cell.topLeftCorner<3, 3>() = out * out;  // G_O G_I^-1
    cell.topRightCorner<3, 3>().setZero();
    cell.bottomLeftCorner<3, 3>() = in.transpose() * D * out / unit;
    cell.bottomRightCorner<3, 3>() = in.transpose() * in.transpose();
    cell.topRows<3>() += unit * K.inverse() * cell.bottomRows<3>().eval();
    digits += std::log10(cell.eigenvalues().cwiseAbs().maxCoeff());
  }
  return digits;
}

double measured_digits_lost(const Model& model, double A, double C, const Components& r) {
  TransferMatrixSweep product(model);
  RiccatiSweep riccati(model);
  product.factor(model, A, C);
  riccati.factor(model, A, C, 0);
  Components lossy = components(model.bodies + 2), exact = lossy;
  product.solve(r, lossy);
  riccati.forward(r, 1, model.bodies + 1);
  riccati.back(exact, 1, model.bodies + 1);
  double difference = 0, largest = 0;
  for (std::size_t i = 1; i <= model.bodies; ++i) {
    const double arm = std::hypot(model.half_x[i], model.half_y[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      const double unit = c == 2 ? arm : 1, d = unit * std::abs(lossy[c][i] - exact[c][i]);
      difference = std::isnan(d) ? INFINITY : std::max(difference, d);
      largest = std::max(largest, unit * std::abs(exact[c][i]));
    }
  }
  return std::clamp(kAllDigits + std::log10(difference / largest), 0.0, kAllDigits);
}

}  // namespace adit::simplified::chain::test
