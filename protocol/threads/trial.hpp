// Whether a team shares its work, found by the clock: the first steps are shared and made alone in turns, and
// the kind that had the shortest step stays. So threads that cost more than they give, because a step is
// short or because other processes need the cores, are left to sleep. Results do not depend on it.
#pragma once

#include <algorithm>
#include <limits>

namespace adit::protocol {

class Trial {
 public:
  bool shares() const { return shares_; }

  // The duration of the step made last [s].
  void take(double seconds) {
    if (turns_ == kTurns) return;
    double& shortest = shares_ ? shared_ : alone_;
    shortest = std::min(shortest, seconds);
    if (++steps_ < kTurn) return;
    steps_ = 0;
    ++turns_;
    shares_ = turns_ == kTurns ? shared_ < kWorth * alone_ : !shares_;
  }

 private:
  static constexpr int kTurn = 8, kTurns = 6;  // steps, turns
  static constexpr double kWorth = 0.95;       // a core is worth more than 5 % of the time

  bool shares_ = true;
  int steps_ = 0, turns_ = 0;
  double shared_ = std::numeric_limits<double>::infinity(), alone_ = shared_;  // shortest steps [s]
};

}  // namespace adit::protocol
