// Requirements on bad input: one sentence that names the place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "protocol/errors.hpp"
#include "simplified/column/joined_columns.hpp"
#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::user_error_test {
namespace {

using ::testing::HasSubstr;

struct Refusal {
  std::string path, message;
};

Refusal refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const protocol::UserError& error) {
    return {error.path(), error.what()};
  }
  return {"accepted", "accepted"};
}

Refusal check_with(const std::function<void(Deposit&)>& change) {
  Deposit deposit = three_layers();
  change(deposit);
  return refusal([&] { check(deposit, "ground.profiles[3]"); });
}

// A deposit that is sound is accepted.
TEST(UserError, SoundDeposit) {
  EXPECT_EQ(check_with([](Deposit& d) { d.rock = kRock; }).path, "accepted");
}

// A layer of zero thickness is refused, with its number.
TEST(UserError, LayerOfZeroThickness) {
  const Refusal r = check_with([](Deposit& d) { d.layers[1].thickness = 0; });
  EXPECT_EQ(r.path, "ground.profiles[3].layers[1].thickness");
  EXPECT_EQ(r.message, "the layer's thickness is 0 m: give a value above 0");
}

// So are velocities and densities that are not positive and finite, in layers and rock, and no layer at all.
TEST(UserError, LayersAndRock) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_with([](Deposit& d) { d.layers[2].wave_velocity = -200; }).path,
            "ground.profiles[3].layers[2].wave_velocity");
  EXPECT_EQ(check_with([&](Deposit& d) { d.layers[0].density = nan; }).path,
            "ground.profiles[3].layers[0].density");
  EXPECT_EQ(check_with([](Deposit& d) { d.rock = Rock{0, 1000}; }).path, "ground.profiles[3].rock.density");
  EXPECT_EQ(check_with([](Deposit& d) {
              d.rock = Rock{2500, 0};
            }).path,
            "ground.profiles[3].rock.wave_velocity");
  EXPECT_EQ(check_with([](Deposit& d) { d.layers.clear(); }).path, "ground.profiles[3].layers");
}

// A damping ratio given in percent is refused.
TEST(UserError, DampingInPercent) {
  const Refusal r = check_with([](Deposit& d) { d.layers[0].damping = 5; });
  EXPECT_EQ(r.path, "ground.profiles[3].layers[0].damping");
  EXPECT_THAT(r.message, HasSubstr("from 0 to below 0.5"));
}

// Columns must stand one behind the other, with modes and sound layers; the message names the column.
TEST(UserError, Columns) {
  const auto join = [](std::vector<Column> columns, double dt = 0.01) {
    return refusal([&] { JoinedColumns(columns, true, dt, "soil.columns"); });
  };
  const Deposit sound = uniform_deposit();
  Deposit thin = sound;
  thin.layers[0].thickness = 0;
  const Refusal order = join({{0, sound, 3}, {30, sound, 3}, {30, sound, 3}});
  EXPECT_EQ(order.path, "soil.columns[2].chainage");
  EXPECT_THAT(order.message, HasSubstr("30 m after 30 m"));
  EXPECT_EQ(join({}).path, "soil.columns");
  EXPECT_EQ(join({{0, sound, 0}}).path, "soil.columns[0].modes");
  EXPECT_EQ(join({{0, sound, 3}, {30, thin, 3}}).path, "soil.columns[1].layers[0].thickness");
  EXPECT_THAT(join({{0, with_ratio(sound, -1), 3}}).message, HasSubstr("modulus ratio"));
  EXPECT_THAT(join({{0, sound, 3}}, 0).message, HasSubstr("time step"));
}

}  // namespace
}  // namespace adit::simplified::column::test::user_error_test
