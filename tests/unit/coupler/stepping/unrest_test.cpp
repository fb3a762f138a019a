// Requirements: statics that do not come nearer to rest are noticed within a few ten thousand steps; those
// that would come to rest within the steps that are allowed, however slowly and however their ratio swings,
// never are. What moves on without slowing down is noticed within 20,000 steps, whatever its ratio; what
// slows down, or swings for the first time, is not.
#include "coupler/stepping/unrest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

namespace adit::coupler::unrest_test {
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
    if (stall.noticed(now) != Stall::kGoesOn) return {n, true};
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

TEST(Stall, IsSeenWhereNothingBearsAnything) {
  EXPECT_LE(relax([](double) { return std::numeric_limits<double>::infinity(); }).step, 20'000u);
}

// The step in which something is seen to flow, in a model of 100 m.
std::uint64_t flow(const std::function<double(double)>& distance,
                   const std::function<double(double)>& ratio) {
  Stall stall(kWanted, kMaxSteps);
  Moved moved;
  moved.extent = 100;
  for (std::uint64_t n = 1; n < 100'000; ++n) {
    const auto now = static_cast<double>(n);
    moved.distance = distance(now);
    if (stall.noticed(ratio(now), moved) == Stall::kFlows) return n;
  }
  return 0;
}

TEST(Flow, IsSeenInWhatMovesOn) {
  const auto fixed = [](double) { return 2e-3; };
  const auto falling = [](double n) { return std::exp(-1e-4 * n); };
  const auto accelerated = [](double n) { return 1e-6 * n * n; };
  const auto steady = [](double n) { return 1e-3 * n; };
  for (const std::uint64_t step :
       {flow(accelerated, fixed), flow(steady, fixed), flow(accelerated, falling)}) {
    EXPECT_GT(step, 0u);
    EXPECT_LE(step, 20'000u);
  }
}

TEST(Flow, IsNotSeenInWhatComesToRest) {
  const auto settles = [](double n) { return 30 * (1 - std::exp(-n / 8000)); };
  EXPECT_EQ(flow(settles, [](double n) { return std::exp(-n / 8000); }), 0u);
  // The first quarter of a swing of 120,000 steps, whose forces grow with the displacement.
  const auto swings = [](double n) { return 15 * (1 - std::cos(2 * std::numbers::pi * n / 120'000)); };
  EXPECT_EQ(flow([&](double n) { return swings(std::min(n, 60'000.)); },
                 [&](double n) { return 1 / swings(std::min(n, 60'000.)); }),
            0u);
  EXPECT_EQ(flow([](double n) { return 4e-5 * n; }, [](double) { return 2e-3; }), 0u)
      << "not yet a twentieth";
}

}  // namespace
}  // namespace adit::coupler::unrest_test
