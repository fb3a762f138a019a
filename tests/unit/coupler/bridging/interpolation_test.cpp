// An operator that comes over the wire, perhaps from a foreign code, is checked completely before it is used.
#include "coupler/answers/operator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::coupler::interpolation_test {
namespace {

// Two coupling points between three own points.
wire::Operator valid_operator() {
  wire::Operator op;
  for (const std::uint32_t start : {0, 2, 4}) op.add_row_starts(start);
  for (const std::uint32_t column : {0, 1, 1, 2}) op.add_columns(column);
  for (const double value : {0.25, 0.75, 0.5, 0.5}) op.add_values(value);
  for (int i = 0; i < 3; ++i) {
    op.add_inverse_masses(1.0 + i);
    op.add_inverse_masses(2.0);
  }
  return op;
}

TEST(Interpolation, AppliesNAndItsTranspose) {
  const Interpolation n = interpolation_of(valid_operator(), 2, "fdm_server");
  std::vector<double> own = {1, 10, 2, 20, 3, 30}, velocities(4);
  n.interpolate(own, velocities);
  EXPECT_THAT(velocities, testing::ElementsAre(1.75, 17.5, 2.5, 25));
  n.gather(std::vector<double>{4, 0, 2, 8}, own);
  EXPECT_THAT(own, testing::ElementsAre(1, 0, 4, 4, 1, 4));
  n.divide_by_mass(own);
  EXPECT_THAT(own, testing::ElementsAre(1, 0, 8, 8, 3, 8));
}

// Requirement: statics that scale masses find those that the participant told for them, and time its own;
// what statics hold yields in neither kind of them.
TEST(Interpolation, HasOtherMassesInStatics) {
  wire::Operator op = valid_operator();
  for (const double inverse : op.inverse_masses()) op.add_scaled_inverse_masses(4 * inverse);
  Interpolation n = interpolation_of(op, 2, "");
  n.take_masses_of(MassesOf::kScaledStatics);
  EXPECT_THAT(n.inverse_masses(), testing::ElementsAreArray(op.scaled_inverse_masses()));
  n.take_masses_of(MassesOf::kTime);
  EXPECT_THAT(n.inverse_masses(), testing::ElementsAreArray(op.inverse_masses()));
  n.take_masses_of(MassesOf::kStatics);
  EXPECT_THAT(n.inverse_masses(), testing::ElementsAreArray(op.inverse_masses()));

  op.set_scaled_inverse_masses(1, 0);
  Interpolation held = interpolation_of(op, 2, "");
  held.take_masses_of(MassesOf::kStatics);
  EXPECT_EQ(held.inverse_masses()[1], 0);
  EXPECT_EQ(held.inverse_masses()[2], op.inverse_masses(2));
  held.take_masses_of(MassesOf::kTime);
  EXPECT_EQ(held.inverse_masses()[1], op.inverse_masses(1));
}

// Requirement: each malformed operator is refused, and the peer that sent it is named.
TEST(Interpolation, RefusesAnythingMalformed) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, std::function<void(wire::Operator&)>>> spoilers = {
      {"row starts", [](auto& op) { op.add_row_starts(4); }},
      {"rows do not fit", [](auto& op) { op.set_row_starts(1, 5); }},
      {"rows do not fit", [](auto& op) { op.add_values(1); }},
      {"pair of inverse masses", [](auto& op) { op.add_inverse_masses(1); }},
      {"negative or not finite", [](auto& op) { op.set_inverse_masses(0, -1); }},
      {"negative or not finite", [=](auto& op) { op.set_inverse_masses(0, infinity); }},
      {"beyond that of any mass", [](auto& op) { op.set_inverse_masses(0, 1e-320); }},
      {"negative or not finite", [](auto& op) { op.add_scaled_inverse_masses(-1); }},
      {"as many masses for statics", [](auto& op) { op.add_scaled_inverse_masses(1); }},
      {"a point that it does not have", [](auto& op) { op.set_columns(3, 3); }},
      {"does not sum to 1", [](auto& op) { op.set_values(0, 0.5); }},
      {"does not sum to 1", [=](auto& op) { op.set_values(0, -infinity); }},
  };
  for (const auto& [expected, spoil] : spoilers) {
    wire::Operator op = valid_operator();
    spoil(op);
    try {
      interpolation_of(op, 2, "fdm_server at 10.0.0.1:1");
      ADD_FAILURE() << "accepted where it should say: " << expected;
    } catch (const protocol::PeerLost& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(expected));
      EXPECT_THAT(error.what(), testing::HasSubstr("fdm_server at 10.0.0.1:1"));
    }
  }
}

}  // namespace
}  // namespace adit::coupler::interpolation_test
