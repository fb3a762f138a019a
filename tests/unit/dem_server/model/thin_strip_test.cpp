// Requirement: a strip of few rows with the factors of its outer rows stretches and bends as the solid,
// breaks at the same stress of its outer fibre, and its critical step follows.
#include "dem_server/model/solid/thin_strip.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/model/calibration.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::thin_strip_test {
namespace {

constexpr double kYoung = 25e9, kRadius = 0.5, kStrength = 1e6;
constexpr int kDiscs = 60;

// A strip whose ends are stretched and turned.
class Strip {
 public:
  Strip(std::uint32_t rows, double poisson_ratio)
      : law_{calibrate(kYoung, poisson_ratio, Plane::kStress), kStrength, kUnbreakable},
        height_(rows * std::numbers::sqrt3 * kRadius),
        model_(test::lattice_in({0, 2 * kRadius * kDiscs, 0, height_}, kRadius, 1.0, law_)) {
    stiffen_outer_rows(model_);
    strip_ = test::assemble(model_, 1.0);
    stiffness_ = test::stiffness_matrix(law_, strip_);
  }

  // Resultant over that of the solid, where its ends move along it by `at(height above the axis)` per length.
  template <class Strain>
  void deform(Strain&& at) {
    const Particles& p = strip_.particles;
    const auto size = static_cast<Eigen::Index>(p.size());
    Eigen::VectorXd given = Eigen::VectorXd::Zero(3 * size);
    std::vector<bool> held(3 * p.size(), false);
    for (Eigen::Index i = 0; i < size; ++i)
      if (const double x = p.x[i] - kRadius * kDiscs; std::abs(x) > kRadius * (kDiscs - 2.5)) {
        held[3 * i] = true;
        given[3 * i] = x * at(above_axis(i));
      }
    held[1] = true;
    Eigen::SparseMatrix<double> inner = stiffness_;
    inner.prune([&held](Eigen::Index i, Eigen::Index j, double) { return !held[i] && !held[j]; });
    Eigen::VectorXd right = -(stiffness_ * given);
    for (Eigen::Index i = 0; i < 3 * size; ++i)
      if (held[i]) {
        inner.coeffRef(i, i) = 1;
        right[i] = 0;
      }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(inner);
    ASSERT_EQ(solver.info(), Eigen::Success);
    moved_ = given + solver.solve(right);
    const Eigen::VectorXd forces = stiffness_ * moved_;
    force_ = moment_ = 0;
    for (Eigen::Index i = 0; i < size; ++i)
      if (held[3 * i] && p.x[i] > kRadius * kDiscs) {
        force_ += forces[3 * i];
        moment_ += forces[3 * i] * above_axis(i);
      }
  }

  double force() const { return force_; }
  double moment() const { return moment_; }
  // Strain of the uppermost or lowest row, between its discs in the middle.
  double strain(bool upper) const {
    const Particles& p = strip_.particles;
    const double y = upper ? *std::ranges::max_element(p.y) : *std::ranges::min_element(p.y);
    Eigen::Index left = -1, right = -1;
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(p.size()); ++i) {
      if (std::abs(p.y[i] - y) > 1e-9) continue;
      if (p.x[i] < kRadius * kDiscs - 10) left = i;
      if (p.x[i] < kRadius * kDiscs + 10) right = i;
    }
    return (moved_[3 * right] - moved_[3 * left]) / (p.x[right] - p.x[left]);
  }
  // The largest share of its strength that a bond between two discs of the middle bears.
  double strongest_share() const {
    double largest = 0;
    const Particles& p = strip_.particles;
    for (const Run& run : strip_.bonds.runs)
      for (std::uint32_t k = 0; k < run.count; ++k) {
        const Eigen::Index i = run.first + k, j = run.second + k;
        if (std::abs(p.x[i] - kRadius * kDiscs) > 10) continue;
        const double elongation = ((moved_[3 * j] - moved_[3 * i]) * run.rest_x +
                                   (moved_[3 * j + 1] - moved_[3 * i + 1]) * run.rest_y) /
                                  (2 * kRadius);
        const ContactBond own = scaled(law_, run.factors);
        largest = std::max(largest, own.stiffness.normal * elongation / own.tensile_strength);
      }
    return largest;
  }

  double height() const { return height_; }
  double inertia() const { return height_ * height_ * height_ / 12; }
  // Of the solid along its rows, where bonds without factors break.
  double tensile_strength() const {
    const auto [kn, ks] = law_.stiffness;
    return kStrength * std::numbers::sqrt3 * (kn + ks) / (kRadius * (3 * kn + ks));
  }
  double pitch_of_outer_rows() const { return height_ - std::numbers::sqrt3 * kRadius; }
  const Assembly& assembly() const { return strip_; }
  const ContactBond& law() const { return law_; }
  const Model& model() const { return model_; }

 private:
  double above_axis(Eigen::Index disc) const { return strip_.particles.y[disc] - height_ / 2; }

  ContactBond law_;
  double height_;
  Model model_;
  Assembly strip_;
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::VectorXd moved_;
  double force_ = 0, moment_ = 0;
};

class ThinStrips : public testing::TestWithParam<std::tuple<std::uint32_t, double>> {
 protected:
  Strip strip_{std::get<0>(GetParam()), std::get<1>(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(All, ThinStrips,
                         testing::Combine(testing::Values(3, 4, 5, 9), testing::Values(0, 0.2, 0.3)));

TEST_P(ThinStrips, StretchAsTheSolid) {
  strip_.deform([](double) { return 1e-3; });
  const double strain = (strip_.strain(true) + strip_.strain(false)) / 2;
  EXPECT_NEAR(strip_.force() / strain / (kYoung * strip_.height()), 1, 1e-4);
}

TEST_P(ThinStrips, BendAsTheSolidAndBreakAtItsStress) {
  strip_.deform([](double y) { return 1e-3 * y; });
  const double curvature = (strip_.strain(true) - strip_.strain(false)) / strip_.pitch_of_outer_rows();
  EXPECT_NEAR(strip_.moment() / curvature / (kYoung * strip_.inertia()), 1, 1e-4);
  const double outer_fibre = strip_.moment() / strip_.inertia() * strip_.height() / 2;
  EXPECT_NEAR(strip_.strongest_share() / (outer_fibre / strip_.tensile_strength()), 1, 1e-3);
}

// The bound of either engine is below the exact step, and not wastefully.
TEST_P(ThinStrips, HaveACriticalStepThatFollows) {
  Model small = test::lattice_in({0, 8, 0, strip_.height()}, kRadius, 2.0, strip_.law());
  stiffen_outer_rows(small);
  const Assembly a = test::assemble(small, 2.0);
  const Eigen::MatrixXd mass = test::mass_diagonal(a.particles).asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(test::stiffness_matrix(strip_.law(), a)), mass, Eigen::EigenvaluesOnly);
  const double exact = 2 / std::sqrt(modes.eigenvalues().maxCoeff());
  const double bound = critical_step(a, strip_.law().stiffness);
  EXPECT_LE(bound, exact);
  EXPECT_GT(bound, 0.6 * exact);
}

TEST(ThinStripFactors, LeaveAllOtherBondsAlone) {
  const Strip strip(5, 0.2);
  const Model& model = strip.model();
  EXPECT_FALSE(why_more_than_lattice(model).has_value());
  for (const Bond& bond : model.bonds) {
    const bool along = model.discs.y[bond.first] == model.discs.y[bond.second];
    const long row = std::lround(model.discs.y[bond.first] / (std::numbers::sqrt3 * kRadius) - 0.5);
    const std::uint32_t expected = !along || row == 2 ? 0 : row == 0 || row == 4 ? 1 : 2;
    EXPECT_EQ(bond.number, expected);
  }
}

TEST(ThinStripFactors, NeedFreeFaces) {
  const Model model = test::lattice_in({0, 8, 0, 5}, kRadius);
  std::vector<double> weights(model.discs.size(), 1.0);
  EXPECT_TRUE(faces_are_free(model.discs, weights));
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (model.discs.y[i] < 1) weights[i] = 0.5;
  EXPECT_FALSE(faces_are_free(model.discs, weights));
}

}  // namespace
}  // namespace adit::dem::thin_strip_test
