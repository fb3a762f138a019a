#pragma once

#include <chrono>

namespace adit::coupler {

// Seconds of a run so far.
struct StepCost {
  double wait = 0;   // from the first send to the last answer, the ledger's work included
  double solve = 0;  // for the multipliers
};

// Adds the seconds of its own life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace adit::coupler
