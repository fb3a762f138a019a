// Measures speed on a machine that also has other work. For one thread this is its CPU time, without waiting.
// For several threads it is the smallest time of many short windows, of which some pass undisturbed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ctime>
#include <vector>

#include "protocol/threads/team.hpp"

namespace adit::bench {

inline double now(std::size_t threads) {
  timespec time;
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds(std::size_t threads, auto&& work) {
  const double start = now(threads);
  work();
  return now(threads) - start;
}

// The least time of each of the works, which run(count) does `count` times and tells the mean seconds of,
// measured in turn for some seconds. Each is done once more before it is timed: in a run the cache holds what
// the last step left there, not what another work did.
template <class... Works>
std::array<double, sizeof...(Works)> least(Works&&... works) {
  constexpr double kWindow = 5e-4, kBudget = 3;  // s
  std::array<double, sizeof...(Works)> result{works(3)...};
  double spent = 0;
  while (spent < kBudget) {
    std::size_t next = 0;
    const auto measure = [&](auto&& work) {
      double& best = result[next++];
      const int count = std::max(1, static_cast<int>(kWindow / best));
      work(1);
      const double mean = work(count);
      best = std::min(best, mean);
      spent += mean * count;
    };
    (measure(works), ...);
  }
  return result;
}

// STREAM's triad a = b + s c over arrays of so many bytes in all.
class Triad {
 public:
  Triad(double bytes, std::size_t threads)
      : team_(threads),
        a_(static_cast<std::size_t>(bytes / 24), 0.0),
        b_(a_.size(), 1.0),
        c_(a_.size(), 2.0) {}
  double seconds_a_pass(int passes) {
    const std::size_t parts = team_.threads();
    const double total = seconds(parts, [&] {
      for (int pass = 0; pass < passes; ++pass)
        team_.run(parts, [&](std::size_t part, std::size_t) {
          double *a = a_.data(), *b = b_.data(), *c = c_.data();
          const std::size_t end = a_.size() * (part + 1) / parts;
#pragma GCC ivdep
          for (std::size_t i = a_.size() * part / parts; i < end; ++i) a[i] = b[i] + 3.0 * c[i];
        });
    });
    return total / passes;
  }
  double bytes() const {
    return 24.0 * static_cast<double>(a_.size());
  }

 private:
  protocol::Team team_;
  std::vector<double> a_, b_, c_;
};

}  // namespace adit::bench
