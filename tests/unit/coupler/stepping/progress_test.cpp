// Requirement: the line that shows how far a run is tells the steps that were made in a second, and how long
// what is left takes at this rate.
#include "coupler/stepping/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>

namespace adit::coupler::progress_test {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Progress, TellsTheRateAndTheTimeThatIsLeft) {
  constexpr std::uint64_t kFirst = 2'000'000'000, kNow = 3'000'000'000, kSteps = 1'000'000'000'000;
  testing::internal::CaptureStderr();
  const auto start = std::chrono::steady_clock::now();
  Progress progress(kSteps, 1e-9, kFirst);
  const auto begun = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  const double least = seconds_since(begun);
  progress.update(kNow);
  const double most = seconds_since(start);
  const std::string line = testing::internal::GetCapturedStderr();
  double rate = 0, left = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "step 3000000000 of 1000000000000  t = 3 s  %lf steps/s  %lf s left",
                        &rate, &left),
            2)
      << line;
  EXPECT_LE(rate, (kNow - kFirst) / least + 1);
  EXPECT_GE(rate, (kNow - kFirst) / most - 1);
  EXPECT_NEAR(left, (kSteps - kNow) / rate, 1);
}

}  // namespace
}  // namespace adit::coupler::progress_test
