// How far a long computation is.
#pragma once

#include <functional>
#include <string>

namespace adit::protocol {

// Takes a few words, as in "growing 1000 discs: step 3 of 20", from the thread that computes and as often as
// it likes.
using Progress = std::function<void(const std::string& how_far)>;

}  // namespace adit::protocol
