#include "protocol/log/waiting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>

#include "protocol/log/log.hpp"

namespace adit::protocol {
namespace {

using std::chrono::seconds;

constexpr seconds kFirst{2};
constexpr seconds kLongest{60};

void tell_until(const std::stop_token& end, const std::string& what,
                const std::function<std::string()>& how_far) {
  std::mutex mutex;
  std::condition_variable_any asked_to_end;
  std::unique_lock lock(mutex);
  seconds waited{0};
  while (true) {
    const seconds next = std::clamp(waited, kFirst, kLongest);
    asked_to_end.wait_for(lock, end, next, [] { return false; });
    if (end.stop_requested()) return;
    waited += next;
    const std::string far = how_far();
    tell(Severity::kInfo, "",
         fmt::format("{} ({} s so far){}{}", what, waited.count(), far.empty() ? "" : ": ", far));
  }
}

}  // namespace

Waiting::Waiting(std::string what, std::function<std::string()> how_far)
    : thread_([what = std::move(what), how_far = std::move(how_far)](const std::stop_token& end) {
        tell_until(end, what, how_far);
      }) {}

}  // namespace adit::protocol
