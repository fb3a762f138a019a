#include "protocol/wire/heartbeat.hpp"

#include <utility>

namespace adit::protocol {

Heartbeat::Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat)
    : thread_([this, interval, beat = std::move(beat)] { run(interval, beat); }) {}

Heartbeat::~Heartbeat() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stop_asked_.notify_one();
  thread_.join();
}

void Heartbeat::run(std::chrono::milliseconds interval, const std::function<void()>& beat) {
  std::unique_lock lock(mutex_);
  // A wait on a condition instead of a sleep, so that the end of a connection need not wait for an interval.
  while (!stop_asked_.wait_for(lock, interval, [this] { return stop_; })) beat();
}

}  // namespace adit::protocol
