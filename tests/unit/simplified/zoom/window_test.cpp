// The motions of a run become those of a window's edges.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "protocol/errors.hpp"
#include "protocol/foundation/body_course.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/zoom/places.hpp"
#include "simplified/zoom/window.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::window_test {
namespace {

using testing::response_of;
using testing::tunnel;
using testing::with_model;

// Requirement: the windows stand around the largest responses, and their edges move as the tunnel does there.
TEST(Zoom, EdgesMoveAsTheTunnelDoes) {
  const Response response = response_of(tunnel());
  const std::vector<Place> places = largest_responses(response);
  std::vector<std::string> names;
  for (const Place& place : places) names.push_back(place.name);
  EXPECT_THAT(names, ::testing::ElementsAre("opening", "moment", "shear", "strain"));
  const Window around = window(response.fields, places[1].chainage, 40);
  EXPECT_NEAR(around.end.chainage - around.begin.chainage, 40, 1);  // the edges stand at elements of 1 m
  EXPECT_LE(around.begin.chainage, places[1].chainage);
  EXPECT_GE(around.end.chainage, places[1].chainage);

  for (const Edge* edge : {&around.begin, &around.end})
    for (const auto* motion : {&edge->axial, &edge->lateral, &edge->spin})
      EXPECT_EQ(motion->size(), around.time.size());

  const test::ScratchFolder folder;
  write_edges(folder.path(), "moment", around);
  scene::Scene scene = fragment(around, "moment", 2);
  ASSERT_EQ(scene.continuum().motions_size(), 2);
  const Edge* edges[] = {&around.begin, &around.end};
  for (int i = 0; i < 2; ++i) {
    scene::BodyMotion& body = *scene.mutable_continuum()->mutable_motions(i)->mutable_body();
    EXPECT_EQ(body.centre().x(), edges[i]->chainage);
    std::ifstream file(folder / body.path());
    body.set_content(std::string(std::istreambuf_iterator<char>(file), {}));
    const foundation::BodyCourse course(body, "body");
    for (std::size_t n = 0; n < around.time.size(); n += 7) {
      const foundation::BodyVelocity velocity = course.at(around.time[n]);
      EXPECT_DOUBLE_EQ(velocity.x, edges[i]->axial[n]);
      EXPECT_DOUBLE_EQ(velocity.y, edges[i]->lateral[n]);
      EXPECT_DOUBLE_EQ(velocity.spin, edges[i]->spin[n]);
    }
  }
}

// Requirement: the spin of a section is the change of its slope: that of the neighbours' displacements where
// the lining does not shear.
TEST(Zoom, SectionsTurnAsTheTunnelBends) {
  for (const auto model : {scene::Simplified::BEAM, scene::Simplified::CHAIN}) {
    const Fields fields = response_of(with_model(tunnel(), model)).fields;
    const std::size_t places = fields.chainage.size(), at = nearest(fields.chainage, 60);
    double largest = 0, difference = 0;
    for (std::size_t n = 0; n < fields.time.size(); ++n) {
      const double* v = fields.lateral_velocity.data() + n * places + at;
      const double slope = (v[1] - v[-1]) / (fields.chainage[at + 1] - fields.chainage[at - 1]);
      largest = std::max(largest, std::abs(slope));
      difference = std::max(difference, std::abs(fields.spin[n * places + at] - slope));
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(difference, 0.01 * largest) << model;
  }
}

// Requirement: the recorded velocity at an edge integrates to the tunnel's displacement in the histories.
TEST(Zoom, VelocitiesIntegrateToTheDisplacement) {
  for (const auto model : {scene::Simplified::BEAM, scene::Simplified::CHAIN}) {
    const Response response = response_of(with_model(tunnel(), model));
    const Window around = window(response.fields, 120, 40);  // begins at the station
    double displacement = 0, largest = 0, difference = 0;
    std::size_t row = 0;
    for (std::size_t n = 1; n < around.time.size(); ++n) {
      displacement +=
          (around.time[n] - around.time[n - 1]) * (around.begin.lateral[n] + around.begin.lateral[n - 1]) / 2;
      while (response.histories.rows[row][0] < around.time[n] - 1e-9) ++row;
      if (std::abs(response.histories.rows[row][0] - around.time[n]) > 1e-9) continue;
      largest = std::max(largest, std::abs(response.histories.rows[row][2]));
      difference = std::max(difference, std::abs(displacement - response.histories.rows[row][2]));
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(difference, 0.03 * largest);  // half an element beside the station, the trapezoids of 20 ms
  }
}

TEST(Zoom, RefusesAWindowWiderThanTheTunnel) {
  const Response response = response_of(tunnel());
  EXPECT_THROW(window(response.fields, 100, 201), protocol::UserError);
}

}  // namespace
}  // namespace adit::simplified::window_test
