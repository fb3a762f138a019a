#include "tests/support/chain/direct_integration.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace adit::simplified::chain::test {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;
using Map = Eigen::Map<const Eigen::VectorXd>;

// A spring's elongation as a sum of motions: `weight` of degree of freedom `index`.
struct Part {
  Eigen::Index index;
  double weight;
};

// Springs between bodies, ground and abutments, each the outer product of its elongation with itself.
struct Assembly {
  Triplets of_motion, of_ground;

  // An elongation from the bodies' motions `own` less that from the ground's motions `ground`.
  void add(double k, const std::vector<Part>& own, const std::vector<Part>& ground) {
    if (k == 0) return;
    for (const Part& row : own) {
      for (const Part& column : own)
        of_motion.emplace_back(row.index, column.index, k * row.weight * column.weight);
      for (const Part& column : ground)
        of_ground.emplace_back(row.index, column.index, k * row.weight * column.weight);
    }
  }
};

// Motion along the unit vector (c, s) of the port of body i at (rx, ry).
void add_port(std::vector<Part>& parts, std::size_t i, double sign, double c, double s, double rx,
              double ry) {
  const auto first = static_cast<Eigen::Index>(3 * i);
  parts.insert(parts.end(),
               {{first, sign * c}, {first + 1, sign * s}, {first + 2, sign * (s * rx - c * ry)}});
}

struct Stations {
  const Chain& chain;
  Assembly springs, dashpots;

  void add_ground(std::size_t i) {
    const Body& body = chain.bodies[i];
    const auto at = static_cast<Eigen::Index>(i);
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    const auto along = [&](double x, double y, double k, double dashpot) {
      const std::vector<Part> own{{3 * at, x}, {3 * at + 1, y}}, ground{{2 * at, x}, {2 * at + 1, y}};
      springs.add(k, own, ground);
      dashpots.add(dashpot, own, ground);
    };
    along(c, s, body.ground_stiffness.axial, body.ground_dashpot.axial);
    along(-s, c, body.ground_stiffness.lateral, body.ground_dashpot.lateral);
    springs.add(body.ground_stiffness.rotation, {{3 * at + 2, 1}}, {});
    dashpots.add(body.ground_dashpot.rotation, {{3 * at + 2, 1}}, {});
  }

  // The hinge before body j; before the first and after the last stands an abutment.
  void add_hinge(std::size_t j, const Hinge& hinge) {
    const std::size_t n = chain.bodies.size();
    const bool has_before = j > 0, has_after = j < n;
    const double before = chain.bodies[has_before ? j - 1 : 0].angle,
                 after = chain.bodies[has_after ? j : n - 1].angle;
    const double angle = std::atan2(std::sin(before) + std::sin(after), std::cos(before) + std::cos(after));
    const auto along = [&](double c, double s, const HingeDirection& law) {
      std::vector<Part> own, ground;
      if (has_after) {
        const double half = 0.5 * chain.bodies[j].length;
        add_port(own, j, 1, c, s, -half * std::cos(after), -half * std::sin(after));
      } else {
        ground = {{static_cast<Eigen::Index>(2 * (n - 1)), -c},
                  {static_cast<Eigen::Index>(2 * (n - 1) + 1), -s}};
      }
      if (has_before) {
        const double half = 0.5 * chain.bodies[j - 1].length;
        add_port(own, j - 1, -1, c, s, half * std::cos(before), half * std::sin(before));
      } else {
        ground = {{0, c}, {1, s}};
      }
      springs.add(law.stiffness, own, ground);
      dashpots.add(law.dashpot, own, ground);
    };
    along(std::cos(angle), std::sin(angle), hinge.axial);
    along(-std::sin(angle), std::cos(angle), hinge.shear);
    std::vector<Part> turn;
    if (has_after) turn.push_back({static_cast<Eigen::Index>(3 * j + 2), 1});
    if (has_before) turn.push_back({static_cast<Eigen::Index>(3 * (j - 1) + 2), -1});
    springs.add(hinge.rotation.stiffness, turn, {});
    dashpots.add(hinge.rotation.dashpot, turn, {});
    for (const auto* law : {&hinge.axial, &hinge.shear, &hinge.rotation})
      if (!law->curve.empty()) throw std::invalid_argument("direct integration knows no curves");
  }
};

Eigen::SparseMatrix<double> matrix(std::size_t rows, std::size_t columns, const Triplets& triplets) {
  Eigen::SparseMatrix<double> m(rows, columns);
  m.setFromTriplets(triplets.begin(), triplets.end());
  return m;
}

Eigen::VectorXd interleaved(const std::vector<std::span<const double>>& columns, std::size_t rows) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(rows * columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t i = 0; i < columns[c].size(); ++i) all[i * columns.size() + c] = columns[c][i];
  return all;
}

}  // namespace

DirectIntegration::DirectIntegration(const Chain& chain, const Settings& settings)
    : integrator_(settings.newmark, settings.dt),
      bodies_(chain.bodies.size()),
      motion_(3 * bodies_),
      load_(Vector::Zero(3 * bodies_)) {
  Triplets mass;
  Stations stations{chain, {}, {}};
  for (std::size_t i = 0; i < bodies_; ++i) {
    const Body& body = chain.bodies[i];
    for (int c = 0; c < 3; ++c) mass.emplace_back(3 * i + c, 3 * i + c, c < 2 ? body.mass : body.inertia);
    stations.add_ground(i);
  }
  if (chain.start) stations.add_hinge(0, *chain.start);
  for (std::size_t j = 0; j < chain.hinges.size(); ++j) stations.add_hinge(j + 1, chain.hinges[j]);
  if (chain.finish) stations.add_hinge(bodies_, *chain.finish);
  mass_ = matrix(3 * bodies_, 3 * bodies_, mass);
  stiffness_ = matrix(3 * bodies_, 3 * bodies_, stations.springs.of_motion);
  dashpot_ = matrix(3 * bodies_, 3 * bodies_, stations.dashpots.of_motion);
  ground_stiffness_ = matrix(3 * bodies_, 2 * bodies_, stations.springs.of_ground);
  ground_dashpot_ = matrix(3 * bodies_, 2 * bodies_, stations.dashpots.of_ground);
  factor();
}

void DirectIntegration::factor() {
  const Sparse dynamic = integrator_.A() * mass_ + integrator_.C() * dashpot_ + stiffness_;
  solver_.compute(dynamic);
  if (solver_.info() != Eigen::Success)
    throw std::runtime_error("the chain's dynamic stiffness has no LDL^T");
}

DirectIntegration::Vector DirectIntegration::load(const Excitation& e) const {
  return interleaved({e.load_x, e.load_y, e.moment}, bodies_) +
         ground_stiffness_ * interleaved({e.ground_x, e.ground_y}, bodies_) +
         ground_dashpot_ * interleaved({e.ground_vx, e.ground_vy}, bodies_);
}

void DirectIntegration::step(const Excitation& at_end) {
  load_ = load(at_end);
  integrator_.predict(motion_, 0, 3 * bodies_);
  const Vector y = solver_.solve(load_ - stiffness_ * Map(motion_.p.data(), motion_.p.size()) -
                                 dashpot_ * Map(motion_.q.data(), motion_.q.size()));
  integrator_.correct(motion_, {y.data(), static_cast<std::size_t>(y.size())}, 0, 3 * bodies_);
}

}  // namespace adit::simplified::chain::test
