// Requirement: a snapshot has cells as the polygons that they are, where they lie.
#include "dem_server/observe/cell_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::cell_pieces_test {
namespace {

constexpr double kWidth = 1, kHeight = 0.6;

scene::Scene block() {
  auto scene = test::empty_scene();
  auto& cells = *scene.mutable_particles()->mutable_cells();
  test::set_box(cells, kWidth, kHeight);
  cells.set_size(0.1);
  return scene;
}

wire::Piece piece_of(const LocalEngine& engine, const std::string& name) {
  wire::Snapshot snapshot;
  engine.snapshot(snapshot);
  for (const wire::Piece& piece : snapshot.pieces())
    if (piece.name() == name) return piece;
  return {};
}

// Twice the area within the corners from `begin` on.
double doubled_area(const wire::Piece& piece, int begin, int corners) {
  double sum = 0;
  for (int k = 0; k < corners; ++k) {
    const int a = 2 * (begin + k), b = 2 * (begin + (k + 1) % corners);
    sum += piece.points(a) * piece.points(b + 1) - piece.points(b) * piece.points(a + 1);
  }
  return sum;
}

// Every polygon is as large as its cell, in the order of the particles, and together they fill the box.
TEST(CellPieces, PolygonsAreTheCells) {
  const GeneralEngine engine(read_model(block()), 1);
  const wire::Piece cells = piece_of(engine, "cells");
  const std::vector<double> areas = engine.cell_areas();
  ASSERT_EQ(cells.corners_size(), static_cast<int>(areas.size()));
  double whole = 0;
  int begin = 0;
  for (int i = 0; i < cells.corners_size(); begin += static_cast<int>(cells.corners(i++))) {
    const double area = doubled_area(cells, begin, static_cast<int>(cells.corners(i))) / 2;
    EXPECT_NEAR(area / areas[static_cast<std::size_t>(i)], 1, 1e-9);
    whole += area;
  }
  EXPECT_NEAR(whole, kWidth * kHeight, 1e-9);
}

// A body that turns by a small angle about the origin moves every corner by the angle times its distance,
// also where displacements count from a state that has turned already.
TEST(CellPieces, CornersMoveAndTurnWithTheirCells) {
  constexpr double kAngle = 1e-7;
  GeneralEngine engine(read_model(block()), 1);
  Particles& p = engine.particles();
  for (const std::uint64_t step : {1, 2}) {
    engine.count_displacements();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = -p.y[i];
      p.vy[i] = p.x[i];
      p.spin[i] = 1;
    }
    engine.step_interface({step, kAngle});
    const wire::Piece cells = piece_of(engine, "cells");
    const auto& moved = cells.point_fields(0).values();
    ASSERT_EQ(cells.point_fields(0).name(), "displacement_m");
    for (int k = 0; 2 * k < cells.points_size(); ++k) {
      EXPECT_NEAR(moved[3 * k], -kAngle * cells.points(2 * k + 1), 1e-5 * kAngle);
      EXPECT_NEAR(moved[3 * k + 1], kAngle * cells.points(2 * k), 1e-5 * kAngle);
    }
  }
}

TEST(CellPieces, AreNoneOfDiscs) {
  const GeneralEngine engine(read_model(test::square_scene(3, 3)), 1);
  wire::Snapshot snapshot;
  engine.snapshot(snapshot);
  for (const wire::Piece& piece : snapshot.pieces()) {
    EXPECT_NE(piece.name(), "cells");
    EXPECT_NE(piece.name(), "cracks");
  }
}

using Case = adit::test::Refusal<std::function<void(scene::History&)>>;
class CrackWidthErrors : public testing::TestWithParam<Case> {};

TEST_P(CrackWidthErrors, NameTheFieldAndTheRemedy) {
  auto scene = block();
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("lining");
  group.mutable_where()->set_x_max(0.5);
  auto& history = *scene.mutable_particles()->add_histories();
  history.set_quantity(scene::CRACK_WIDTH);
  GetParam().input(history);
  const GeneralEngine engine(read_model(scene), 1);
  adit::test::expect_refusal([&] { Histories(scene.particles(), engine, {}); },
                             "particles.histories[0]." + GetParam().path, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, CrackWidthErrors,
    testing::Values(Case{"NoPlace", "at", "is missing; give the circle's middle", [](auto&) {}},
                    Case{"NoRadius", "radius",
                         "crack_width of particles is the largest in a circle or a group: give its radius, "
                         "or `group`",
                         [](auto& history) { test::set(*history.mutable_at(), 0.5, 0.3); }},
                    Case{"UnknownGroup", "group",
                         "is `wall`, but crack_width is that of the cracks in a group; choose one of "
                         "particles, lining",
                         [](auto& history) { history.set_group("wall"); }}),
    adit::test::kRefusalName);

TEST(CrackWidth, IsRefusedOfDiscs) {
  auto scene = test::square_scene(3, 3);
  scene.mutable_particles()->add_histories()->set_quantity(scene::CRACK_WIDTH);
  const GeneralEngine engine(read_model(scene), 1);
  adit::test::expect_refusal([&] { Histories(scene.particles(), engine, {}); },
                             "particles.histories[0].quantity",
                             "is crack_width, but only cracks between `particles.cells` have a width");
}

}  // namespace
}  // namespace adit::dem::cell_pieces_test
