// Requirement: statics that do not come nearer to rest are noticed within a few ten thousand steps; those
// that would come to rest within the steps that are allowed, however slowly and however their ratio swings,
// never are.
#include "coupler/stepping/unrest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>

namespace adit::coupler {
namespace {

constexpr double kWanted = 1e-4;
constexpr std::uint64_t kMaxSteps = 400'000;

// The step in which the stall is noticed or the ratio reached; kMaxSteps if neither is.
struct End {
  std::uint64_t step = kMaxSteps;
  bool stalled = false;
};
End relax(const std::function<double(double)>& ratio) {
  Stall stall(kWanted, kMaxSteps);
  for (std::uint64_t n = 1; n < kMaxSteps; ++n) {
    const double now = ratio(static_cast<double>(n));
    if (now <= kWanted) return {n, false};
    if (stall.noticed(now)) return {n, true};
  }
  return {};
}

TEST(Stall, IsNotSeenInWhatConverges) {
  const auto swing = [](double n) { return 1.5 + std::sin(n / 700); };
  for (const double rate : {1e-3, 1e-4, 2.5e-5})
    EXPECT_FALSE(relax([&](double n) { return swing(n) * std::exp(-rate * n); }).stalled) << rate;
  EXPECT_FALSE(relax([&](double n) { return 30 / n; }).stalled);
}

TEST(Stall, IsSeenInWhatDoesNot) {
  for (const auto& ratio :
       {std::function<double(double)>([](double) { return 5e-3; }),
        std::function<double(double)>([](double n) { return 5e-3 * (1.5 + std::sin(n / 700)); }),
        std::function<double(double)>([](double n) { return 5e-3 + std::exp(-1e-3 * n); }),
        std::function<double(double)>([](double n) { return std::exp(-1e-6 * n); })}) {
    const End end = relax(ratio);
    EXPECT_TRUE(end.stalled);
    EXPECT_LT(end.step, 60'000u);
  }
}

}  // namespace
}  // namespace adit::coupler
