// Requirement: no input of the corpora, which hold real files and frames and all that once failed, makes a
// program crash, hang or take more memory than its length accounts for; what is wrong is refused. The states
// among them are of this release: those of another are refused at once, and nothing behind that is tried.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "dem_server/participant/participant.hpp"
#include "fdm_server/participant/participant.hpp"
#include "tests/fuzz/session/restore.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz::replay_test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Replay : public testing::TestWithParam<const Target*> {};

TEST_P(Replay, TakesItsCorpus) {
  int inputs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ADIT_FUZZ_CORPUS) / GetParam()->name())) {
    EXPECT_NO_THROW(GetParam()->run(content_of(entry.path()))) << entry.path();
    ++inputs;
  }
  EXPECT_GT(inputs, 0);
}

// Those that fuzz_seeds writes (seeds.cpp).
template <class Participant>
void expect_states_are_taken(const char* folder, const std::vector<std::string>& scenes) {
  for (const std::string& scene : scenes)
    for (const char* step : {"_0", "_3"}) {
      Participant participant;
      const fs::path path = fs::path(ADIT_FUZZ_CORPUS) / folder / (scene + step);
      EXPECT_TRUE(go_on_from(content_of(path), participant, scenes)) << path;
    }
}

TEST(States, OfTheCorporaAreOfThisRelease) {
  expect_states_are_taken<fdm::FdmParticipant>("fdm_state", kScenesOfGround);
  expect_states_are_taken<dem::DemParticipant>("dem_state", kScenesOfParticles);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(info.param->name()); });

}  // namespace
}  // namespace adit::fuzz::replay_test
