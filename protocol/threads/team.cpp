#include "protocol/threads/team.hpp"

#include <fmt/format.h>

#include <chrono>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

constexpr std::uint64_t kEnd = std::uint64_t{1} << 63;
constexpr int kLooks = 64;                       // looks at the counter before the core is yielded
constexpr std::chrono::microseconds kSpin{100};  // longer than the serial part between two calls of a step

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Returns when the value differs from `old`. It first looks without yielding, then yields the core between
// looks, because with too few cores the thread that is waited for may need it, and finally sleeps.
void await_change(const std::atomic<std::uint64_t>& value, std::uint64_t old) {
  const auto changed = [&] { return value.load(std::memory_order_acquire) != old; };
  for (int i = 0; i < kLooks; ++i) {
    if (changed()) return;
    pause();
  }
  for (const auto deadline = std::chrono::steady_clock::now() + kSpin;
       std::chrono::steady_clock::now() < deadline;) {
    if (changed()) return;
    std::this_thread::yield();
  }
  value.wait(old, std::memory_order_acquire);
}

void end(std::atomic<std::uint64_t>& calls, std::vector<std::thread>& threads) {
  calls.fetch_or(kEnd, std::memory_order_release);
  calls.notify_all();
  for (auto& thread : threads) thread.join();
}

}  // namespace

Team::Team(std::size_t threads) {
  try {
    for (std::size_t thread = 1; thread < threads; ++thread)
      others_.emplace_back([this, thread] { serve(thread); });
  } catch (const std::exception& error) {
    const std::size_t begun = others_.size() + 1;
    end(calls_, others_);
    throw UserError("", fmt::format("cannot start {} threads, only {} ({}); ask for fewer with --threads (of "
                                    "the coupler: --fdm-threads, --dem-threads), or raise the limit of this "
                                    "machine",
                                    threads, begun, error.what()));
  }
}

Team::~Team() {
  end(calls_, others_);
}

void Team::begin() {
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
}

void Team::await_others() {
  // The counters only grow, so no thread ever has to reset one while another looks at it.
  const std::uint64_t all = calls_.load(std::memory_order_relaxed) * others_.size();
  for (std::uint64_t finished; (finished = finished_.load(std::memory_order_acquire)) != all;)
    await_change(finished_, finished);
}

void Team::serve(std::size_t thread) {
  for (std::uint64_t seen = 0;;) {
    await_change(calls_, seen);
    if (calls_.load(std::memory_order_acquire) & kEnd) return;
    // One by one: the caller begins no call before all have finished the last, so none can be missed.
    ++seen;
    call_.invoke(call_.function, thread);
    finished_.fetch_add(1, std::memory_order_release);
    finished_.notify_one();
  }
}

}  // namespace adit::protocol
