// Ends a run in which energy comes or goes by itself.
#pragma once

#include <cstdint>
#include <string>

#include "coupler/output/recorder.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/stepper.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// Looks at the energy of the steps that want energies, and knows the last one that was good.
class Watch {
 public:
  Watch(Stepper& stepper, const Model& model, Recorder& recorder)
      : stepper_(stepper), model_(model), recorder_(recorder) {}

  // Throws protocol::Unstable where energy comes or goes by itself; the fields of now are written before,
  // where they are numbers.
  void look(std::uint64_t n);
  std::string last_good() const;
  void exchange(state::Archive& archive) { archive("last_good", last_good_); }

 private:
  [[noreturn]] void end_growing(std::uint64_t n);
  [[noreturn]] void end_losing(std::uint64_t n, const Ledger::Loss& loss);
  double time_of(std::uint64_t n) const { return static_cast<double>(n) * model_.dt; }

  Stepper& stepper_;
  const Model& model_;
  Recorder& recorder_;
  std::uint64_t last_good_ = 0;
};

}  // namespace adit::coupler
