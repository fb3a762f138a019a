// The multipliers' impulses on one participant, at its coupling points: computed for a step, sent once.
#pragma once

#include <google/protobuf/repeated_field.h>

#include <algorithm>
#include <span>
#include <vector>

#include "protocol/messages/spans.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

class Correction {
 public:
  Correction() = default;
  explicit Correction(std::size_t coupling_points) : impulses_(2 * coupling_points, 0.0) {}

  // One pair for each coupling point [N s].
  std::span<const double> impulses() const { return impulses_; }
  // For those of the next step, to be written by the caller, which are then to be sent.
  std::span<double> renew() {
    pending_ = true;
    return impulses_;
  }
  // They are not to be sent.
  void withhold() { pending_ = false; }
  // Fills the field, unless they were sent or withheld.
  void send(google::protobuf::RepeatedField<double>& field) {
    if (pending_) std::ranges::copy(impulses_, protocol::resize(field, impulses_.size()).begin());
    pending_ = false;
  }

  void exchange(state::Archive& archive) {
    archive("impulses", std::span(impulses_));
    archive("pending", pending_);
  }

 private:
  std::vector<double> impulses_;
  bool pending_ = false;
};

}  // namespace adit::coupler
