// What is fuzzed: a function that takes any bytes. It refuses wrong ones by itself, as the program does that
// it stands for; whatever else leaves it is a fault, and so is an input that takes too long or too much
// memory. Each target is a file of tests/fuzz/files or tests/fuzz/wire that ends in a `const Target`.
// scripts/fuzz links one of them with libFuzzer; the test fuzz_replay links all of them and gives each the
// inputs of corpus/NAME.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::fuzz {

inline constexpr double kLongest = 1;                  // time of the processor for an input [s]
inline constexpr std::size_t kMemoryFactor = 100;      // of the input's length, in memory
inline constexpr std::size_t kMemoryBase = 1 << 20;    // and this much beside it, for a short input [bytes]
inline constexpr std::size_t kModelMemory = 64 << 20;  // the same where a model is built [bytes]
// The same where a frame is parsed: protobuf reserves up to 50 MB, which it does not touch, for a text that
// says it is so long.
inline constexpr std::size_t kFrameMemory = 64 << 20;

class Target {
 public:
  // `memory`: what it may take for a short input [bytes].
  Target(const char* name, void (*take)(std::string_view), std::size_t memory = kMemoryBase);

  const char* name() const { return name_; }

  // Throws std::runtime_error where the input takes more than is allowed.
  void run(std::string_view input) const;

 private:
  const char* name_;
  void (*take_)(std::string_view);
  std::size_t memory_;
};

// Those that are linked.
const std::vector<const Target*>& targets();

// What the user is told is one line.
void require_one_line(const char* message);

// `read` may refuse its input as the user's mistake.
template <class Read>
void read_or_refuse(Read&& read) {
  try {
    read();
  } catch (const protocol::UserError& error) {
    require_one_line(error.what());
  }
}

}  // namespace adit::fuzz
