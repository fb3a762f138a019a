// Requirement: a run ends as unstable soon after its energy exceeds the work done on it by a fifth of what it
// ever held, however seldom the results are written; a smaller excess is reported and does not end it.
#include "coupler/run.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit {
namespace {

constexpr std::uint64_t kFrom = 100;

// A participant whose energy is 1 J and grows at step kFrom until the excess is this share of it.
class Source : public protocol::Participant {
 public:
  explicit Source(double share) : grown_(1 / (1 - share)) {}
  void set_up(const wire::Setup& /*setup*/, wire::Model& model) override {
    model.set_critical_dt(1);
    model.set_x_max(1);
    model.set_y_max(1);
  }
  void weigh(const wire::Weights& /*weights*/, wire::Interface& interface) override {
    interface.set_grid_points(4);
    interface.set_zones(1);
  }
  void couple(const wire::Couple& /*couple*/, wire::Operator& /*op*/) override {}
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    predicted.set_step(advance.step());
    if (advance.want_energies())
      predicted.mutable_energies()->set_strain(advance.step() < kFrom ? 1 : grown_);
  }
  void snapshot(const wire::SnapshotRequest& /*request*/, wire::Snapshot& /*snapshot*/) override {}
  void finish(wire::Bye& /*bye*/) override {}

 private:
  double grown_;
};

// Rows at the start and the end alone.
void run(double share, const test::ScratchFolder& folder) {
  scene::Scene scene;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 500 dt: 0.5 }
    output { history_interval: 500 }
    continuum { block { x_min: 0 x_max: 1 y_min: 0 y_max: 1 zones_x: 1 zones_y: 1 } }
  )",
                                                            &scene));
  std::vector<coupler::Participant> participants(1);
  participants[0].member = coupler::members(scene).front();
  participants[0].connection =
      std::make_unique<test::LocalConnection>("fdm_server", std::make_unique<Source>(share));
  coupler::run(scene, std::move(participants), {}, folder.path());
}

TEST(Run, GoesOnBelowTheShareThatNoStableRunReaches) {
  const test::ScratchFolder folder;
  EXPECT_NO_THROW(run(0.19, folder));
}

TEST(Run, EndsWithinAHundredStepsAboveIt) {
  const test::ScratchFolder folder;
  try {
    run(0.21, folder);
    FAIL() << "ran on";
  } catch (const protocol::Unstable& error) {
    const std::string text = error.what();
    ASSERT_EQ(text.substr(0, 5), "step ");
    const auto step = std::strtoull(text.c_str() + 5, nullptr, 10);
    EXPECT_GE(step, kFrom);
    EXPECT_LE(step, kFrom + 100);
  }
}

}  // namespace
}  // namespace adit
