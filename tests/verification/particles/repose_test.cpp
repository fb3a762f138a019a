// A heap of discs with friction 0.5 comes to rest at the angle that such discs have.
//
// Deboeuf, Vilotte, Mangeney, Staron & Dauchot 2005 ("Evolution of the contact network during tilting cycles
// of a granular pile under gravity", Powders and Grains) tilted two-dimensional boxes of 4000 circular grains
// of friction 0.5: in the mean of 50 of them slopes begin to slide at 21 degrees and come to rest at 15. A
// heap that a wall lets go rests between; the slower the wall, the steeper it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::repose_test {
namespace {

constexpr double kGravity = 9.81, kLength = 110;  // [m/s^2], of the floor in mean diameters [m]
constexpr int kColumns = 36, kRows = 28;
const LinearContact kContact{1e8, 7.5e7, 0.5, 0.3, 0.3};

// A floor of discs that lie fast, discs of 0.8 to 1.2 m above it that will fall, and a wall at each end: the
// right one stands until `begin`, then goes to the right.
Model discs_in_a_box(unsigned seed, double begin, double speed) {
  std::mt19937 generator(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator()) / std::mt19937::max();
  };
  std::vector<std::array<double, 3>> discs;
  for (double x = 0.5; x < kLength; x += 1) discs.push_back({x, -0.5, 0.5});
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      discs.push_back({0.65 + 1.25 * column, 0.65 + 1.25 * row, between(0.4, 0.6)});
  Model model = test::loose_discs(discs, kContact);
  const double width = 1.25 * kColumns, height = 1.25 * kRows + 1;
  model.walls.push_back(test::wall(0, 0, 0, height, kContact));
  model.walls.push_back(test::wall(width, 0, width, height, kContact, speed));
  model.walls.back().time = [begin](double time) { return std::clamp(time - begin, 0.0, 1.0); };
  test::add_gravity(model, -kGravity);
  std::vector<std::uint32_t> floor(static_cast<std::size_t>(kLength));
  std::iota(floor.begin(), floor.end(), 0u);
  for (const Component component : {Component::kX, Component::kY, Component::kSpin})
    model.motions.push_back({component, floor, 0, test::always, "motions"});
  return model;
}

// Slope of the surface [degrees]: the line through the highest discs over every two metres, but for the top
// and the toe of the heap.
double slope_of(const Particles& p) {
  std::vector<double> top(static_cast<std::size_t>(kLength / 2), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] + p.ux[i];
    if (x < 0 || x >= kLength) continue;
    double& here = top[static_cast<std::size_t>(x / 2)];
    here = std::max(here, p.y[i] + p.uy[i]);
  }
  const double highest = std::ranges::max(top);
  double count = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < top.size(); ++k)
    if (top[k] > 0.15 * highest && top[k] < 0.85 * highest) {
      const double x = 2.0 * static_cast<double>(k) + 1, y = top[k];
      count += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
  return -std::atan((count * sxy - sx * sy) / (count * sxx - sx * sx)) * 180 / std::numbers::pi;
}

double slope_after_release(unsigned seed) {
  constexpr double kSettled = 10, kSpeed = 2, kEnd = kSettled + 45;
  const Model model = discs_in_a_box(seed, kSettled, kSpeed);
  Solver solver(model, 1);
  const Particles& p = solver.particles();
  Loads loads(model, p);
  PrescribedMotions motions(model, p);
  const double dt = 0.7 * critical_step(model);
  for (std::uint64_t n = 0; static_cast<double>(n) * dt < kEnd; ++n) solver.step({n, dt}, loads, motions);

  double fastest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) fastest = std::max(fastest, std::hypot(p.vx[i], p.vy[i]));
  EXPECT_LT(fastest, 0.01 * std::sqrt(kGravity)) << "the heap still moves";
  return slope_of(p);
}

TEST(AngleOfRepose, OfDiscsWithFriction) {
  for (const unsigned seed : {1, 2, 3}) {
    const double slope = slope_after_release(seed);
    RecordProperty("slope_of_seed_" + std::to_string(seed) + "_deg", std::to_string(slope));
    EXPECT_GT(slope, 15);
    EXPECT_LT(slope, 21);
  }
}

}  // namespace
}  // namespace adit::dem::repose_test
