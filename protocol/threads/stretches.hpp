// Stretches of consecutive numbers. A participant computes what touches its interface before the rest
// (participant.hpp); both are lists of stretches, so that the loops over them stay contiguous.
#pragma once

#include <cstdint>
#include <vector>

namespace adit::protocol {

// The numbers begin … end - 1.
struct Stretch {
  std::uint32_t begin, end;
};

// Cuts 0 … count - 1 where test(k) changes: visit(stretch, outcome) for each piece in turn.
template <class Test, class Visit>
void for_each_stretch(std::uint32_t count, Test&& test, Visit&& visit) {
  for (std::uint32_t begin = 0; begin < count;) {
    const bool outcome = test(begin);
    std::uint32_t end = begin + 1;
    while (end < count && test(end) == outcome) ++end;
    visit(Stretch{begin, end}, outcome);
    begin = end;
  }
}

// The stretches of the numbers whose flag has this value.
inline std::vector<Stretch> stretches(const std::vector<bool>& flags, bool value) {
  std::vector<Stretch> found;
  for_each_stretch(
      static_cast<std::uint32_t>(flags.size()), [&](std::uint32_t k) { return flags[k]; },
      [&](const Stretch& stretch, bool flag) {
        if (flag == value) found.push_back(stretch);
      });
  return found;
}

}  // namespace adit::protocol
