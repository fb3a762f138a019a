// The line that shows how far a run is.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace adit::coupler {

// Rewrites one line on a terminal, adds a line every few seconds elsewhere.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool due() const { return Clock::now() >= next_; }  // it is time for another print()
  void print(const std::string& text);
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }  // [s]

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool printed_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

// Step, simulated time, steps per second, time left.
class Progress {
 public:
  // `first`: the step that is made first.
  Progress(std::uint64_t steps, double dt, std::uint64_t first = 0) : steps_(steps), dt_(dt), first_(first) {}
  void update(std::uint64_t step);

 private:
  ProgressLine line_;
  std::uint64_t steps_;
  double dt_;
  std::uint64_t first_;
};

}  // namespace adit::coupler
