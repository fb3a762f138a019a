// Bonded particles as a participant of a run: translates the conversation (wire.proto) into calls of the
// kernels.
#pragma once

#include <cstdint>
#include <ctime>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/engines/lattice/contact_forces.hpp"
#include "dem_server/engines/lattice/contacts.hpp"
#include "dem_server/engines/lattice/sweep.hpp"
#include "dem_server/participant/coupling_points.hpp"
#include "dem_server/participant/histories.hpp"
#include "dem_server/participant/relaxation.hpp"
#include "dem_server/particles/assembly.hpp"
#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/motions.hpp"
#include "protocol/participant/participant.hpp"
#include "protocol/participant/peak_motion.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

class DemParticipant : public protocol::Participant {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  explicit DemParticipant(std::size_t threads = 1) : threads_(threads) {}

  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override;
  void complete() override;
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override;
  void finish(wire::Bye& bye) override;

 private:
  // What is computed together. The bonds of a tied particle are the interface's, and so are the moves of all
  // particles at their ends: the kicks of the tied ones then need nothing of the interior.
  struct Part {
    Sweep sweep;
    std::vector<Pair> pairs;
    Loads loads;
    Motions motions;
  };

  // Divides bonds and contacts between the parts.
  void plan();
  // Moves and resultants of step n; velocities of n + 1/2 where only bonds pull.
  void pull(Part& part);
  // The other velocities of n + 1/2.
  void predict(Part& part);
  // Notes what the whole step brought, for the next answer.
  void close_step();

  // Adds the coupler's impulses to the velocities predicted last; empty: none.
  void correct(std::span<const double> impulses);
  // Says how far the particles are from rest after their correction, and stops them where they shall.
  void relax(bool stop, wire::Relaxation& answer);
  void stop();
  // The first step that does not relax: from the state reached.
  void start_over();
  // Of the last step, where they are wanted, once it is corrected.
  void take_peaks();
  void report_energies(wire::Energies& energies);
  double strain_of_bonds();

  std::size_t threads_;
  std::optional<protocol::Team> team_;
  std::clock_t started_ = 0;
  scene::Scene scene_;
  Packing packing_;
  BondLaw law_{};
  Assembly assembly_;
  Part interface_, interior_;
  std::optional<Histories> histories_;
  std::optional<protocol::PeakMotion> peaks_;  // once wanted
  bool peaks_due_ = false;                     // of the last step
  CouplingPoints coupling_;
  Velocities before_;
  Contacts contacts_;
  std::vector<bool> tied_;                // of each particle: the interface acts on it
  ContactResult result_;                  // of this step, as far as computed
  double speed_ = 0;                      // largest of this step, likewise [m/s]
  std::vector<std::uint32_t> broken_;     // bonds that broke in this step
  double released_ = 0;                   // up to the last whole step [J]
  wire::Predicted unreported_;            // cracks and largest forces of whole steps
  std::optional<Relaxation> relaxation_;  // in statics
  protocol::Step step_{0, 0.0};           // this one
  std::uint64_t moves_ = 0;
  bool rest_left_ = false;  // of this step: its interior
};

}  // namespace adit::dem
