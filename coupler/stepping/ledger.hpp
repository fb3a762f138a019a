// The energy ledger across the interfaces.
//
// With velocities at half steps the leap-frog scheme keeps, for a linear system,
//     E(n) = ½ Σ m v(n−½)·v(n+½) + strain energy(n),
// which changes in a step by dt v(n+½)·½(f(n) + f(n+1)) for every force f that is no gradient of the strain
// energy: loads, prescribed motions (both booked by the participants) and multipliers (booked here). The
// participant's kinetic energy ends with its prediction; the impulse p of the same step adds ½ (N v(n−½))·p.
// Before step 0 the system rests: v(−½) = −v(½), and the first impulse acts over half a step.
//
// Every participant is booked in its own steps, which may differ in length.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

struct ParticipantEnergies {  // [J]
  double kinetic = 0, strain = 0, released = 0, external_work = 0, multiplier_work = 0, dissipated = 0;

  // Stored and dissipated minus all work done on the participant: constant where nothing is lost.
  double balance() const {
    return kinetic + strain + released + dissipated - external_work - multiplier_work;
  }
  // The sum of all, whatever its sign.
  double turnover() const {
    return std::abs(kinetic) + std::abs(strain) + std::abs(released) + std::abs(external_work) +
           std::abs(multiplier_work) + std::abs(dissipated);
  }
};

// The kinetic energy of a model whose points all move by the last bit of their places in each step [J]:
// ½ M (ε L / dt)², ε the distance of 1 to the next number, L the largest coordinate, M the mass. Places are
// rounded to ε L, so that an opening between bodies is known no better, and the contact that it opens or
// closes does work at random: such a motion says nothing of the time step. The energy of a real instability
// is multiplied in each step (by 1.8 at 1.01 of the critical one) and leaves this within a few.
double rounding_energy(const std::vector<Participant>& participants, double dt);

class Ledger {
 public:
  // `rounding`: energy that cannot be told from 0 [J], see rounding_energy().
  explicit Ledger(const std::vector<Participant>& participants, double rounding = 0);

  // Takes down the energies that the participant's last answer holds; its impulses are those of the same
  // step.
  void take_energies(std::size_t s, const Participant& participant);
  // The same of one whose step is still in progress: its impulses so far have `added` to its energies [J].
  void take_energies(std::size_t s, const Participant& participant, double added);
  // Those of one that waits, condensed.
  void take_condensed(std::size_t s, const ParticipantEnergies& energies) { energies_[s] = energies; }
  // It waits no longer: its velocities were predicted last, and this is the work done on it so far [J]. The
  // next compare() tells what that changed.
  void begin(std::size_t s, const Participant& participant, double multiplier_work);
  // After the energies of all participants: compares them with those of the start and of the peak.
  void compare();

  // Books the participant's step: its impulses, and its velocities after them.
  void close_step(std::size_t s, const Participant& participant);
  // Books the gap that the corrected velocities leave at the coupling points.
  void book_gap(std::span<const double> coarse, std::span<const double> fine);

  // As of the last compare().
  const std::vector<ParticipantEnergies>& energies() const { return energies_; }
  double stored() const;  // kinetic, strain and released energy of all participants
  // Stored and dissipated minus external work, since the start: what drifted, or what a lossy solve took.
  double unexplained() const;
  // The same relative to the largest stored energy so far, or to the rounding energy where that is larger:
  // nothing is known of a model that moves by rounding errors only.
  double drift() const;
  double max_drift() const;  // the largest |unexplained| relative to the largest stored energy
  // By which energy rose when particles that waited began, relative to the largest stored energy by then: of
  // several beginnings, the largest in size.
  double change() const { return change_; }
  double kept() const;  // stored over external work; 1 where there was none

  // What the participants have lost that nobody booked, since the start: neither dissipated nor taken by
  // loads or by multipliers, as a lossy solve may. Relative to the largest sum of all energies and works so
  // far, which a long run that dissipates much does not outgrow; or to the kinetic energy at a micrometre a
  // second, below which rounding of the energy at rest is all that is seen. `participant` lost most.
  struct Loss {
    double share;
    std::size_t participant;
  };
  Loss loss() const;

  void exchange(state::Archive& archive);

  // Largest gap of the corrected velocities over the largest velocity at the coupling points.
  double max_constraint_residual() const;

 private:
  struct Account {
    bool started = false;                      // step 0 is closed
    double multiplier_work = 0;                // up to the last step closed
    double added_at_start = 0;                 // of a step in progress: no work, see take_energies()
    std::vector<double> impulses, velocities;  // of that step, at the participant's coupling points
  };

  static double of_nodes(const Account& account, const Participant& participant);

  double rounding_, still_;  // energies that cannot be told from 0 [J], by places and by energies at rest
  std::vector<ParticipantEnergies> energies_;
  std::vector<Account> accounts_;
  bool compared_ = false;
  double unexplained_at_start_ = 0;
  std::vector<double> balances_at_start_;  // of each participant
  double first_turnover_ = 0;              // the first that is not 0
  double peak_turnover_ = 0;
  double peak_stored_ = 0, peak_unexplained_ = 0;
  double change_ = 0;
  bool changes_ = false;           // since the last compare()
  double unexplained_before_ = 0;  // as of that compare() [J]
  double largest_gap_ = 0, largest_velocity_ = 0;
};

}  // namespace adit::coupler
