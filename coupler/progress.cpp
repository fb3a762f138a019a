#include "coupler/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdio>

namespace adit::coupler {
namespace {

constexpr std::chrono::milliseconds kTerminalInterval{200};
constexpr std::chrono::seconds kLogInterval{5};

}  // namespace

Progress::Progress(std::uint64_t steps, double dt)
    : steps_(steps), dt_(dt), terminal_(isatty(STDERR_FILENO) == 1), next_(start_ + kTerminalInterval) {}

Progress::~Progress() {
  if (terminal_ && printed_) std::fputc('\n', stderr);
}

void Progress::update(std::uint64_t step) {
  const auto now = Clock::now();
  if (now < next_ && step != steps_) return;
  next_ = now + (terminal_ ? kTerminalInterval
                           : std::chrono::duration_cast<std::chrono::milliseconds>(kLogInterval));
  print(step);
  printed_ = true;
}

void Progress::print(std::uint64_t step) const {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = elapsed > 0 ? static_cast<double>(step) / elapsed : 0;
  const double left = rate > 0 ? static_cast<double>(steps_ - step) / rate : 0;
  fmt::print(stderr, "{}step {} of {}  t = {:.4g} s  {:.0f} steps/s  {:.0f} s left   {}",
             terminal_ ? "\r" : "", step, steps_, static_cast<double>(step) * dt_, rate, left,
             terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace adit::coupler
