// The line that shows how far a run is: step, simulated time, steps per second, time left.
#pragma once

#include <chrono>
#include <cstdint>

namespace adit::coupler {

class Progress {
 public:
  // Rewrites one line on a terminal, adds a line every few seconds elsewhere.
  Progress(std::uint64_t steps, double dt);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::uint64_t step);

 private:
  using Clock = std::chrono::steady_clock;
  void print(std::uint64_t step) const;

  std::uint64_t steps_;
  double dt_;
  bool terminal_;
  bool printed_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace adit::coupler
