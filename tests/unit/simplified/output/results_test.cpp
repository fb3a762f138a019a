// Requirement: the tables hold every place of a response, from one portal to the other.
#include "simplified/output/results.hpp"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/support/scratch_folder.hpp"

namespace adit::simplified::results_test {
namespace {

TEST(Results, EnvelopesHoldEveryPlace) {
  const adit::test::ScratchFolder folder;
  Response response;
  response.chainage = {0, 10, 25};
  response.envelopes = {{"moment", "Nm", {-1, -2, -3}, {4, 5, 6}}, {"strain", "", {0, 0, 0}, {0.5, 0.25, 0}}};
  write_tables(folder.path(), {}, response);
  std::ifstream file(folder / "envelopes.csv");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text,
            "chainage_m,moment_min_Nm,moment_max_Nm,strain_min,strain_max\n"
            "0,-1,4,0,0.5\n10,-2,5,0,0.25\n25,-3,6,0,0\n");
}

}  // namespace
}  // namespace adit::simplified::results_test
