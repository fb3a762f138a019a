// Requirements on water that stands on the ground: it presses on what looks upwards or sidewards into it, by
// the level of the place there; not on the sides of the model, in openings below ground, or where another
// model has the weight. And on ground that a place leaves above its water: the water there is gone.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "fdm_server/grid/cut.hpp"
#include "fdm_server/model/ground.hpp"
#include "fdm_server/model/water/water.hpp"
#include "protocol/ground/stated_stress.hpp"
#include "tests/support/refusals.hpp"

namespace adit::fdm::sea_test {
namespace {

constexpr double kWeight = 1000 * protocol::kStandardGravity;

scene::Water water_of(const std::string& text) {
  scene::Water water;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &water));
  return water;
}

struct Ends {
  double left, right, bottom, top;
};
// 10 m by 8 m of zones of 1 m, without those whose middles lie in these places.
struct Bed {
  Grid grid = make_grid({0, 10, -8, 0, 10, 8});
  std::vector<double> weights = std::vector<double>(80, 1.0);
  SideShares shares{};

  void take(const Ends& place) {
    for (std::size_t z = 0; z < weights.size(); ++z) {
      const auto [x, y] = centroid(corners(grid, z));
      if (place.left < x && x < place.right && place.bottom < y && y < place.top) weights[z] = 0;
    }
  }
  Load load(const std::string& water) const {
    const scene::Water stated = water_of(water);
    return weight_of_sea(WaterAtRest(stated, grid, {}, 1), grid, weights, shares, {});
  }
  // Of the load on points within these ends.
  static std::array<double, 2> sum(const Grid& grid, const Load& load, const Ends& place) {
    std::array<double, 2> force{};
    for (std::size_t k = 0; k < load.points.size(); ++k) {
      const double x = grid.x[load.points[k]], y = grid.y[load.points[k]];
      if (x < place.left || x > place.right || y < place.bottom || y > place.top) continue;
      force[0] += load.fx[k];
      force[1] += load.fy[k];
    }
    return force;
  }
};
constexpr Ends kAll{0, 10, -8, 0};

TEST(Sea, StandsOnFloorAndWallsOfATrench) {
  Bed bed;
  bed.take({3, 7, -4, 0});
  const Load load = bed.load("level: 5");
  const auto [x, y] = Bed::sum(bed.grid, load, kAll);
  EXPECT_NEAR(x, 0, 1e-6) << "one wall as the other; none on the sides of the model";
  EXPECT_NEAR(y, -kWeight * (6 * 5 + 4 * 9), 1e-6);
  EXPECT_NEAR(Bed::sum(bed.grid, load, {0, 4, -8, 0})[0], -kWeight * 4 * 7, 1e-6) << "4 m of 5 m to 9 m";
}

TEST(Sea, LeavesDryWhatLiesBelowGround) {
  Bed bed;
  const auto before = Bed::sum(bed.grid, bed.load("level: 5"), kAll);
  bed.take({3, 7, -6, -2});
  EXPECT_EQ(Bed::sum(bed.grid, bed.load("level: 5"), kAll), before);
  cut(bed.grid, std::vector<Side>{{5, 16}, {16, 27}}, std::vector<bool>(bed.grid.x.size(), false));
  cut(bed.grid, std::vector<Side>{{93, 82}}, std::vector<bool>(bed.grid.x.size(), false));
  EXPECT_EQ(Bed::sum(bed.grid, bed.load("level: 5"), kAll), before) << "faces of interfaces touch";
}

// The pit is a place by its sides, by the ground below it, or by a group that was excavated: its floor and
// its walls are dry, and the ground behind them does not count.
TEST(Sea, HasTheLevelOfThePlaceThere) {
  Bed bed;
  bed.take({3, 7, -4, 0});
  bed.grid.groups.push_back({"pit", {}, {}});
  for (std::uint32_t z = 0; z < bed.weights.size(); ++z)
    if (bed.weights[z] == 0) bed.grid.groups[0].zones.push_back(z);
  const std::string behind = " places { where { x_max: 3 } level: 0 }";
  for (const std::string where :
       {"x_min: 3 x_max: 7", "x_min: 3 x_max: 7 y_max: -4 y_min: -8", "group: 'pit'"}) {
    const std::string pit = " places { where { " + where + " } level: -5 }";
    for (const Load& load : {bed.load("level: 0" + pit), bed.load("level: 0" + behind + pit),
                             bed.load("level: 0" + pit + behind)})
      for (const double force : Bed::sum(bed.grid, load, {0, 4, -8, 0})) EXPECT_NEAR(force, 0, 1e-9) << where;
  }
  const Load load = bed.load("level: 0 places { where { x_min: 3 x_max: 7 } level: -2 }");
  EXPECT_NEAR(Bed::sum(bed.grid, load, kAll)[1], -kWeight * 4 * 2, 1e-6);
  EXPECT_NEAR(Bed::sum(bed.grid, load, {0, 4, -8, 0})[0], -kWeight * 2 * 1, 1e-6)
      << "the lower 2 m of the wall";
}

// A level within a side: its force and its moment about the lower end are those of the triangle below it.
TEST(Sea, PressesOnTheSubmergedPartOfASide) {
  Bed bed;
  bed.take({3, 7, -4, 0});
  const Load load = bed.load("level: -1.6");
  const double force = -kWeight * 2.4 * 2.4 / 2;
  EXPECT_NEAR(Bed::sum(bed.grid, load, {3, 3, -4, 0})[0], force, 1e-6);
  double moment = 0;
  for (std::size_t k = 0; k < load.points.size(); ++k)
    if (bed.grid.x[load.points[k]] == 3) moment += (bed.grid.y[load.points[k]] + 4) * load.fx[k];
  EXPECT_NEAR(moment, force * 0.8, 1e-6);
}

TEST(Sea, IsBorneByTheModelThatHasTheWeight) {
  Bed bed;
  bed.shares.assign(80, {1, 1, 1, 1});
  for (std::size_t z = 70; z < 80; ++z) bed.shares[z][2] = 0;
  EXPECT_TRUE(bed.load("level: 5").points.empty());
  bed.shares[74][2] = 0.5;
  adit::test::expect_refusal([&] { bed.load("level: 5"); }, "water", "at (4.5, 0) m, in an overlap");
}

// Water that a place takes away in the last stage neither takes up pressure nor keeps any in; it drains the
// ground below.
TEST(DrainedGround, LetsWaterIn) {
  scene::Scene scene;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "plane: PLANE_STRAIN material { young_modulus: 5e7 poisson_ratio: 0.3 density: 1800 pores { porosity: "
      "0.4 "
      "saturated_density: 2000 conductivity: 1e-4 } } statics {} water { level: 0 bulk_modulus: 2.2e9 "
      "places { where { x_max: 10 } level: -4 stage: 1 } } continuum { block { x_min: 0 x_max: 10 y_min: -8 "
      "y_max: 0 zones_x: 10 zones_y: 8 } }",
      &scene));
  const Bed bed;
  Ground ground = read_ground(scene);
  ground.of_zone.assign(80, 0);
  fill_pores(scene, bed.grid, ground);
  for (std::size_t z = 0; z < 80; ++z) {
    EXPECT_TRUE(ground.wet(z)) << "in stage 0";
    EXPECT_EQ(ground.material(z).density, 2000);
    EXPECT_EQ(ground.material(z).water_stiffness(), z < 40 ? 2.2e9 / 0.4 : 0);
  }
  std::optional<Flow> flow = resolve_flow(scene, bed.grid, ground, 1, bed.weights, {}, {}, {});
  ASSERT_TRUE(flow);
  std::vector<double> excess(80, 0), inflow(80, 0);
  for (std::size_t z = 30; z < 40; ++z) excess[z] = 1e3;
  protocol::Team team(1);
  flow->step(team, 0.1 * flow->critical_step(), excess, inflow);
  EXPECT_GT(flow->left(), 0) << "upwards out of the row below the level";
}

}  // namespace
}  // namespace adit::fdm::sea_test
