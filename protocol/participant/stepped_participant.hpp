// The steps of a participant: what every solver does alike, in the one order that wire.proto (Advance)
// allows. A solver derives from this class and supplies its physics through the hooks.
//
// A request for step n becomes these calls:
//   1. the request is checked against the steps before (RequestError)
//   2. correct: the velocities of step n - 1 become final
//   3. take_peaks of step n - 1, where they were wanted
//   4. start_over where step n is the first after statics;
//      measure_unrest, stop or slow, excavate and scale_masses where step n relaxes
//   5. prepare, and remember_for_peaks where they are wanted
//   6. step_interface, then step_interior: the latter only after the answer was sent (complete) where the
//      participant is coupled and nothing that is wanted needs the whole step
//   7. the answer: read_velocities, and what else is wanted
//
// A step in which a condensed model follows its masters becomes follow, prepare, remember_for_peaks and
// arrive in place of these.
//
// A correction arrives one message late, with the next step or with a snapshot: peaks wait for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/messages/wire.pb.h"
#include "protocol/participant/participant.hpp"
#include "protocol/participant/step.hpp"

namespace adit::protocol {

class SteppedParticipant : public Participant {
 public:
  // Step numbers are checked by the Conversation, all else of a request here.
  void advance(const wire::Advance& request, wire::Predicted& predicted) final;
  void condense(const wire::Condense& request, wire::Condensed& condensed) final;
  void complete() final;
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) final;
  void exchange(state::Archive& archive) final;

 private:
  // 0 where the participant is alone.
  virtual std::size_t coupling_points() const = 0;

  // Adds impulses [N s], one pair for each coupling point, to the velocities predicted last.
  virtual void correct(std::span<const double> impulses) = 0;

  // Statics. The unrest is that of `last`, corrected; the predicted kinetic energy is asked for after the
  // step.
  virtual void measure_unrest(const Step& last, wire::Relaxation& answer) = 0;
  virtual double kinetic_energy() const = 0;
  // All velocities become 0: the next step starts from rest.
  virtual void stop() = 0;
  // All velocities are multiplied by this factor, told before a step that relaxes and is not stopped.
  virtual void slow(double /*factor*/) {}
  // The stage of excavation of the next step, told before every step that relaxes.
  virtual void excavate(std::uint32_t /*stage*/) {}
  // Whether masses are those of statics (wire.proto, Advance) or the true ones, told before every step that
  // relaxes, and when time begins. It changes at rest.
  virtual void scale_masses(bool /*scaled*/) {}
  // The next step is the first of time: from rest and the stresses reached, all sums from 0. The forces that
  // go on holding dashpots' points grow by those of the dashpots against this velocity of the model.
  virtual void start_over(const Drift& drift) = 0;

  // The peaks over time, if the solver keeps any: what a step overwrites, before it; and the step, corrected.
  virtual void remember_for_peaks() {}
  virtual void take_peaks(const Step& /*step*/) {}

  // A model that can wait, condensed (wire.proto, Condense and Following): says what it is to its masters;
  // gets the velocities of half a step before, then everything of this step, demand included; goes on by
  // itself.
  virtual void condense_solver(const wire::Condense& /*request*/, wire::Condensed& condensed) {
    condensed.set_reason("this model cannot wait");
  }
  virtual void follow(const Step& /*step*/, const wire::Following& /*masters*/) {}
  virtual double arrive(const Step& /*step*/) { return 0; }
  virtual void go_on() {}

  // Before the step: what its energies and histories need of the state before it.
  virtual void prepare(const Step& step, const wire::Advance& wanted) = 0;
  // Moves to `step`, finds its forces, predicts the velocities half a step later. The first half completes
  // the velocities at the coupling points, the second one everything else; a solver that cannot divide its
  // step does all of it in the first.
  virtual void step_interface(const Step& step) = 0;
  virtual void step_interior(const Step& step) = 0;

  // The answer. Velocities at the coupling points, as predicted, interleaved [m/s]; energies and histories
  // after the whole step; events of all steps that became whole since the last answer.
  virtual void read_velocities(std::span<double> velocities) const = 0;
  virtual void read_energies(const Step& step, wire::Energies& energies) = 0;
  virtual void read_histories(const Step& step, google::protobuf::RepeatedField<double>& values) = 0;
  virtual void read_events(wire::Predicted& /*predicted*/) {}

  // The solver's share of the state (participant.hpp).
  virtual void exchange_solver(state::Archive& /*archive*/) {}

  // The state reached, corrected, with the peaks so far.
  virtual void draw(wire::Snapshot& snapshot) = 0;

  void check(const wire::Advance& request) const;
  void correct_last_step(const google::protobuf::RepeatedField<double>& impulses);
  void take_peaks_due();
  void relax(const wire::Advance& request, wire::Relaxation& answer);
  void begin_time(const Drift& drift);
  void follow_masters(const wire::Advance& request, wire::Predicted& predicted);
  void answer(const Step& step, const wire::Advance& request, wire::Predicted& predicted);

  Step last_{0, 0.0};
  bool scaled_ = false;         // masses, in statics
  bool started_ = false;        // the last step exists
  bool corrected_ = false;      // it was
  bool peaks_due_ = false;      // it enters the peaks once it is corrected
  bool interior_left_ = false;  // it is not whole
  std::size_t masters_ = 0;     // of a model that waits, condensed; 0: it does not
};

}  // namespace adit::protocol
