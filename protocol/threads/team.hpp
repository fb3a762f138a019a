// Threads that share the work of a step. They are started once and woken for each call.
//
// A step of some thousand zones takes tens of microseconds, and waking a sleeping thread takes about as long.
// The other threads therefore spin for a while after a call, and sleep only if no further call follows.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

namespace adit::protocol {

// Whether a team shares its work, found by the clock: the first steps are shared and made alone in turns, and
// the kind whose median is the shorter one stays. So threads that cost more than they give, because a step is
// short or because other processes of the run need the cores, are left to sleep. The shortest steps would not
// tell: those are the ones in which the others happened to be silent. Nor is work shared that takes less than
// half of the time between two steps: the run then waits for another model, which the threads would only
// disturb. Results do not depend on the choice.
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

class Team {
 public:
  // A team consists of the calling thread and `threads` - 1 others.
  explicit Team(std::size_t threads = 1);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  std::size_t threads() const { return others_.size() + 1; }

  // The duration of a whole step [s]: those of the first ones decide whether calls are shared (Trial).
  void took(double seconds) {
    const auto now = Clock::now();
    trial_.take(seconds, last_ ? std::chrono::duration<double>(now - *last_).count() : seconds);
    last_ = now;
  }

  // Calls work(task, thread) for the tasks 0 … count - 1. Each thread gets consecutive tasks, nearly as many
  // as the others and always the same ones. Returns when all are done. `work` must not throw.
  template <class Work>
  void run(std::size_t count, Work&& work) {
    const auto share = [&](std::size_t thread) {
      for (std::size_t i = count * thread / threads(); i < count * (thread + 1) / threads(); ++i)
        work(i, thread);
    };
    if (count > 1 && !others_.empty() && trial_.shares())
      call(share);
    else
      for (std::size_t i = 0; i < count; ++i) work(i, 0);
  }

 private:
  // A reference to the call's function, without allocation.
  struct Call {
    const void* function = nullptr;
    void (*invoke)(const void* function, std::size_t thread) = nullptr;
  };

  template <class Share>
  void call(const Share& share) {
    call_ = {&share, [](const void* function, std::size_t thread) {
               (*static_cast<const Share*>(function))(thread);
             }};
    begin();
    share(0);
    await_others();
  }
  void begin();
  void await_others();
  void serve(std::size_t thread);

  Call call_;
  using Clock = std::chrono::steady_clock;
  Trial trial_;
  std::optional<Clock::time_point> last_;  // when a step was told last
  // Each counter has a cache line of its own, so that threads that wait for one do not slow down the other.
  alignas(64) std::atomic<std::uint64_t> calls_{0};     // calls begun; the top bit tells threads to end
  alignas(64) std::atomic<std::uint64_t> finished_{0};  // calls that the other threads have finished
  std::vector<std::thread> others_;
};

}  // namespace adit::protocol
