#include "dem_server/packing/voronoi/vertex_angles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace adit::dem::vertex_angles_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Around {
  std::vector<double> beside;
  double least;
};

// Degrees in and out.
Around about(std::vector<double> sectors) {
  for (double& sector : sectors) sector *= kDegree;
  auto beside = angles_beside_rays(sectors, sectors_with_one_nucleus(sectors));
  const double least = least_between_nuclei(sectors, beside) / kDegree;
  for (double& angle : beside) angle /= kDegree;
  return {std::move(beside), least};
}

void expect_angles(const std::vector<double>& sectors, const std::vector<double>& expected) {
  const auto beside = about(sectors).beside;
  ASSERT_EQ(beside.size(), expected.size());
  for (std::size_t k = 0; k < beside.size(); ++k) EXPECT_NEAR(beside[k], expected[k], 1e-9) << k;
}

// Where the sectors allow it, a nucleus belongs to two rays: one in a sharp corner, in each sector of a right
// crossing, in the right angles of a T, and in each sector of a Y, whatever its angles.
TEST(VertexAngles, RaysShareNuclei) {
  expect_angles({70, 290}, {35, 35});
  expect_angles({90, 90, 90, 90}, {45, 45, 45, 45});
  expect_angles({180, 90, 90}, {45, 45, 45});
  expect_angles({110, 120, 130}, {60, 50, 70});
  expect_angles({60, 120, 60, 120}, {30, 30, 30, 30});
}

// Nuclei about a vertex are never closer than half of the narrowest sector, and their order is that of the
// rays.
TEST(VertexAngles, NucleiKeepTheirDistance) {
  const auto expect_apart = [](const std::vector<double>& sectors) {
    EXPECT_GE(about(sectors).least, *std::ranges::min_element(sectors) / 2 * (1 - 1e-9))
        << testing::PrintToString(sectors);
  };
  for (double a = 25; a <= 155; a += 1) {
    expect_apart({a, 180 - a, a, 180 - a});
    expect_apart({180, a, 180 - a});
    expect_apart({a, 360 - a});
    for (double b = 25; a + b <= 155; b += 7) expect_apart({a, b, 180 - a - b, a, b, 180 - a - b});
    for (double b = 25; a + b <= 335; b += 7) expect_apart({a, b, 360 - a - b});
  }
}

}  // namespace
}  // namespace adit::dem::vertex_angles_test
