// Requirements on each zone by itself: stiffness, patch test, equality with incompatible modes, energy.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::zone_test {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Vector8 = Eigen::Matrix<double, 8, 1>;

const Corners kRectangle{{0, 0.5, 0.5, 0}, {0, 0, 0.25, 0.25}};
const Corners kQuadrilateral{{0.1, 1.3, 1.1, -0.2}, {-0.1, 0.2, 0.9, 0.7}};
const PlaneLaw kStress = plane_stress(kYoung, kPoisson);
const PlaneLaw kStrain = plane_strain(kYoung, kPoisson);

class EachZone : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EachZone, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// A zone resists every deformation, and only deformations: three rigid modes, five positive ones.
TEST_P(EachZone, StiffnessIsSymmetricWithThreeRigidModes) {
  for (const auto& c : {kRectangle, kQuadrilateral})
    for (const auto& law : {kStress, kStrain}) {
      const Matrix8 k = zone_stiffness(GetParam(), c, law);
      const double scale = k.cwiseAbs().maxCoeff();
      EXPECT_LE((k - k.transpose()).cwiseAbs().maxCoeff(), 1e-14 * scale);
      Eigen::Matrix<double, 8, 3> rigid;
      for (int a = 0; a < 4; ++a) {
        rigid.row(2 * a) << 1, 0, -c.y[a];
        rigid.row(2 * a + 1) << 0, 1, c.x[a];
      }
      EXPECT_LE((k * rigid).cwiseAbs().maxCoeff(), 1e-14 * scale);
      const Vector8 values = Eigen::SelfAdjointEigenSolver<Matrix8>(k).eigenvalues();
      EXPECT_LE(values.head(3).cwiseAbs().maxCoeff(), 1e-14 * values[7]);
      EXPECT_GE(values[3], 1e-2 * values[7]);
    }
}

// The zone's stiffness does not depend on how it lies: turning corners and loads together changes nothing.
TEST_P(EachZone, StiffnessTurnsWithTheZoneByAQuarter) {
  Corners turned{};
  for (int a = 0; a < 4; ++a) {
    turned.x[a] = -kQuadrilateral.y[a];
    turned.y[a] = kQuadrilateral.x[a];
  }
  Matrix8 turn = Matrix8::Zero();
  for (int a = 0; a < 4; ++a) {
    turn(2 * a, 2 * a + 1) = -1;
    turn(2 * a + 1, 2 * a) = 1;
  }
  const Matrix8 k = zone_stiffness(GetParam(), kQuadrilateral, kStrain);
  const Matrix8 other = zone_stiffness(GetParam(), turned, kStrain);
  EXPECT_LE((turn * k * turn.transpose() - other).cwiseAbs().maxCoeff(), 1e-13 * k.cwiseAbs().maxCoeff());
}

// Patch test: a linear displacement field gives uniform stress by Hooke's law and no force on inner points.
TEST_P(EachZone, PassesThePatchTestOnDistortedQuadrilaterals) {
  const Grid grid = distorted_grid({-1, 1, 0, 1, 5, 4});
  for (const bool is_stress : {true, false}) {
    const PlaneLaw law = is_stress ? kStress : kStrain;
    const double exx = 1e-3, eyy = -4e-4, gxy = 7e-4;
    const std::size_t n = grid.x.size();
    std::vector<double> vx(n), vy(n), fx(n), fy(n);
    for (std::size_t i = 0; i < n; ++i) {
      vx[i] = exx * grid.x[i] + 0.9 * gxy * grid.y[i] + 0.3;
      vy[i] = eyy * grid.y[i] + 0.1 * gxy * grid.x[i];
    }
    ElasticZones zones(GetParam(), grid, law, ones(grid));
    zones.follow(vx.data(), vy.data());
    zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});

    const double factor =
        is_stress ? kYoung / (1 - kPoisson * kPoisson) : kYoung / ((1 + kPoisson) * (1 - 2 * kPoisson));
    const double own = is_stress ? factor : factor * (1 - kPoisson), other = factor * kPoisson;
    const double sxx = own * exx + other * eyy, syy = own * eyy + other * exx;
    const double sxy = kYoung / (2 * (1 + kPoisson)) * gxy;
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      EXPECT_NEAR(zones.stress(z).xx, sxx, 1e-12 * sxx);
      EXPECT_NEAR(zones.stress(z).yy, syy, 1e-12 * sxx);
      EXPECT_NEAR(zones.stress(z).xy, sxy, 1e-12 * sxx);
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (std::abs(grid.x[i]) == 1 || grid.y[i] == 0 || grid.y[i] == 1) continue;
      EXPECT_NEAR(fx[i], 0, 1e-12 * sxx);
      EXPECT_NEAR(fy[i], 0, 1e-12 * sxx);
    }
    EXPECT_NEAR(zones.strain_energy(), 0.5 * 2 * (sxx * exx + syy * eyy + sxy * gxy), 1e-12 * sxx * exx);
  }
}

// The strain energy is the work that the internal forces took: 1/2 u.K u, also of bending and with weights.
TEST_P(EachZone, StrainEnergyIsHalfDisplacementTimesForce) {
  const Grid grid = distorted_grid({0, 2, 0, 1, 4, 3});
  std::vector<double> weights(grid.zones.size());
  for (std::size_t z = 0; z < weights.size(); ++z) weights[z] = 0.1 + 0.07 * static_cast<double>(z);
  const std::size_t n = grid.x.size();
  std::vector<double> ux(n), uy(n), fx(n), fy(n);
  for (std::size_t i = 0; i < n; ++i) {
    ux[i] = 1e-3 * std::sin(3.7 * static_cast<double>(i));
    uy[i] = 1e-3 * std::cos(5.1 * static_cast<double>(i));
  }
  ElasticZones zones(GetParam(), grid, kStrain, weights);
  zones.follow(ux.data(), uy.data());
  zones.add_forces(1.0, {ux.data(), uy.data(), fx.data(), fy.data()});
  double work = 0;
  for (std::size_t i = 0; i < n; ++i) work -= 0.5 * (ux[i] * fx[i] + uy[i] * fy[i]);
  EXPECT_NEAR(zones.strain_energy(), work, 1e-13 * work);
}

// Where displacements start over, the stresses stay, bending included: the same forces and the same energy.
TEST_P(EachZone, StressesStayWhereDisplacementsStartOver) {
  const Grid grid = distorted_grid({0, 2, 0, 1, 4, 3});
  const std::size_t n = grid.x.size();
  std::vector<double> ux(n), uy(n), before(n), after(n), fy(n);
  for (std::size_t i = 0; i < n; ++i) {
    ux[i] = 1e-3 * std::sin(3.7 * static_cast<double>(i));
    uy[i] = 1e-3 * std::cos(5.1 * static_cast<double>(i));
  }
  ElasticZones zones(GetParam(), grid, kStrain, ones(grid));
  zones.follow(ux.data(), uy.data());
  zones.set_stress(5, {1e6, -2e6, 3e5});
  zones.add_forces(1.0, {ux.data(), uy.data(), before.data(), fy.data()});
  const double energy = zones.strain_energy(), xx = zones.stress(5).xx;
  zones.start_over();
  std::ranges::fill(ux, 0.0);
  std::ranges::fill(uy, 0.0);
  zones.add_forces(1.0, {ux.data(), uy.data(), after.data(), fy.data()});
  double largest = 0;
  for (const double force : before) largest = std::max(largest, std::abs(force));
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(after[i], before[i], 1e-14 * largest);
  EXPECT_NEAR(zones.strain_energy(), energy, 1e-14 * energy);
  EXPECT_NEAR(zones.stress(5).xx, xx, 1e-14 * std::abs(xx));
}

// Rows of zones and single zones are computed alike, whether the row's zones are equal or all different: a
// run is cut nowhere, whatever its length.
TEST_P(EachZone, ForcesDoNotDependOnHowZonesAreGrouped) {
  constexpr Block kBlock{0, 150, 0, 2, 150, 2};  // longer than two batches
  for (const Grid& grid : {make_grid(kBlock), distorted_grid(kBlock)}) {
    Grid backwards = grid;  // runs of one zone
    std::ranges::reverse(backwards.zones);
    const Eigen::VectorXd u = Eigen::VectorXd::NullaryExpr(
        2 * static_cast<Eigen::Index>(grid.x.size()), [](Eigen::Index i) { return std::sin(1.3 * i * i); });
    const Eigen::VectorXd f = forces(GetParam(), grid, kStress, u);
    EXPECT_LE((f - forces(GetParam(), backwards, kStress, u)).cwiseAbs().maxCoeff(),
              1e-13 * f.cwiseAbs().maxCoeff());
  }
}

// Stiffness of the zone with the incompatible modes 1 - xi^2, 1 - eta^2 (Wilson, Taylor), condensed; written
// from the textbook, without anything of the kernel.
Matrix8 incompatible_modes_stiffness(double width, double height, const Eigen::Matrix3d& law) {
  const double g = 1 / std::sqrt(3.0);
  const int sx[] = {-1, 1, 1, -1}, sy[] = {-1, -1, 1, 1};
  Eigen::Matrix<double, 12, 12> full = Eigen::Matrix<double, 12, 12>::Zero();
  for (const double xi : {-g, g})
    for (const double eta : {-g, g}) {
      Eigen::Matrix<double, 3, 12> b = Eigen::Matrix<double, 3, 12>::Zero();
      const auto set = [&](int function, double dx, double dy) {
        b(0, 2 * function) = b(2, 2 * function + 1) = dx;
        b(1, 2 * function + 1) = b(2, 2 * function) = dy;
      };
      for (int a = 0; a < 4; ++a)
        set(a, sx[a] * (1 + sy[a] * eta) / (2 * width), sy[a] * (1 + sx[a] * xi) / (2 * height));
      set(4, -4 * xi / width, 0);
      set(5, 0, -4 * eta / height);
      full += b.transpose() * law * b * (width * height / 4);
    }
  return full.topLeftCorner<8, 8>() - full.topRightCorner<8, 4>() * full.bottomRightCorner<4, 4>().inverse() *
                                          full.bottomLeftCorner<4, 8>();
}

// On rectangles the default zone is the zone with incompatible modes, in both plane conditions.
TEST(AssumedStrain, EqualsIncompatibleModesOnRectangles) {
  const double e = kYoung, nu = kPoisson;
  Eigen::Matrix3d stress, strain;
  stress << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  stress *= e / (1 - nu * nu);
  strain << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, (1 - 2 * nu) / 2;
  strain *= e / ((1 + nu) * (1 - 2 * nu));
  for (const double height : {0.25, 0.5, 1.7}) {
    const Corners c{{0, 0.5, 0.5, 0}, {0, 0, height, height}};
    const Matrix8 in_stress = incompatible_modes_stiffness(0.5, height, stress);
    const Matrix8 in_strain = incompatible_modes_stiffness(0.5, height, strain);
    const double tolerance = 1e-13 * in_strain.cwiseAbs().maxCoeff();
    EXPECT_LE((zone_stiffness(ZoneKind::kAssumedStrain, c, kStress) - in_stress).cwiseAbs().maxCoeff(),
              tolerance);
    EXPECT_LE((zone_stiffness(ZoneKind::kAssumedStrain, c, kStrain) - in_strain).cwiseAbs().maxCoeff(),
              tolerance);
  }
}

// Stiffness of two overlays of constant-strain triangles whose isotropic strain is averaged pair by pair;
// written with full strain-displacement matrices.
Matrix8 two_overlays_stiffness(const Corners& c, const Eigen::Matrix3d& law) {
  const int overlays[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{0, 1, 3}, {1, 2, 3}}};
  Matrix8 stiffness = Matrix8::Zero();
  for (const auto& overlay : overlays) {
    Eigen::Matrix<double, 3, 8> b[2] = {Eigen::Matrix<double, 3, 8>::Zero(),
                                        Eigen::Matrix<double, 3, 8>::Zero()};
    double areas[2] = {};
    for (int k = 0; k < 2; ++k) {
      const auto& t = overlay[k];
      for (int a = 0; a < 3; ++a) {
        const int j = t[(a + 1) % 3], l = t[(a + 2) % 3];
        b[k](0, 2 * t[a]) = b[k](2, 2 * t[a] + 1) = c.y[j] - c.y[l];
        b[k](1, 2 * t[a] + 1) = b[k](2, 2 * t[a]) = c.x[l] - c.x[j];
        areas[k] += 0.5 * c.x[t[a]] * (c.y[j] - c.y[l]);
      }
      b[k] /= 2 * areas[k];
    }
    const auto dilation = [&](int k) { return Eigen::Matrix<double, 1, 8>(b[k].row(0) + b[k].row(1)); };
    const Eigen::Matrix<double, 1, 8> mean =
        (areas[0] * dilation(0) + areas[1] * dilation(1)) / (areas[0] + areas[1]);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Matrix<double, 1, 8> correction = (mean - dilation(k)) / 2;
      b[k].row(0) += correction;
      b[k].row(1) += correction;
      stiffness += 0.5 * areas[k] * b[k].transpose() * law * b[k];
    }
  }
  return stiffness;
}

// The mixed-discretization zone is the mean of its two overlays on any quadrilateral, although the kernel
// keeps one isotropic stress only.
TEST(MixedDiscretization, EqualsTheMeanOfTwoOverlays) {
  const double e = kYoung, nu = kPoisson;
  Eigen::Matrix3d strain;
  strain << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, (1 - 2 * nu) / 2;
  strain *= e / ((1 + nu) * (1 - 2 * nu));
  for (const auto& c : {kRectangle, kQuadrilateral}) {
    const Matrix8 expected = two_overlays_stiffness(c, strain);
    EXPECT_LE((zone_stiffness(ZoneKind::kMixedDiscretization, c, kStrain) - expected).cwiseAbs().maxCoeff(),
              1e-13 * expected.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace adit::fdm::test::zone_test
