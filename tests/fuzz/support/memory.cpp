#include "tests/fuzz/support/memory.hpp"

#ifdef ADIT_SANITIZES_ADDRESSES

#include <sanitizer/allocator_interface.h>

#include <atomic>
#include <cstddef>

namespace adit::fuzz {
namespace {

std::atomic<std::int64_t> held = 0, peak = 0;  // below 0 where older memory is given back

void give(const volatile void*, std::size_t size) {
  const std::int64_t now = held += static_cast<std::int64_t>(size);
  if (now > peak) peak = now;
}

void take_back(const volatile void* memory) {
  if (memory != nullptr) held -= static_cast<std::int64_t>(::__sanitizer_get_allocated_size(memory));
}

}  // namespace

void count_memory() {
  [[maybe_unused]] static const int installed = ::__sanitizer_install_malloc_and_free_hooks(give, take_back);
}

std::int64_t memory_held() {
  return held;
}

std::int64_t take_memory_peak() {
  return peak.exchange(held);
}

}  // namespace adit::fuzz

#else

namespace adit::fuzz {

void count_memory() {}

std::int64_t memory_held() {
  return 0;
}

std::int64_t take_memory_peak() {
  return 0;
}

}  // namespace adit::fuzz

#endif
