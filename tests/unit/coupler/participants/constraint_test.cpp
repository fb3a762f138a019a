// Requirement: velocities that are numbers and give impulses that are none end the run, with the velocities.
#include "coupler/participants/constraint.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/verification/bridging/bars.hpp"

namespace adit::coupler::constraint_test {
namespace {

TEST(Constraint, EndsWhereImpulsesAreBeyondNumbers) {
  const test::Bar bar{
      "", {{test::Stretch::kGrid, 0, 5, 0.5}, {test::Stretch::kLattice, 3, 8, 0.1}}, {{0, 1, 3, 5}}};
  Model model = test::local_model(test::scene_of(bar));
  const std::size_t count = model.coupling_points.size();
  const std::vector<double> slow(count, 1.0), fast(count, -1.5e308);
  std::vector<double> multipliers(count);
  EXPECT_NO_THROW(model.constraint->solve(slow, slow, multipliers));
  try {
    model.constraint->solve(slow, fast, multipliers);
    FAIL() << "solved";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("reach 1 and 1.5e+308 m/s"));
  }
}

}  // namespace
}  // namespace adit::coupler::constraint_test
