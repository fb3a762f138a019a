// Requirement: a stated stress that gravity does not hold is told before statics change it.
#include "fdm_server/model/initial_stress.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "fdm_server/model/grid/read_grid.hpp"
#include "fdm_server/model/ground.hpp"

namespace adit::fdm::initial_stress_test {
namespace {

using testing::HasSubstr;
using testing::Optional;

// 20 m of ground of 2,000 kg/m^3.
std::optional<std::string> warning(const std::string& stress, const std::string& loads) {
  scene::Scene scene;
  const std::string text = fmt::format(
      "material {{ young_modulus: 1e8 poisson_ratio: 0.3 density: 2000 }} statics {{ }} initial_stress {{ {} "
      "}} "
      "continuum {{ block {{ x_min: 0 x_max: 10 y_min: -20 y_max: 0 zones_x: 5 zones_y: 10 }} {} }}",
      stress, loads);
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  const Grid grid = read_grid(scene.continuum());
  Ground ground = read_ground(scene);
  ground.of_zone = materials_of_zones(scene.continuum(), grid);
  return warn_of_imbalance(scene, grid, ground);
}

const std::string kGravity = "body_loads { acceleration { y: -9.81 } }";

std::string layers(double density) {
  return fmt::format("layers {{ bottom: -20 density: {} k0: 0.5 }}", density);
}

TEST(WarnOfImbalance, IsSilentWhereGravityHoldsTheStress) {
  EXPECT_EQ(warning(layers(2000), kGravity), std::nullopt);
  EXPECT_EQ(warning(layers(2060), kGravity), std::nullopt);  // 3 %
  EXPECT_EQ(warning("yy: -5e6 xx: -3e6", ""), std::nullopt);
  // 10 m of weight, half of it in the mean, beside 5 MPa: 4 %
  EXPECT_EQ(warning("yy: -5e6 xx: -3e6", kGravity), std::nullopt);
}

// The mean of the stated stress is 98.07 kPa; as much lacks, or twice as much under gravity upwards.
TEST(WarnOfImbalance, TellsHowFarTheStressWillChange) {
  EXPECT_THAT(warning(layers(1000), kGravity),
              Optional(HasSubstr("by about 98.1 kPa in the mean, where 98.1")));
  EXPECT_THAT(warning(layers(2000), ""), Optional(HasSubstr("by about 196 kPa in the mean, where 196")));
  EXPECT_THAT(warning(layers(2000), "body_loads { acceleration { y: 9.81 } }"),
              Optional(HasSubstr("392 kPa")));
  EXPECT_THAT(warning("yy: -1e6 xx: -1e6", kGravity),
              Optional(HasSubstr("196 kPa in the mean, where 1e+03")));
}

// What acts on a part or for a time is not judged.
TEST(WarnOfImbalance, DoesNotJudgeOtherLoads) {
  EXPECT_EQ(warning(layers(1000), "body_loads { where { y_min: -5 } acceleration { y: -9.81 } }"),
            std::nullopt);
}

}  // namespace
}  // namespace adit::fdm::initial_stress_test
