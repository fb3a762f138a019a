// Requirement: the summary tells how far a closed lining was pushed out of shape: the diameter of a circle,
// the top of any other against its bottom, whatever else it does.
#include "fdm_server/supports/peak_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace adit::fdm::peak_shapes_test {
namespace {

constexpr double kPi = std::numbers::pi;

struct Shaped {
  Grid grid;
  std::vector<Lining> linings;
};

// A lining through these places; spacings around a circle may differ.
Shaped lining(std::vector<double> x, std::vector<double> y, bool closed = true) {
  Lining one{.name = "l", .path = {{}, closed}, .first_beam = 0, .beams = 0};
  for (std::uint32_t k = 0; k < x.size(); ++k) one.path.points.push_back(k);
  Shaped shaped{.grid = {.x = std::move(x), .y = std::move(y), .zones = {}}, .linings = {}};
  shaped.linings.push_back(one);
  return shaped;
}

Shaped circle(double radius, std::size_t nodes) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < nodes; ++k) {
    const double t = 2 * kPi * static_cast<double>(k) / static_cast<double>(nodes);
    x.push_back(7 + radius * std::cos(t));
    y.push_back(-20 + radius * std::sin(t));
  }
  return lining(x, y);
}

// A motion as a whole, a turn, a pressure and an ovaling by `size` whose longer diameter lies at `angle`.
std::array<std::vector<double>, 2> moved(const Grid& grid, double size, double angle) {
  std::array<std::vector<double>, 2> u;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double x = grid.x[i] - 7, y = grid.y[i] + 20, t = std::atan2(y, x);
    const double radial = -2e-3 + size / 2 * std::cos(2 * (t - angle)),
                 around = 3e-3 - size / 4 * std::sin(2 * (t - angle));
    u[0].push_back(0.05 + radial * std::cos(t) - around * std::sin(t));
    u[1].push_back(-0.03 + radial * std::sin(t) + around * std::cos(t));
  }
  return u;
}

TEST(PeakShapes, ACircleOvals) {
  const Shaped shaped = circle(3, 48);
  PeakShapes peaks(shaped.grid, shaped.linings);
  EXPECT_FALSE(peaks.of(0));
  ASSERT_TRUE(peaks.ovals(0));
  for (const auto& [time, size, angle] :
       {std::array{0.0, 0.0, 0.0}, {0.1, 4e-3, kPi / 4}, {0.2, 9e-3, -kPi / 6}, {0.3, 1e-3, 0.2}}) {
    const auto [ux, uy] = moved(shaped.grid, size, angle);
    peaks.take(ux, uy, time);
  }
  const PeakShapes::Peak peak = *peaks.of(0);
  EXPECT_NEAR(peak.size, 9e-3, 1e-12);
  EXPECT_NEAR(peak.angle, -kPi / 6, 1e-9);
  EXPECT_EQ(peak.time, 0.2);
}

TEST(PeakShapes, ABoxRacksWithItsSign) {
  const Shaped shaped = lining({-2, 0, 2, 2, 2, 0, -2, -2}, {0, 0, 0, 1.5, 3, 3, 3, 1.5});
  PeakShapes peaks(shaped.grid, shaped.linings);
  EXPECT_FALSE(peaks.ovals(0));
  for (const double shear : {1e-3, -4e-3, 2e-3}) {
    std::vector<double> ux, uy(shaped.grid.x.size(), 0.01);
    for (const double y : shaped.grid.y) ux.push_back(0.02 + shear * y);
    peaks.take(ux, uy, shear);
  }
  EXPECT_NEAR(peaks.of(0)->size, -4e-3 * 3, 1e-12);
  EXPECT_EQ(peaks.of(0)->time, -4e-3);
}

TEST(PeakShapes, AnOpenLiningHasNone) {
  const Shaped shaped = lining({0, 1, 2}, {0, 0, 0}, false);
  PeakShapes peaks(shaped.grid, shaped.linings);
  const std::vector<double> u(3, 1.0);
  peaks.take(u, u, 0);
  EXPECT_FALSE(peaks.of(0));
}

}  // namespace
}  // namespace adit::fdm::peak_shapes_test
