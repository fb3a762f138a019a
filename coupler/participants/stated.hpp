// What acts where it differs from a number about time or motion that the scene states.
#pragma once

#include <string>
#include <vector>

namespace adit::coupler {

struct Stated {
  std::string key;        // of the scene: time.duration
  double stated, acted;   // in the unit
  std::string unit = {};  // s; empty: none
  std::string why = {};   // what is stated does not act: the end of a sentence; empty: nothing to warn of
};

// Adds one that differs by more than a hundredth of what is stated.
void add_where_it_differs(std::vector<Stated>& list, Stated one);

// A sentence for each that differs by more than a twentieth, and has a reason.
std::vector<std::string> warnings_of(const std::vector<Stated>& list);

}  // namespace adit::coupler
