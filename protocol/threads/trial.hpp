// Whether a team shares its work, found by the clock: the first steps are shared and made alone in turns, and
// the kind whose median is the shorter one stays. So threads that cost more than they give, because a step is
// short or because other processes of the run need the cores, are left to sleep. The shortest steps would not
// tell: those are the ones in which the others happened to be silent. Nor is work shared that takes less than
// half of the time between two steps: the run then waits for another model, which the threads would only
// disturb. Results do not depend on the choice.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace adit::protocol {

class Trial {
 public:
  bool shares() const { return shares_; }

  // The duration of the step made last, and the time since the step before was [s].
  void take(double seconds, double period) {
    if (steps_ == 2 * kEach) return;
    busy_ += seconds;
    passed_ += period;
    (shares_ ? shared_ : alone_)[steps_ / (2 * kTurn) * kTurn + steps_ % kTurn] = seconds;
    if (++steps_ % kTurn != 0) return;
    shares_ = steps_ == 2 * kEach ? busy_ >= kBusy * passed_ && median(shared_) < kWorth * median(alone_)
                                  : !shares_;
  }

 private:
  static constexpr std::size_t kTurn = 8, kEach = 24;  // steps in turn, and of each kind
  static constexpr double kWorth = 0.95;               // a core is worth more than 5 % of the time
  static constexpr double kBusy = 0.5;
  using Durations = std::array<double, kEach>;

  static double median(Durations& durations) {
    const auto middle = durations.begin() + kEach / 2;
    std::nth_element(durations.begin(), middle, durations.end());
    return *middle;
  }

  bool shares_ = true;
  std::size_t steps_ = 0;
  Durations shared_{}, alone_{};  // [s]
  double busy_ = 0, passed_ = 0;  // sums [s]
};

}  // namespace adit::protocol
