// The longest answer to each kind of request, by what the participant told of its model before. Nothing
// longer is received.
#pragma once

#include <cstdint>

#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

class AnswerBounds {
 public:
  // What is asked, and what is answered, in turn.
  void asked(const wire::Frame& request);
  void answered(const wire::Frame& answer);

  // Of the answer to the request of this kind asked last [bytes], all of its parts together.
  std::uint64_t longest(wire::Frame::ContentCase request) const;

 private:
  std::uint64_t samples_ = 0;           // points of the model
  std::uint64_t bonds_ = 0;             // that may break in a step
  std::uint64_t coupling_numbers_ = 0;  // that state its coupling points
};

}  // namespace adit::coupler
