// Linked into every program: ends it at once, with a sentence, on a processor that lacks the instructions for
// which the programs are compiled. Without it they would die of an illegal instruction.
#ifdef ADIT_NEEDS_AVX2
#include <unistd.h>

#include <cstring>

namespace {

constexpr int kUserError = 2;  // protocol/errors.hpp, whose code this processor could not run

// Priority 101 is the first that programs may use: it runs before the constructors of any global object.
[[gnu::constructor(101)]] void require_avx2() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) return;
  const char* message =
      "error: this processor has no AVX2 instructions, for which Adit was compiled (x86-64-v3); build Adit "
      "from source for it, with cmake --preset release -DADIT_ARCH=\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message, std::strlen(message));
  ::_exit(kUserError);
}

}  // namespace
#endif
