// The target that is linked, as libFuzzer calls it. An exception that leaves it ends the fuzzer.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/support/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  adit::fuzz::targets().front()->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
