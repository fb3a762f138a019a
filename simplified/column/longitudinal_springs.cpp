#include "simplified/column/longitudinal_springs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "simplified/column/modes/harmonic.hpp"

namespace adit::simplified::column {

namespace {

using Eigen::Index;

// The depths between which both columns are uniform, from the surface to the rock of the deeper column.
std::vector<double> common_interfaces(const Deposit& a, const Deposit& b) {
  std::set<double> depths{0};
  for (const Deposit* deposit : {&a, &b}) {
    double depth = 0;
    for (const Layer& layer : deposit->layers) depths.insert(depth += layer.thickness);
  }
  return {depths.begin(), depths.end()};
}

// The properties of a column below depth `top`, those of its layer or of its rock.
struct Slice {
  double flexibility;  // 1/E [1/Pa]; 0: rigid rock
  double damping;
  std::vector<Harmonic> shapes;  // the shape of the base, then those of the oscillators
};

Slice slice_of(const ModalColumn& column, double top) {
  const Deposit& deposit = column.deposit;
  Slice slice{deposit.rock ? 1 / (deposit.rock->modulus_ratio * deposit.rock->modulus()) : 0, 0, {{1, 0}}};
  double layer_top = 0;
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    if (top < layer_top + layer.thickness) {
      slice.flexibility = 1 / (layer.modulus_ratio * layer.modulus());
      slice.damping = layer.damping;
      for (const Mode& mode : column.modes)
        slice.shapes.push_back(
            further_down({mode.participation * mode.amplitudes[i], mode.frequency / layer.wave_velocity},
                         top - layer_top));
      return slice;
    }
    layer_top += layer.thickness;
  }
  // The rock moves with the base; the oscillators have no part in it.
  slice.shapes.resize(column.modes.size() + 1, {0, 0});
  return slice;
}

// The integrals of f g^T over a thickness.
Eigen::MatrixXd products(const std::vector<Harmonic>& f, const std::vector<Harmonic>& g, double thickness) {
  Eigen::MatrixXd result(f.size(), g.size());
  for (Index m = 0; m < result.rows(); ++m)
    for (Index n = 0; n < result.cols(); ++n)
      result(m, n) = integral(f[static_cast<std::size_t>(m)], g[static_cast<std::size_t>(n)], thickness);
  return result;
}

// 1/sqrt(omega) for each coordinate.
Eigen::VectorXd calibration(const ModalColumn& column) {
  Eigen::VectorXd result(column.modes.size() + 1);
  result[0] = 1 / std::sqrt(column.modes.front().frequency);
  for (Index n = 1; n < result.size(); ++n)
    result[n] = 1 / std::sqrt(column.modes[static_cast<std::size_t>(n - 1)].frequency);
  return result;
}

}  // namespace

LongitudinalSprings longitudinal_springs(const ModalColumn& a, const ModalColumn& b, double distance) {
  const auto na = static_cast<Index>(a.modes.size() + 1), nb = static_cast<Index>(b.modes.size() + 1);
  const CouplingBlocks none{Eigen::MatrixXd::Zero(na, na), Eigen::MatrixXd::Zero(na, nb),
                            Eigen::MatrixXd::Zero(nb, nb)};
  LongitudinalSprings springs{none, none};
  const std::vector<double> depths = common_interfaces(a.deposit, b.deposit);
  for (std::size_t i = 0; i + 1 < depths.size(); ++i) {
    const double thickness = depths[i + 1] - depths[i];
    const Slice sa = slice_of(a, depths[i]), sb = slice_of(b, depths[i]);
    // The depths end at the rock of the deeper column, so at least one of the two is soil here and this is
    // not 0.
    const double flexibility = sa.flexibility + sb.flexibility;
    const double k = 2 / (distance * flexibility);
    const double loss = 2 * k * (sa.damping * sa.flexibility + sb.damping * sb.flexibility) / flexibility;
    const CouplingBlocks integrals{products(sa.shapes, sa.shapes, thickness),
                                   products(sa.shapes, sb.shapes, thickness),
                                   products(sb.shapes, sb.shapes, thickness)};
    const auto add = [&](CouplingBlocks& to, double factor) {
      to.aa += factor * integrals.aa;
      to.ab -= factor * integrals.ab;
      to.bb += factor * integrals.bb;
    };
    add(springs.stiffness, k);
    add(springs.dashpots, loss);
  }
  // Scaling by a diagonal matrix from both sides keeps the dashpots symmetric and positive semi-definite.
  const Eigen::VectorXd ca = calibration(a), cb = calibration(b);
  CouplingBlocks& dashpots = springs.dashpots;
  dashpots.aa = (ca.asDiagonal() * dashpots.aa * ca.asDiagonal()).eval();
  dashpots.ab = (ca.asDiagonal() * dashpots.ab * cb.asDiagonal()).eval();
  dashpots.bb = (cb.asDiagonal() * dashpots.bb * cb.asDiagonal()).eval();
  return springs;
}

}  // namespace adit::simplified::column
