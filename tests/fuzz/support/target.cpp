#include "tests/fuzz/support/target.hpp"

#include <fmt/format.h>

#include <cstring>
#include <ctime>
#include <stdexcept>

#include "tests/fuzz/support/memory.hpp"

namespace adit::fuzz {
namespace {

std::vector<const Target*>& registered() {
  static std::vector<const Target*> all;
  return all;
}

}  // namespace

Target::Target(const char* name, void (*take)(std::string_view), std::size_t memory)
    : name_(name), take_(take), memory_(memory) {
  registered().push_back(this);
}

void Target::run(std::string_view input) const {
  count_memory();
  const std::clock_t start = std::clock();
  take_memory_peak();
  const std::int64_t before = memory_held();
  take_(input);
  const std::int64_t taken = take_memory_peak() - before;
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (const auto allowed = static_cast<std::int64_t>(memory_ + kMemoryFactor * input.size()); taken > allowed)
    throw std::runtime_error(
        fmt::format("{} bytes took {} bytes of memory, where {} are allowed", input.size(), taken, allowed));
  if (seconds > kLongest)
    throw std::runtime_error(fmt::format("{} bytes took {:.1f} s of the processor, where {} s are allowed",
                                         input.size(), seconds, kLongest));
}

const std::vector<const Target*>& targets() {
  return registered();
}

void require_one_line(const char* message) {
  if (std::strchr(message, '\n') != nullptr)
    throw std::runtime_error(fmt::format("the message has several lines: {}", message));
}

}  // namespace adit::fuzz
