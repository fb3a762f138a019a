#include "coupler/stepping/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "protocol/log/log.hpp"
#include "protocol/standard_streams.hpp"

namespace adit::coupler {
namespace {

constexpr std::chrono::milliseconds kTerminalInterval{200};
constexpr std::chrono::milliseconds kLogInterval{5000};

}  // namespace

ProgressLine::ProgressLine()
    : terminal_(isatty(STDERR_FILENO) == 1 && !protocol::logs_json()), next_(start_ + kTerminalInterval) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && printed_) protocol::print_error("\n");
}

void ProgressLine::print(const std::string& text) {
  next_ = Clock::now() + (terminal_ ? kTerminalInterval : kLogInterval);
  if (terminal_)
    protocol::print_error(fmt::format("\r{}   ", text));
  else
    protocol::tell(protocol::Severity::kInfo, "", text);
  printed_ = true;
}

void Progress::update(std::uint64_t step) {
  if (!line_.due() && step != steps_) return;
  const double elapsed = line_.elapsed();
  const double rate = elapsed > 0 ? static_cast<double>(step - first_) / elapsed : 0;
  const double left = rate > 0 ? static_cast<double>(steps_ - step) / rate : 0;
  line_.print(fmt::format("step {} of {}  t = {:.4g} s  {:.0f} steps/s  {:.0f} s left", step, steps_,
                          static_cast<double>(step) * dt_, rate, left));
}

}  // namespace adit::coupler
