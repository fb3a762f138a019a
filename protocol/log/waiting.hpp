// Tells that a long wait goes on.
#pragma once

#include <string>
#include <thread>

namespace adit::protocol {

// As long as it lives: `what` and for how long, after 2 s, 4 s, 8 s and so on, at last once a minute.
class Waiting {
 public:
  explicit Waiting(std::string what);

 private:
  std::jthread thread_;
};

}  // namespace adit::protocol
