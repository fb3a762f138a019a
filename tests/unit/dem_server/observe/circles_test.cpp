#include "dem_server/observe/circles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "dem_server/model/calibration.hpp"
#include "dem_server/packing/random/random_dense.hpp"
#include "tests/support/lattice_model.hpp"

namespace adit::dem::circles_test {
namespace {

constexpr double kRadius = 0.5;

Model lattice(double size) {
  return test::lattice_in({-size, size, -size, size}, kRadius);
}

// Forces of an even strain in a lattice of bonds.
std::vector<Branch> even_forces(const Model& model, const BondStiffness& k, const Tensor& strain) {
  std::vector<Branch> branches;
  const auto& [x, y, radius] = model.discs;
  for (const Bond& bond : model.bonds) {
    const auto [lx, ly] = rest_vector(direction_of(model, bond).value(), kRadius);
    const double length = 2 * kRadius, nx = lx / length, ny = ly / length;
    const double ux = strain.xx * lx + strain.xy * ly, uy = strain.xy * lx + strain.yy * ly;
    const double normal = k.normal * (ux * nx + uy * ny), shear = k.shear * (uy * nx - ux * ny);
    branches.push_back({x[bond.first], y[bond.first], x[bond.second], y[bond.second],
                        normal * nx - shear * ny, normal * ny + shear * nx});
  }
  return branches;
}

double apart(const Tensor& a, const Tensor& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.yy - b.yy), std::abs(a.xy - b.xy)});
}

// An even state of a lattice: stress is the elastic solid's within 0.1 % from ten radii on, wherever the
// circle lies, and its error falls by more than 2^3 with twice the radius.
TEST(Circles, StressOfAnEvenState) {
  const double young = 25e9, nu = 0.2;
  const Tensor strain{2e-6, -1e-6, 3e-6};
  const auto branches = even_forces(lattice(24), calibrate(young, nu, Plane::kStress), strain);
  const double c = young / (1 - nu * nu);
  const Tensor expected{c * (strain.xx + nu * strain.yy), c * (strain.yy + nu * strain.xx),
                        young / (1 + nu) * strain.xy};
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> place(-2, 2);
  std::array<double, 2> worst{};
  for (int n = 0; n < 200; ++n) {
    const double x = place(generator), y = place(generator);
    for (std::size_t k = 0; k < 2; ++k)
      worst[k] = std::max(
          worst[k], apart(mean_stress({x, y, k == 0 ? 10 * kRadius : 20 * kRadius}, branches), expected));
  }
  EXPECT_LT(worst[0], 1e-3 * expected.xx);
  EXPECT_LT(worst[1], worst[0] / 8);
}

// A branch counts by the integral of the weight along what lies inside, here against a sum of small pieces:
// within the circle, across its edge, right through it; outside it counts nothing.
TEST(Circles, BranchesCountByWhatLiesInside) {
  const Circle circle{1, 2, 3};
  const std::array<double, 4> branches[] = {
      {1, 2, 2, 2.5}, {0, 1, 5, 4}, {-4, 1, 7, 3}, {5, 5, 6, 7}, {-4, 9, 7, 9}};
  const bool inside[] = {true, true, true, false, false};
  for (int b = 0; b < 5; ++b) {
    const auto [x_1, y_1, x_2, y_2] = branches[b];
    constexpr int kPieces = 100000;
    double mean = 0;
    for (int n = 0; n < kPieces; ++n) {
      const double s = (n + 0.5) / kPieces, x = x_1 + s * (x_2 - x_1) - circle.x,
                   y = y_1 + s * (y_2 - y_1) - circle.y;
      const double rho = 1 - (x * x + y * y) / 9;
      if (rho > 0) mean += 3 * rho * rho / (std::numbers::pi * 9) / kPieces;
    }
    const Branch branch{x_1, y_1, x_2, y_2, 7, -5};
    const Tensor stress = mean_stress(circle, {&branch, 1});
    EXPECT_EQ(mean > 0, inside[b]);
    EXPECT_NEAR(stress.xx, mean * 7 * (x_2 - x_1), 1e-8);
    EXPECT_NEAR(stress.yy, -mean * 5 * (y_2 - y_1), 1e-8);
    EXPECT_NEAR(stress.xy, mean * (7 * (y_2 - y_1) - 5 * (x_2 - x_1)) / 2, 1e-8);
  }
}

// Nothing jumps when a branch leaves the circle: its last thousandth of the radius counts by a millionth.
TEST(Circles, NothingJumpsAtTheEdge) {
  const auto at = [](double distance) {
    const Branch branch{distance, 0, distance + 0.1, 0, 1, 0};
    return mean_stress({0, 0, 1}, {&branch, 1}).xx;
  };
  EXPECT_LT(at(0.999), 1e-6 * at(0));
  EXPECT_GT(at(0.999), 0);
  EXPECT_EQ(at(1), 0);
}

// A random packing under pressure: all branches, walls' among them, weighed evenly carry the walls' stress
// (the virial theorem), and a circle over most of the box feels the same pressure within the packing's
// scatter.
TEST(Circles, StressOfARandomPacking) {
  const geometry::BoundingBox box{0, 1, 0, 1};
  const auto grown = pack_randomly({box, 0.01, 0.015, 0.16, 1e-3, 4, true});
  ASSERT_TRUE(grown);
  const Discs& d = grown->discs;
  std::vector<Branch> branches;
  for (const auto [i, j] : pairs_within(d, 0)) {
    const double lx = d.x[j] - d.x[i], ly = d.y[j] - d.y[i], length = std::hypot(lx, ly);
    const double pull = (length - d.radius[i] - d.radius[j]) / length;
    branches.push_back({d.x[i], d.y[i], d.x[j], d.y[j], pull * lx, pull * ly});
  }
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double x = d.x[i], y = d.y[i], r = d.radius[i];
    if (x < r) branches.push_back({x, y, 0, y, r - x, 0});
    if (1 - x < r) branches.push_back({x, y, 1, y, 1 - x - r, 0});
    if (y < r) branches.push_back({x, y, x, 0, 0, r - y});
    if (1 - y < r) branches.push_back({x, y, x, 1, 0, 1 - y - r});
  }
  constexpr double kFar = 1e4;
  const double to_box = std::numbers::pi * kFar * kFar / 3;
  const Tensor all = mean_stress({0.5, 0.5, kFar}, branches);
  EXPECT_NEAR(all.xx * to_box / -grown->state.stress_x, 1, 2e-3);
  EXPECT_NEAR(all.yy * to_box / -grown->state.stress_y, 1, 2e-3);
  EXPECT_NEAR(all.xy * to_box / grown->state.stress_x, 0, 2e-2);
  const Tensor most = mean_stress({0.5, 0.5, 0.5}, branches);
  EXPECT_NEAR((most.xx + most.yy) / -(grown->state.stress_x + grown->state.stress_y), 1, 0.05);
}

struct Moving {
  std::vector<double> x, y, vx, vy;
  Moving(int count, double u_x, double u_y, double v_x, double v_y) {
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int i = 0; i < count; ++i) {
      x.push_back(1e4 + place(generator));
      y.push_back(place(generator));
      vx.push_back(7 + u_x * (x[i] - 1e4) + u_y * y[i]);
      vy.push_back(-3 + v_x * (x[i] - 1e4) + v_y * y[i]);
    }
  }
  std::optional<Tensor> rate() const { return mean_strain_rate({1e4, 0, 1}, x, y, vx, vy); }
};

// A linear velocity field is found as it is, wherever the discs lie; a rotation is no strain.
TEST(Circles, StrainRateOfALinearField) {
  const auto rate = Moving(40, 0.1, 0.5, -0.2, 0.3).rate();
  ASSERT_TRUE(rate);
  EXPECT_LT(apart(*rate, {0.1, 0.3, 0.15}), 1e-10);
  EXPECT_LT(apart(*Moving(40, 0, 2, -2, 0).rate(), {0, 0, 0}), 1e-10);
}

// Two discs, discs in a row and no discs have no strain rate.
TEST(Circles, StrainRateNeedsThreeDiscs) {
  EXPECT_FALSE(Moving(2, 1, 0, 0, 1).rate());
  Moving row(20, 1, 0, 0, 1);
  for (std::size_t i = 0; i < row.x.size(); ++i) row.y[i] = 0.3 * (row.x[i] - 1e4);
  EXPECT_FALSE(row.rate());
  EXPECT_FALSE(Moving(0, 0, 0, 0, 0).rate());
}

// Porosity of a lattice is 1 - pi / (2 sqrt(3)); a disc covers what of it lies inside.
TEST(Circles, Porosity) {
  const Discs discs = lattice(24).discs;
  EXPECT_NEAR(porosity({0.3, 0.1, 20}, discs.x, discs.y, discs.radius),
              1 - std::numbers::pi / 2 / std::numbers::sqrt3, 5e-4);
  const auto of_one = [](double x, double r) {
    const double y = 0;
    return porosity({0, 0, 1}, {&x, 1}, {&y, 1}, {&r, 1});
  };
  EXPECT_NEAR(of_one(0.2, 0.5), 0.75, 1e-15);
  EXPECT_EQ(of_one(0, 2), 0);
  EXPECT_EQ(of_one(1.5, 0.5), 1);
  // Two equal circles, each through the middle of the other, share 2 pi / 3 - sqrt(3) / 2.
  EXPECT_NEAR(1 - of_one(1, 1), 2.0 / 3 - std::numbers::sqrt3 / 2 / std::numbers::pi, 1e-14);
  // A straight edge, nearly: half of the circle.
  EXPECT_NEAR(of_one(1e6, 1e6), 0.5, 1e-5);
}

// The mean number of neighbours: six in a lattice, none where no disc is.
TEST(Circles, Coordination) {
  const std::vector<double> x{0, 0.5, 3}, y{0, 0, 0};
  const std::vector<std::uint32_t> six{6, 6, 1}, mixed{4, 2, 100};
  EXPECT_DOUBLE_EQ(mean_coordination({0, 0, 1}, x, y, six), 6);
  // Weights 1 and (1 - 0.25)^2.
  EXPECT_DOUBLE_EQ(mean_coordination({0, 0, 1}, x, y, mixed), (4 + 2 * 0.5625) / 1.5625);
  EXPECT_EQ(mean_coordination({9, 9, 1}, x, y, six), 0);
}

}  // namespace
}  // namespace adit::dem::circles_test
