// Requirement: no input of the corpora, which hold real files and frames and all that once failed, makes a
// program crash, hang or take more memory than its length accounts for; what is wrong is refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

namespace fs = std::filesystem;

class Replay : public testing::TestWithParam<const Target*> {};

TEST_P(Replay, TakesItsCorpus) {
  int inputs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ADIT_FUZZ_CORPUS) / GetParam()->name())) {
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string input(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NO_THROW(GetParam()->run(input)) << entry.path();
    ++inputs;
  }
  EXPECT_GT(inputs, 0);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(info.param->name()); });

}  // namespace
}  // namespace adit::fuzz
