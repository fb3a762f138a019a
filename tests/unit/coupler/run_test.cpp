// Requirement: a run ends as unstable soon after its energy exceeds the work done on it by a fifth of what it
// ever held, however seldom the results are written; a smaller excess is reported and does not end it, nor
// does any excess of a motion that rounds to rest. The same holds for energy that goes, unless it is booked.
#include "coupler/run.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::run_test {
namespace {

constexpr std::uint64_t kFrom = 100;

// Half of the mass [kg] of the participant below is moved by this speed by the last bit of its place, 1 m, in
// a step of 0.5 s.
constexpr double kLastBit = 2 * std::numeric_limits<double>::epsilon();

// A participant with this energy [J], which grows at step kFrom until the excess is this share of it; a
// negative share of it goes, of which `booked` is dissipated.
class Source : public protocol::Participant {
 public:
  explicit Source(double share, double energy = 1, double booked = 0)
      : energy_(energy), changed_(share < 0 ? energy * (1 + share) : energy / (1 - share)), booked_(booked) {}
  void set_up(const wire::Setup& /*setup*/, wire::Model& model) override {
    model.set_critical_dt(1);
    model.set_x_max(1);
    model.set_y_max(1);
  }
  void weigh(const wire::Weights& /*weights*/, wire::Interface& interface) override {
    interface.set_grid_points(4);
    interface.set_zones(1);
    interface.set_mass(2);
  }
  void couple(const wire::Couple& /*couple*/, wire::Operator& /*op*/) override {}
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    predicted.set_step(advance.step());
    if (!advance.want_energies()) return;
    predicted.mutable_energies()->set_strain(advance.step() < kFrom ? energy_ : changed_);
    predicted.mutable_energies()->set_dissipated(advance.step() < kFrom ? 0 : booked_ * (energy_ - changed_));
  }
  void snapshot(const wire::SnapshotRequest& /*request*/, wire::Snapshot& snapshot) override {
    wire::Piece& piece = *snapshot.add_pieces();
    piece.set_name("grid");
    for (const double coordinate : {0.25, 0.75}) piece.add_points(coordinate);
    wire::Field& velocity = *piece.add_point_fields();
    velocity.set_name("velocity_m_per_s");
    velocity.set_components(3);
    for (const double component : {3.0, 4.0, 0.0}) velocity.add_values(component);
  }
  void finish(wire::Bye& /*bye*/) override {}

 private:
  double energy_, changed_, booked_;
};

// Rows at the start and the end alone.
void run(double share, const test::ScratchFolder& folder, double energy = 1, double booked = 0) {
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
      std::make_unique<test::LocalConnection>("fdm_server", std::make_unique<Source>(share, energy, booked));
  coupler::run(scene, std::move(participants), {}, folder.path());
}

TEST(Run, GoesOnBelowTheShareThatNoStableRunReaches) {
  const test::ScratchFolder folder;
  EXPECT_NO_THROW(run(0.19, folder));
}

TEST(Run, GoesOnWhereAllThatMovesIsRounding) {
  const test::ScratchFolder folder;
  EXPECT_NO_THROW(run(0.9, folder, 0.01 * kLastBit * kLastBit));
  EXPECT_THROW(run(0.9, folder, kLastBit * kLastBit), protocol::Unstable);
}

TEST(Run, GoesOnWhereWhatGoesIsBooked) {
  const test::ScratchFolder folder;
  EXPECT_NO_THROW(run(-0.19, folder));
  EXPECT_NO_THROW(run(-0.9, folder, 1, 1));
  EXPECT_NO_THROW(run(-0.9, folder, 1e-13));  // 2 kg move at 0.3 micrometres a second
  EXPECT_THROW(run(-0.9, folder, 1e-11), protocol::Unstable);
}

TEST(Run, EndsWhereEnergyGoesWithoutCause) {
  const test::ScratchFolder folder;
  try {
    run(-0.9, folder, 1, 0.5);
    FAIL() << "ran on";
  } catch (const protocol::Unstable& error) {
    for (const char* part :
         {"step 100 (t = 50 s): 45 % of the energy", "most of it in `continuum` (fdm_server)",
          "balanced until t = 25 s", "check the units"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " in " << error.what();
  }
  EXPECT_FALSE(std::filesystem::is_empty(std::filesystem::path(folder.path()) / "fields"));
}

// Requirement: the message names place, participant and the last time that was good, and the fields of the
// end are written.
TEST(Run, SaysWhereItEndsAndLeavesTheFields) {
  const test::ScratchFolder folder;
  try {
    run(0.21, folder);
    FAIL() << "ran on";
  } catch (const protocol::Unstable& error) {
    for (const char* part : {"(0.25, 0.75) m of `continuum` with 5 m/s", "balanced until t = 25 s",
                             "choose a smaller time.dt_factor"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " in " << error.what();
  }
  EXPECT_FALSE(std::filesystem::is_empty(std::filesystem::path(folder.path()) / "fields"));
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
}  // namespace adit::run_test
