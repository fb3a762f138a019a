// What a run leaves out of the shaking of a motion.
#pragma once

#include <string>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// The part from `from` to `until`, of which the run takes its duration [s].
struct Cut {
  double from, until, duration;
};

// A sentence for each end at which more than 1 % of the Arias intensity of the whole motion is left out, for
// a first value of more than 5 % of the peak, and for a window that raises the acceleration by more than 1 %
// of its peak.
std::vector<std::string> notes_on_cut(const Motion& whole, const Cut& cut);

}  // namespace adit::motion
