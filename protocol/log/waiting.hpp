// Tells that a long wait goes on.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace adit::protocol {

// As long as it lives: `what`, for how long, and how far it is where that is known, after 2 s, 4 s, 8 s and
// so on, at last once a minute.
class Waiting {
 public:
  Waiting(std::string what, std::function<std::string()> how_far);

 private:
  std::jthread thread_;
};

}  // namespace adit::protocol
