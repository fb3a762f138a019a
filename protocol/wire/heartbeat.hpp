// A thread that calls a function at regular intervals as long as the object lives.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace adit::protocol {

class Heartbeat {
 public:
  // `beat` must neither block nor throw.
  Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat);
  ~Heartbeat();

 private:
  void run(std::chrono::milliseconds interval, const std::function<void()>& beat);

  std::mutex mutex_;
  std::condition_variable stop_asked_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace adit::protocol
