// Discs of any size as a participant of a run: translates the conversation (wire.proto) into calls of the
// solver.
#pragma once

#include <cstdint>
#include <ctime>
#include <optional>
#include <span>

#include "dem_server/engines/general/observe/disc_histories.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/participant/coupling_points.hpp"
#include "dem_server/participant/relaxation.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/motions.hpp"
#include "protocol/participant/participant.hpp"
#include "protocol/participant/peak_motion.hpp"
#include "protocol/participant/step.hpp"

namespace adit::dem {

class DiscsParticipant : public protocol::Participant {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  explicit DiscsParticipant(std::size_t threads = 1) : threads_(threads) {}

  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override;
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override;
  void finish(wire::Bye& bye) override;

 private:
  // Adds the coupler's impulses to the velocities predicted last; empty: none.
  void correct(std::span<const double> impulses);
  // Says how far the discs are from rest after their correction, and stops them where they shall.
  void relax(bool stop, wire::Relaxation& answer);
  // The first step that does not relax: from the state reached.
  void start_over();
  void take_peaks();
  void check_finite() const;
  void warn_of_escapes();
  void report_events(wire::Predicted& predicted) const;
  void report_energies(wire::Energies& energies) const;

  std::size_t threads_;
  std::clock_t started_ = 0;
  scene::Scene scene_;
  Weighed weighed_;
  std::optional<Solver> solver_;
  Loads loads_, body_loads_;
  Motions motions_;
  CouplingPoints coupling_;
  std::optional<DiscHistories> histories_;
  std::optional<protocol::PeakMotion> peaks_;  // once wanted
  bool peaks_due_ = false;                     // of the last step
  Velocities before_;
  std::optional<Relaxation> relaxation_;  // in statics
  protocol::Step step_{0, 0.0};           // this one
  std::uint64_t moves_ = 0, lists_ = 0;
  bool escaped_ = false;
};

}  // namespace adit::dem
