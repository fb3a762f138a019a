// Requirements on grids of several blocks, and on what they say where blocks do not fit.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <cmath>
#include <numbers>

#include "fdm_server/grid/samples.hpp"
#include "fdm_server/model/grid/read_grid.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"

namespace adit::fdm::test::blocks_test {
namespace {

using testing::HasSubstr;

Grid grid_of(const std::string& text) {
  scene::Continuum continuum;
  if (!google::protobuf::TextFormat::ParseFromString(text, &continuum))
    throw std::logic_error("the test's scene cannot be parsed: " + text);
  protocol::check_rules(continuum, "continuum");
  return read_grid(continuum);
}

double whole_area(const Grid& grid) {
  double sum = 0;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) sum += area(corners(grid, z));
  return sum;
}

double outline(const Grid& grid) {
  double sum = 0;
  for (const auto& [from, to, zone] : grid.boundary)
    sum += std::hypot(grid.x[to] - grid.x[from], grid.y[to] - grid.y[from]);
  return sum;
}

std::string rectangle(double x_min, double x_max, double y_min, double y_max, const std::string& along,
                      const std::string& across, const std::string& name = "") {
  return (name.empty() ? "blocks { " : "blocks { name: '" + name + "' ") +
         "rectangle { x_min: " + std::to_string(x_min) + " x_max: " + std::to_string(x_max) +
         " y_min: " + std::to_string(y_min) + " y_max: " + std::to_string(y_max) + " } along { " + along +
         " } across { " + across + " } } ";
}

// Requirement: one rectangle is what `block` makes: the same zones, in rows of long runs.
TEST(Blocks, ARectangleIsABlock) {
  const Grid one = grid_of("block { x_min: -1 x_max: 3 y_min: 0.5 y_max: 2 zones_x: 7 zones_y: 3 }");
  const Grid same = grid_of(rectangle(-1, 3, 0.5, 2, "zones: 7", "zones: 3"));
  EXPECT_EQ(one.zones, same.zones);
  for (std::size_t i = 0; i < one.x.size(); ++i) {
    EXPECT_NEAR(one.x[i], same.x[i], 1e-15);
    EXPECT_NEAR(one.y[i], same.y[i], 1e-15);
  }
  EXPECT_EQ(lay_out(same).runs.size(), 3u);
}

// Requirement: blocks share the points of their common side, whose edges are no boundary; each is a group.
TEST(Blocks, AreJoinedAlongTheirSides) {
  const Grid grid = grid_of(rectangle(0, 2, 0, 1, "zones: 4", "zones: 2", "left") +
                            rectangle(2, 5, 0, 1, "zones: 3", "zones: 2", "right") +
                            rectangle(0, 2, 1, 3, "zones: 4", "zones: 3", "left"));
  EXPECT_EQ(grid.x.size(), 15u + 9 + 15);
  EXPECT_NEAR(outline(grid), 16, 1e-12);
  EXPECT_NEAR(whole_area(grid), 9, 1e-12);
  ASSERT_EQ(grid.groups.size(), 2u);
  EXPECT_EQ(grid.groups[0].zones.size(), 8u + 12);
  EXPECT_EQ(grid.groups[1].zones.front(), 8u);
  EXPECT_LE(lay_out(grid).runs.size(), 7u + 2);  // a run a row; one more where a row begins at a shared point
}

// Requirement: sizes grow by the ratio, from one end or from both.
TEST(Blocks, ZonesAreGraded) {
  const Grid grid =
      grid_of(rectangle(0, 15, 0, 10, "zones: 4 ratio: 2", "zones: 4 ratio: 4 from_both_ends: true"));
  for (const auto& [point, x] : {std::pair(0, 0.0), {1, 1.0}, {2, 3.0}, {3, 7.0}, {4, 15.0}})
    EXPECT_NEAR(grid.x[point], x, 1e-14);
  for (const auto& [row, y] : {std::pair(0, 0.0), {1, 1.0}, {2, 5.0}, {3, 9.0}, {4, 10.0}})
    EXPECT_NEAR(grid.y[5 * row], y, 1e-14);
}

// Requirement: the points of an arc lie on it at equal angles, by centre or through a point, of either sense;
// the corners may run either way round. The centre of the arcs is (5, -2).
TEST(Blocks, SidesAreArcs) {
  const std::string corners =
      "corners { x: 6 y: -2 } corners { x: 8 y: -2 } corners { x: 5 y: 1 } corners { x: 5 y: -1 } ";
  const std::string mirrored =
      "corners { x: 6 y: -2 } corners { x: 5 y: -1 } corners { x: 5 y: 1 } corners { x: 8 y: -2 } ";
  const double h = std::numbers::sqrt2 / 2;
  const std::string through =
      " through { x: " + std::to_string(5 + 3 * h) + " y: " + std::to_string(-2 + 3 * h) + " } ";
  for (const std::string& shape :
       {corners + "arcs { side: LEFT centre { x: 5 y: -2 } } arcs { side: RIGHT " + through + "}",
        mirrored + "arcs { side: LOWER centre { x: 5 y: -2 } } arcs { side: UPPER " + through + "}"}) {
    const bool turned = shape.starts_with(mirrored);
    const Grid grid =
        grid_of("blocks { quadrilateral { " + shape + " } along { zones: " + (turned ? "8" : "4") +
                " } across { zones: " + (turned ? "4" : "8") + " } }");
    EXPECT_GT(area(adit::fdm::corners(grid, 0)), 0);
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      const double row = turned ? static_cast<double>(i % 9) : std::floor(static_cast<double>(i) / 5);
      const double column = turned ? std::floor(static_cast<double>(i) / 9) : static_cast<double>(i % 5);
      EXPECT_NEAR(std::hypot(grid.x[i] - 5, grid.y[i] + 2), 1 + column / 2, 2e-6);
      EXPECT_NEAR(std::atan2(grid.y[i] + 2, grid.x[i] - 5), row * std::numbers::pi / 16, 1e-6);
    }
  }
}

// Requirement: rings of circles and squares around one another, around a square core, leave no gap: the area
// is that of the outer square, the outline its four sides.
TEST(Blocks, RingsSurroundACore) {
  const Grid grid = grid_of(
      "blocks { name: 'core' rectangle { x_min: -0.4 x_max: 1.6 y_min: 1 y_max: 3 } along { zones: 8 } "
      "across { zones: 8 } } "
      "blocks { name: 'core' ring { centre { x: 0.6 y: 2 } inner_side: 2 outer_radius: 2 } along { zones: 32 "
      "} across { "
      "zones: 5 } } "
      "blocks { name: 'ground' ring { centre { x: 0.6 y: 2 } inner_radius: 2 outer_side: 20 } along { zones: "
      "32 } across "
      "{ zones: 10 ratio: 1.2 } }");
  EXPECT_NEAR(whole_area(grid), 400, 1e-9);
  EXPECT_NEAR(outline(grid), 80, 1e-9);
  EXPECT_EQ(grid.zones.size(), 64u + 160 + 320);
  EXPECT_EQ(grid.x.size(), 81u + 160 + 320);
}

using Case = adit::test::RefusedText;
class BlockError : public testing::TestWithParam<Case> {};

TEST_P(BlockError, NamesTheBlockThePlaceAndTheRemedy) {
  adit::test::expect_refusal([&] { grid_of(GetParam().text); }, GetParam().path, GetParam().message);
}

std::string shaped(const std::string& shape, const std::string& along = "zones: 4") {
  return "blocks { " + shape + " along { " + along + " } across { zones: 4 } }";
}
const std::string kSquare = rectangle(0, 1, 0, 1, "zones: 4", "zones: 4", "ground");
const std::string kCorners =
    "corners { x: 0 y: 0 } corners { x: 1 y: 0 } corners { x: 1 y: 1 } corners { x: 0 y: 1 } ";

INSTANTIATE_TEST_SUITE_P(
    Blocks, BlockError,
    testing::Values(
        Case{"no_grid", "", "continuum", "has no grid"},
        Case{"two_grids", kSquare + "block { x_min: 0 x_max: 1 y_min: 0 y_max: 1 zones_x: 1 zones_y: 1 }",
             "continuum", "has more than one grid"},
        Case{"other_count", kSquare + rectangle(1, 2, 0, 1, "zones: 4", "zones: 3", "lining"),
             "continuum.blocks",
             "a point of zone 7 of blocks[0] (`ground`) lies on a side of zone 0 of blocks[1] (`lining`)"},
        Case{"other_ratio", kSquare + rectangle(1, 2, 0, 1, "zones: 4", "zones: 4 ratio: 1.1"),
             "continuum.blocks", "is not joined at (1, 0.25) m"},
        Case{"overlap", kSquare + rectangle(0.9, 2, 0.1, 0.9, "zones: 4", "zones: 4"), "continuum.blocks",
             "overlaps itself at (1, 0.25) m"},
        Case{"almost_joined", kSquare + rectangle(1.0001, 2, 0, 1, "zones: 4", "zones: 4"),
             "continuum.blocks", "each have a point of their own there"},
        Case{"apart", kSquare + rectangle(1.1, 2, 0, 1, "zones: 4", "zones: 4"), "continuum.blocks",
             "falls into pieces: zone 0 of blocks[1]"},
        Case{"hinge", kSquare + rectangle(1, 2, 1, 2, "zones: 4", "zones: 4"), "continuum.blocks",
             "falls into pieces"},
        Case{"no_shape", shaped(""), "continuum.blocks[0]", "has no shape"},
        Case{"open_rectangle", shaped("rectangle { x_min: 0 y_min: 0 y_max: 1 }"),
             "continuum.blocks[0].rectangle.x_max", "is missing; write for example `x_max: 2 m`"},
        Case{"no_zones", shaped("rectangle { x_min: 0 x_max: 1 y_min: 0 y_max: 1 }", "zones: 0"),
             "continuum.blocks[0].along.zones", "is 0, expected a whole number above 0"},
        Case{"steep_ratio", shaped("rectangle { x_min: 0 x_max: 1 y_min: 0 y_max: 1 }", "zones: 50 ratio: 2"),
             "continuum.blocks[0].along.ratio", "is 2 over 50 zones"},
        Case{"huge", shaped("rectangle { x_min: 0 x_max: 1 y_min: 0 y_max: 1 }", "zones: 4000000000"),
             "continuum.blocks", "use larger zones"},
        Case{"three_corners",
             shaped("quadrilateral { corners { x: 0 y: 0 } corners { x: 1 y: 0 } corners { x: 1 y: 1 } }"),
             "continuum.blocks[0].quadrilateral.corners", "has 3 elements, expected 4"},
        Case{"bow_tie",
             shaped("quadrilateral { corners { x: 0 y: 0 } corners { x: 1 y: 1 } corners { x: 1 y: 0 } "
                    "corners { x: 0 "
                    "y: 1 } }"),
             "continuum.blocks", "has a tangled zone: zone"},
        Case{"arc_centre",
             shaped("quadrilateral { " + kCorners + "arcs { side: LOWER centre { x: 0.4 y: 2 } } }"),
             "continuum.blocks[0].quadrilateral.arcs[0].centre", "let both be the radius"},
        Case{"straight_arc",
             shaped("quadrilateral { " + kCorners + "arcs { side: LOWER through { x: 0.5 y: 0 } } }"),
             "continuum.blocks[0].quadrilateral.arcs[0].through", "lies in line"},
        Case{"arc_of_nothing", shaped("quadrilateral { " + kCorners + "arcs { side: LOWER } }"),
             "continuum.blocks[0].quadrilateral.arcs[0]", "`through`"},
        Case{"ring_of_ten",
             shaped("ring { centre { x: 0 y: 0 } inner_radius: 1 outer_radius: 2 }", "zones: 10"),
             "continuum.blocks[0].along.zones", "multiple of 4"},
        Case{"ring_inside_out", shaped("ring { centre { x: 0 y: 0 } inner_side: 3 outer_radius: 2 }"),
             "continuum.blocks[0].ring", "not within its outside"},
        Case{"ring_without_outside", shaped("ring { centre { x: 0 y: 0 } inner_side: 3 }"),
             "continuum.blocks[0].ring", "give outer_radius or outer_side"}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::fdm::test::blocks_test
