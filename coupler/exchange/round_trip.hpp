// One exchange with all participants, and the multipliers that correct what they predicted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

// What a step shows beside the participants' own answers.
struct Wanted {
  bool energies = false;
  bool histories = false;
  bool peaks = false;  // the step enters the peaks over time
};

// Seconds of a run so far.
struct StepCost {
  double wait = 0;   // from the first send to the last answer, the ledger's work included
  double solve = 0;  // for the multipliers
};

// Adds the seconds of its own life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point start_ = Clock::now();
};

// The request for a step, as it is the same for all participants.
void fill_request(wire::Advance& request, std::uint64_t step, double dt, Wanted wanted);

// Asks the participant for this step, and sends its pending correction with it.
void post_advance(Participant& participant, const wire::Advance& request);

// Collects the answer and reads the predicted velocities. An answer that does not fit what was asked is
// protocol::PeerLost.
void receive_prediction(Participant& participant);

// corrected = predicted + N M⁻¹ Nᵀ impulses: what the participant will apply, at the coupling points.
void correct_velocities(Participant& participant);

// The state at the step that each participant has reached, after its pending correction. Pieces of a region
// carry its name. What cannot be drawn is protocol::PeerLost.
std::vector<wire::Snapshot> take_snapshots(std::vector<Participant>& participants);

class RoundTrip {
 public:
  RoundTrip(Model& model, StepCost& cost);

  // Sends the request with the pending corrections, waits for all predictions but those of participants that
  // wait, and leaves new corrections pending. `meanwhile` is done while the participants compute.
  void run(
      const wire::Advance& request, const std::function<void()>& meanwhile = [] {});

 private:
  void solve();

  Model& model_;
  StepCost& cost_;
  std::vector<Participant*> order_;                  // in which they are asked
  std::vector<double> coarse_, fine_, multipliers_;  // one pair for each coupling point
};

}  // namespace adit::coupler
