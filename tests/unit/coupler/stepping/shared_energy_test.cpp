// Zones and particles share the energy by the weights: means of the samples, zones that exist, and the sum
// over both.
#include <algorithm>
#include <vector>

#include "fdm_server/grid/samples.hpp"
#include "protocol/geometry/shape.hpp"
#include "tests/support/weighted_lattice.hpp"
#include "tests/unit/coupler/bridging/random_overlaps.hpp"

namespace adit::coupler::shared_energy_test {
namespace {

constexpr double kFloor = 1e-12;

fdm::Block random_block() {
  return {-3, 3, -3, 3, *rc::gen::inRange(4u, 40u), *rc::gen::inRange(4u, 40u)};
}

double zone_width(const fdm::Block& block) {
  return (block.x_max - block.x_min) / block.zones_x;
}
double zone_height(const fdm::Block& block) {
  return (block.y_max - block.y_min) / block.zones_y;
}

std::vector<double> zone_weights(const fdm::Block& block, const Overlap& overlap) {
  const fdm::Grid grid = make_grid(block);
  return fdm::zone_weights(grid, adit::test::outer_weights(overlap, fdm::sample_points(grid)), kFloor);
}

BoundingBox zone_box(const fdm::Block& block, std::size_t i, std::size_t j) {
  const double x = block.x_min + i * zone_width(block), y = block.y_min + j * zone_height(block);
  return {x, x + zone_width(block), y, y + zone_height(block)};
}

double mean_outer_weight(const Overlap& overlap, const BoundingBox& box) {
  constexpr int kPoints = 100;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i)
    for (int j = 0; j < kPoints; ++j)
      sum += overlap.outer_weight(std::lerp(box.x_min, box.x_max, (i + 0.5) / kPoints),
                                  std::lerp(box.y_min, box.y_max, (j + 0.5) / kPoints));
  return sum / (kPoints * kPoints);
}

// Simpson's rule and the mean of f over a length h differ by h ∫ K f', K(t) = t - 1/6 up to half the length,
// antisymmetric about it (the error for a step at t), whatever the kinks of f: by at most 5/36 h max |f'|.
// Along x then y, with mean values in between, the two directions add.
double largest_error(const fdm::Block& block, double slope) {
  return 5.0 / 36 * (zone_width(block) + zone_height(block)) * slope;
}

// Requirement: a zone's weight is the mean of the weights in it, however strips, corners and circles cut it.
RC_GTEST_PROP(ZoneWeight, IsTheMeanOverTheZone, ()) {
  const std::string ramp = *rc::gen::element("LINEAR", "CUBIC");
  const Overlap overlap = test::overlap_of(test::random_overlap(), ramp);
  const fdm::Block block = random_block();
  const auto i = *rc::gen::inRange(0u, block.zones_x), j = *rc::gen::inRange(0u, block.zones_y);
  const double slope = (ramp == "CUBIC" ? 1.5 : 1.0) / overlap.width();
  const double mean = mean_outer_weight(overlap, zone_box(block, i, j));
  const double reference_error = 0.01 * largest_error(block, slope);
  RC_ASSERT(std::abs(zone_weights(block, overlap)[j * block.zones_x + i] - mean) <=
            largest_error(block, slope) + reference_error + kFloor);
}

// Requirement: along x, an edge at the share t of a zone of width h makes an error of t (1 - 3 t) / 6 · h /
// Lo (with t up to one half, symmetric about it): + 1/72 to - 1/24.
RC_GTEST_PROP(ZoneWeight, CutByAStraightEdge, ()) {
  const double t = test::random_between(0, 1), h = 6.0 / 12, width = test::random_between(0.5, 2);
  const fdm::Block block{-3, 3, -3, 3, 12, 1};
  const double end = h * t;  // the outer model ends in zone 6, which begins at x = 0
  const Overlap overlap = test::overlap_of(test::strip(end + width, 0, end, 0));
  const double exact = h * (1 - t) * (1 - t) / 2 / width, s = std::min(t, 1 - t);
  RC_ASSERT(std::abs(zone_weights(block, overlap)[6] - exact - s * (1 - 3 * s) / 6 * h / width) <= 1e-9);
}

// Requirement: around a convex core no point that is coupled to the grid lies where a zone has vanished.
RC_GTEST_PROP(ZoneWeight, AZoneIsLeftWhereverTheOuterModelHasWeight, ()) {
  const bool strip = *rc::gen::inRange(0, 2) == 0;
  const Overlap overlap = test::overlap_of(
      strip ? test::random_strip() : test::ring(test::random_convex_shape(), test::random_between(0.01, 1)),
      *rc::gen::element("LINEAR", "CUBIC", "CONSTANT"));
  const fdm::Block block = random_block();
  const auto weights = zone_weights(block, overlap);
  for (int k = 0; k < 100; ++k) {
    const double x = test::random_between(-3, 3), y = test::random_between(-3, 3);
    if (overlap.outer_weight(x, y) == 0) continue;
    const auto i = std::min(static_cast<std::uint32_t>((x + 3) / zone_width(block)), block.zones_x - 1);
    const auto j = std::min(static_cast<std::uint32_t>((y + 3) / zone_height(block)), block.zones_y - 1);
    RC_ASSERT(weights[j * block.zones_x + i] > 0);
  }
}

// What fails for others, as overlap.hpp says: a hole between the samples, half a zone apart.
TEST(ZoneWeight, AHoleBetweenTheSamplesIsNotSeen) {
  const Overlap overlap =
      test::overlap_of(test::ring("polygon { " + test::star(0, 0, 4, 4, std::numbers::pi / 4, 1) +
                                      " holes { " + test::star(0.25, 0.25, 0.2, 4, 0, 1) + " } }",
                                  0.1));
  const fdm::Block block{-3, 3, -3, 3, 6, 6};
  EXPECT_EQ(overlap.outer_weight(0.25, 0.25), 1);
  EXPECT_EQ(zone_weights(block, overlap)[3 * 6 + 3], 0);
}

// Whether the weight is not linear in the box (corners suffice for a strip).
bool bends_in(const Overlap& overlap, const BoundingBox& box) {
  std::vector<double> depths;
  for (const geometry::Point& c : corners(box)) depths.push_back(overlap.depth(c.x, c.y));
  const auto [lowest, highest] = std::ranges::minmax(depths);
  if (overlap.is_ring()) return overlap.core().distance(box) < overlap.width() && !overlap.core().covers(box);
  return lowest < highest && (lowest == 0 || highest == 1);
}

// Weight and area of both models against the area that one of them has alone. The bound: each zone in which
// the weight bends is wrong by up to `largest_error`; each particle by up to (1 + 0.764) R / Lo, because its
// bonds' midpoints are R away from its centre, and the points of its cell 0.764 R (root mean square). Where
// the weight is linear both are exact.
struct Balance {
  double area, expected, bound;
};

// The particles' area is that of their cells, 2 R wide and sqrt(3) R high.
Balance balance(const Overlap& overlap, const fdm::Block& block, const dem::Model& lattice, double missing) {
  const auto weights = zone_weights(block, overlap);
  const double zone = zone_width(block) * zone_height(block);
  Balance result{0, (block.x_max - block.x_min) * (block.y_max - block.y_min) - missing, 1e-9};
  for (std::size_t j = 0; j < block.zones_y; ++j)
    for (std::size_t i = 0; i < block.zones_x; ++i) {
      result.area += zone * weights[j * block.zones_x + i];
      if (bends_in(overlap, zone_box(block, i, j)))
        result.bound += zone * largest_error(block, 1 / overlap.width());
    }
  const double radius = lattice.discs.radius[0], cell = 2 * std::numbers::sqrt3 * radius * radius;
  for (const double mass : dem::test::weighted_lattice(lattice, overlap, kFloor).particles.mass)
    result.area += cell * mass;
  for (std::size_t i = 0; i < lattice.discs.size(); ++i) {
    const double x = lattice.discs.x[i], y = lattice.discs.y[i];
    const BoundingBox reach{x - radius, x + radius, y - radius, y + radius};
    const bool at_surface = y - radius < lattice.extent.y_min || y + radius > lattice.extent.y_max ||
                            x - 2 * radius < lattice.extent.x_min || x + 2 * radius > lattice.extent.x_max;
    if (bends_in(overlap, reach) || (at_surface && overlap.depth(x, y) < 1))
      result.bound += cell * (1 + 0.764) * radius / overlap.width();
  }
  return result;
}

// Requirement: a coupled model has the mass and the stiffness of the one-sided one.
RC_GTEST_PROP(SharedEnergy, ARingKeepsTheArea, ()) {
  const Overlap overlap = test::overlap_of(test::ring(test::random_shape(), test::random_between(0.3, 1)));
  const auto lattice = dem::test::lattice_in({-2.9, 2.9, -2.9, 2.9}, test::random_between(0.02, 0.06));
  const Balance sum = balance(overlap, random_block(), lattice, 0);
  RC_ASSERT(std::abs(sum.area - sum.expected) <= sum.bound);
}

RC_GTEST_PROP(SharedEnergy, AStripKeepsTheArea, ()) {
  const double radius = test::random_between(0.02, 0.06), pitch = std::numbers::sqrt3 * radius;
  const double rows = std::floor(2 / pitch), length = 4 * radius * std::floor(2 / radius);
  const fdm::Block block{0, length, 0, rows * pitch, *rc::gen::inRange(5u, 40u), *rc::gen::inRange(1u, 10u)};
  const auto lattice = dem::test::lattice_in({0, length, 0, block.y_max}, radius);
  const double x = test::random_between(3, 4), width = test::random_between(0.3, 1),
               slope = test::random_between(-0.3, 0.3);
  const Overlap overlap = test::overlap_of(test::strip(x, 0, x + width, width * slope));
  // Every second row lacks half a cell at the bar's end.
  const Balance sum = balance(overlap, block, lattice, std::floor(rows / 2) * radius * pitch);
  RC_ASSERT(std::abs(sum.area - sum.expected) <= sum.bound);
}

}  // namespace
}  // namespace adit::coupler::shared_energy_test
