#include "protocol/log/log.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "protocol/standard_streams.hpp"

namespace adit::protocol::log_test {
namespace {

// Requirement: no terminal obeys what a file or a peer says; lines and the line of progress stay.
TEST(StandardStreams, TellNothingThatATerminalObeys) {
  testing::internal::CaptureStdout();
  print("a \x1b[2J\x07 b\n\rc \xe2\x80\xae d\te\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "a  [2J  b\n\rc   d\te\n");
}

// Requirement: whatever a message holds, a line is one line of valid JSON that holds it.
TEST(Log, AnyTextIsOneLineOfJson) {
  log_as_json("fdm_server");
  log_run("cantilever/coupled");
  std::string all;
  for (int byte = 0; byte < 128; ++byte) all += static_cast<char>(byte);
  for (const std::string& message :
       {std::string("plain"), std::string("\"}\n{\""), std::string("σ > 0"), all}) {
    const std::string line = json_line({}, "info", message);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const auto parsed = nlohmann::json::parse(line);
    EXPECT_EQ(parsed["message"], message);
    EXPECT_EQ(parsed["level"], "info");
    EXPECT_EQ(parsed["program"], "fdm_server");
    EXPECT_EQ(parsed["run"], "cantilever/coupled");
    EXPECT_EQ(parsed["time"], "1970-01-01T00:00:00.000Z");
  }
  EXPECT_EQ(nlohmann::json::parse(json_line({}, "info", "\xff\xc3"))["message"], "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(Log, TellsTheTimeInMilliseconds) {
  const std::chrono::system_clock::time_point time(std::chrono::milliseconds(1795408267123));
  EXPECT_EQ(nlohmann::json::parse(json_line(time, "info", ""))["time"], "2026-11-23T04:31:07.123Z");
}

}  // namespace
}  // namespace adit::protocol::log_test
