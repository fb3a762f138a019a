#include "protocol/results/summary.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results::summary_test {
namespace {

// A reader finds the entries in the order in which the run states them, each with its own type.
TEST(Summary, KeepsOrderAndTypes) {
  const ScratchFolder folder;
  Summary summary;
  summary.set("steps", std::uint64_t{18446744073709551615U});
  summary.set("case", "cantilever");
  summary.set("dt_s", 0.1);
  summary.set("warnings", std::vector<std::string>{"one"});
  summary.write(folder / "summary.json");
  EXPECT_EQ(content_of(folder / "summary.json"),
            "{\n  \"steps\": 18446744073709551615,\n  \"case\": \"cantilever\",\n  \"dt_s\": 0.1,\n"
            "  \"warnings\": [\n    \"one\"\n  ]\n}\n");
}

// JSON knows no infinity: what does not exist, such as the time of no crack, is null.
TEST(Summary, WritesNullForNumbersThatAreNotFinite) {
  const ScratchFolder folder;
  Summary summary;
  summary.set("first_crack_time_s", std::numeric_limits<double>::quiet_NaN());
  summary.set("tensile_strength_N", std::numeric_limits<double>::infinity());
  summary.write(folder / "summary.json");
  EXPECT_EQ(content_of(folder / "summary.json"),
            "{\n  \"first_crack_time_s\": null,\n  \"tensile_strength_N\": null\n}\n");
}

TEST(Summary, RefusesANameTwice) {
  Summary summary;
  summary.set("steps", 1);
  EXPECT_THROW(summary.set("steps", 2), std::logic_error);
}

// Text of another program (its release, a warning) may hold any bytes; the file is JSON all the same.
TEST(Summary, IsJsonWhateverTheTextHolds) {
  const ScratchFolder folder;
  Summary summary;
  summary.set("warnings", "\xff\"\n");
  summary.write(folder / "summary.json");
  EXPECT_TRUE(nlohmann::json::accept(content_of(folder / "summary.json")));
}

// A run killed while writing leaves the previous file: the new one comes by renaming a finished file.
TEST(Summary, LeavesNoUnfinishedFile) {
  const ScratchFolder folder;
  Summary summary;
  summary.set("steps", 1);
  summary.write(folder / "summary.json");
  EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json.part"));
}

}  // namespace
}  // namespace adit::results::summary_test
