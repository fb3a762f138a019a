// Elastic constants of a packing, measured: its border follows a uniform strain, the discs inside find their
// balance, and stress and strain of a wide circle in the middle are compared. Both are the means that
// measurement circles take (observe/circles.hpp).
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <vector>

#include "dem_server/model/bond_springs.hpp"
#include "dem_server/model/initial_state/network.hpp"
#include "dem_server/observe/circles.hpp"

namespace adit::test {

// Of the isotropic solid in plane strain that is nearest to the packing.
struct Moduli {
  double young, poisson;
  double anisotropy;  // largest entry of the stiffness less that of the solid, over its largest
};

inline Eigen::Vector3d vector_of(const dem::Tensor& t) {
  return {t.xx, t.yy, t.xy};
}

// Links of the model's bonds, each with its own stiffness.
inline std::vector<dem::Link> stiff_links(const dem::Model& model) {
  std::vector<dem::Link> links = dem::links_of(model, {});
  for (std::size_t k = 0; k < links.size(); ++k) {
    const dem::BondSprings springs = dem::whole_springs(model, model.bonds[k]);
    links[k].kn = springs.kn;
    links[k].ks = springs.ks;
    links[k].km = springs.km;
  }
  return links;
}

// Solves for the motions x, y, rotation of all discs, where those at the border have the given ones.
class Patch {
 public:
  Patch(const std::vector<dem::Link>& links, std::vector<bool> held) : links_(links), held_(std::move(held)) {
    const auto size = static_cast<Eigen::Index>(held_.size());
    std::vector<Eigen::Triplet<double>> all, inner;
    for (const dem::Link& link : links_) {
      const auto rows = dem::stretching(link);
      const double stiffness[] = {link.kn, link.ks, link.km};
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b) {
          double value = 0;
          for (int row = 0; row < 3; ++row) value += stiffness[row] * rows[row][a] * rows[row][b];
          const Eigen::Index i = motion(link, a), j = motion(link, b);
          all.emplace_back(i, j, value);
          if (!held_[i] && !held_[j]) inner.emplace_back(i, j, value);
        }
    }
    for (Eigen::Index i = 0; i < size; ++i)
      if (held_[i]) inner.emplace_back(i, i, 1);
    stiffness_.resize(size, size);
    stiffness_.setFromTriplets(all.begin(), all.end());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(inner.begin(), inner.end());
    solver_.compute(matrix);
    EXPECT_EQ(solver_.info(), Eigen::Success);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& given) const {
    Eigen::VectorXd right = -(stiffness_ * given);
    for (Eigen::Index i = 0; i < right.size(); ++i)
      if (held_[i]) right[i] = 0;
    return given + solver_.solve(right);
  }

  dem::Branch branch(const dem::Discs& d, const dem::Link& link, const Eigen::VectorXd& u) const {
    const auto rows = dem::stretching(link);
    double stretch[2] = {0, 0};
    for (int a = 0; a < 6; ++a)
      for (int row = 0; row < 2; ++row) stretch[row] += rows[row][a] * u[motion(link, a)];
    const auto [fx, fy] = dem::force_on_first(link, {link.kn * stretch[0], link.ks * stretch[1], 0});
    return {d.x[link.first], d.y[link.first], d.x[link.second], d.y[link.second], fx, fy};
  }

 private:
  static Eigen::Index motion(const dem::Link& link, int a) {
    return 3 * static_cast<Eigen::Index>(a < 3 ? link.first : link.second) + a % 3;
  }
  const std::vector<dem::Link>& links_;
  std::vector<bool> held_;
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

// Discs farther than `inside` from the middle in x or y are held; the circle has the radius `circle`.
inline Moduli measured_moduli(const dem::Model& model, double inside, double circle) {
  const dem::Discs& d = model.discs;
  const std::vector<dem::Link> links = stiff_links(model);
  std::vector<bool> joined(d.size(), false), held(3 * d.size(), false);
  for (const dem::Link& link : links) joined[link.first] = joined[link.second] = true;
  for (std::size_t i = 0; i < d.size(); ++i)
    if (!joined[i] || std::max(std::abs(d.x[i]), std::abs(d.y[i])) > inside)
      held[3 * i] = held[3 * i + 1] = held[3 * i + 2] = true;
  const Patch patch(links, held);
  Eigen::Matrix3d strains, stresses;
  const dem::Strain units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const dem::Circle middle{0, 0, circle};
  for (int k = 0; k < 3; ++k) {
    Eigen::VectorXd given = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(d.size()));
    for (std::size_t i = 0; i < d.size(); ++i)
      if (held[3 * i]) {
        given[3 * i] = units[k].xx * d.x[i] + units[k].xy * d.y[i];
        given[3 * i + 1] = units[k].xy * d.x[i] + units[k].yy * d.y[i];
      }
    const Eigen::VectorXd moved = patch.solve(given);
    std::vector<dem::Branch> branches;
    for (const dem::Link& link : links) branches.push_back(patch.branch(d, link, moved));
    std::vector<double> ux, uy;
    for (std::size_t i = 0; i < d.size(); ++i) {
      ux.push_back(moved[3 * i]);
      uy.push_back(moved[3 * i + 1]);
    }
    strains.col(k) = vector_of(*dem::mean_strain_rate(middle, d.x, d.y, ux, uy));
    stresses.col(k) = vector_of(dem::mean_stress(middle, branches));
  }
  const Eigen::Matrix3d c = stresses * strains.inverse();  // s = c (xx, yy, xy)
  // bulk = lambda + mu
  const double bulk = (c(0, 0) + c(1, 1) + c(0, 1) + c(1, 0)) / 4;
  const double shear = ((c(0, 0) + c(1, 1) - c(0, 1) - c(1, 0)) / 4 + c(2, 2) / 2) / 2;
  const double poisson = (1 - shear / bulk) / 2;
  Eigen::Matrix3d solid;
  solid << bulk + shear, bulk - shear, 0, bulk - shear, bulk + shear, 0, 0, 0, 2 * shear;
  return {2 * shear * (1 + poisson), poisson, (c - solid).cwiseAbs().maxCoeff() / (bulk + shear)};
}

}  // namespace adit::test
