// Requirement: docs/reliability.md states every bound of a conversation as it is.
#include "protocol/wire/bounds.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace adit::protocol::bounds_test {
namespace {

std::string text(std::chrono::milliseconds time) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  if (seconds % 3600 == 0) return std::to_string(seconds / 3600) + " h";
  if (seconds % 60 == 0) return std::to_string(seconds / 60) + " min";
  return std::to_string(seconds) + " s";
}

std::string text(std::uint64_t bytes) {
  if (bytes % (1u << 30) == 0) return std::to_string(bytes >> 30) + " GiB";
  if (bytes % (1u << 20) == 0) return std::to_string(bytes >> 20) + " MiB";
  if (bytes % (1u << 10) == 0) return std::to_string(bytes >> 10) + " KiB";
  return std::to_string(bytes) + " bytes";
}

std::map<std::string, std::string> bounds() {
  const Patience patience;
  return {{"Patience::connect", text(patience.connect)},
          {"Patience::first_request", text(patience.first_request)},
          {"Patience::silence", text(patience.silence)},
          {"Patience::heartbeat", text(patience.heartbeat)},
          {"Patience::set_up", text(patience.set_up)},
          {"kPatienceOfServers.set_up", text(kPatienceOfServers.set_up)},
          {"Patience::answer", text(patience.answer)},
          {"kPatienceOfServers.answer", text(kPatienceOfServers.answer)},
          {"Patience::frame", text(patience.frame)},
          {"kLeastRate", text(kLeastRate)},
          {"Patience::farewell", text(patience.farewell)},
          {"kStartPatience", text(kStartPatience)},
          {"kLastOrders", text(kLastOrders)},
          {"kStopPatience", text(kStopPatience)},
          {"kMaxFrameBytes", text(kMaxFrameBytes)},
          {"kMaxHelloBytes", text(kMaxHelloBytes)},
          {"kMaxAttachedBytes", text(kMaxAttachedBytes)},
          {"kMaxSetupBytes", text(kMaxSetupBytes)},
          {"kMaxRunBytes", text(kMaxRunBytes)},
          {"kMaxPartBytes", text(kMaxPartBytes)},
          {"kMaxModelBytes", text(kMaxModelBytes)},
          {"kMaxProgressBytes", text(kMaxProgressBytes)},
          {"kInterfaceBytes", text(kInterfaceBytes)},
          {"kSnapshotBytes", text(kSnapshotBytes)},
          {"kStateBytes", text(kStateBytes)},
          {"condensed_bytes",
           "16 n (2 n + 3) bytes"},  // its value: tests/unit/coupler/servers/answer_bounds_test.cpp
          {"kMaxParsedBytes", text(kMaxParsedBytes)}};
}

TEST(Bounds, AreThoseOfTheDocumentation) {
  std::ifstream page(RELIABILITY_PAGE);
  ASSERT_TRUE(page.is_open());
  const auto expected = bounds();
  const std::regex row("\\| [^|]+ \\| ([^|]+) \\| `([^`|]+)` \\|.*");
  std::set<std::string> stated;
  std::smatch cells;
  std::string line;
  while (line != "## Bounds" && std::getline(page, line)) continue;
  while (std::getline(page, line)) {
    if (!std::regex_match(line, cells, row)) continue;
    const auto bound = expected.find(cells[2]);
    ASSERT_NE(bound, expected.end()) << "no such bound: " << cells[2];
    EXPECT_EQ(cells[1], bound->second) << cells[2];
    stated.insert(cells[2]);
  }
  EXPECT_EQ(stated.size(), expected.size()) << "a bound is not in the table";
}

// What depends on the order of two deadlines.
TEST(Bounds, AreInOrder) {
  EXPECT_GT(kPatienceOfServers.answer, Patience{}.answer) << "the coupler names the participant that is late";
  EXPECT_GT(kPatienceOfServers.set_up, Patience{}.set_up);
  EXPECT_GT(Patience{}.silence, 2 * Patience{}.heartbeat);
  EXPECT_GT(kStopPatience, kLastOrders);
  EXPECT_GT(kMaxSetupBytes, kMaxAttachedBytes);
}

}  // namespace
}  // namespace adit::protocol::bounds_test
