// The energy ledger across the interface.
//
// With velocities at half steps the leap-frog scheme keeps, for a linear system,
//     E(n) = ½ Σ m v(n−½)·v(n+½) + strain energy(n),
// which changes in a step by dt v(n+½)·½(f(n) + f(n+1)) for every force f that is no gradient of the strain
// energy: loads, prescribed motions (both booked by the participants) and multipliers (booked here). The
// participant's kinetic energy ends with its prediction; the impulse p of the same step adds ½ (N v(n−½))·p.
// Before step 0 the system rests: v(−½) = −v(½), and the first impulse acts over half a step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupler/interface.hpp"
#include "coupler/side.hpp"

namespace adit::coupler {

struct SideEnergies {  // [J]
  double kinetic = 0, strain = 0, released = 0, external_work = 0, multiplier_work = 0;
};

class Ledger {
 public:
  Ledger(const std::vector<Side>& sides, const std::vector<Interface>& interfaces);

  // Books the step: impulses and velocities of every side are those of step n.
  void add_step(std::uint64_t n, const std::vector<Side>& sides, bool with_energies);

  // As of the last step with energies.
  const std::vector<SideEnergies>& sides() const { return energies_; }
  double stored() const;  // kinetic, strain and released energy of all sides
  // Stored minus external work, since step 0: what drifted, or what a lossy solve took.
  double unexplained() const;
  double drift() const;      // the same relative to the largest stored energy so far
  double max_drift() const;  // the largest |unexplained| relative to the largest stored energy
  double kept() const;       // stored over external work; 1 where there was none

  // Largest gap of the corrected velocities over the largest velocity at the coupling points.
  double max_constraint_residual() const;

 private:
  struct Previous {
    std::vector<double> impulses, velocities;
  };
  void book_multipliers(std::uint64_t n, const std::vector<Side>& sides);
  void book_residual(const std::vector<Side>& sides);

  struct Tie {  // coupling points of an interface among those of its two sides
    std::size_t coarse, coarse_begin, fine, fine_begin, count;
  };
  std::vector<Tie> ties_;

  std::vector<SideEnergies> energies_;
  std::vector<double> multiplier_work_;
  std::vector<double> kinetic_correction_;
  std::vector<Previous> previous_;
  double unexplained_at_start_ = 0;
  double peak_stored_ = 0, peak_unexplained_ = 0;
  double largest_gap_ = 0, largest_velocity_ = 0;
};

}  // namespace adit::coupler
