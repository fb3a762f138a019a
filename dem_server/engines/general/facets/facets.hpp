// The facets of a model, step by step (facet_kernel.hpp), as a part of the solver beside pairs, joints and
// springs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/crack.hpp"
#include "dem_server/engines/general/facets/facet_kernel.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/threads/index_ranges.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

// A facet as it is now: force on its first cell and moment about its middle, unweighted.
struct FacetState {
  double nx, ny;                 // its normal
  double x, y;                   // its middle [m]
  double normal, shear, moment;  // [N], [N m]
  double opening, slip;          // of the half that is wider open, as far as they are not elastic [m]
  BondState state;
};

class Facets {
 public:
  Facets() = default;
  Facets(const Model& model, std::size_t threads);

  bool empty() const { return set_.size() == 0; }
  std::size_t size() const { return set_.size(); }
  const FacetSet& set() const { return set_; }

  // 0: the step is one of statics, or starts from rest.
  void set_steps_per_second(double rate) { set_.steps_per_second = rate; }
  // A step turns all cells, adds the forces block by block, and ends. Blocks may be computed by different
  // threads at once. The first is left out where the step starts from rest.
  void turn(double dt, const protocol::IndexRange& cells, std::span<const double> spin);
  // To the sums of a block's cells, which `discs` have taken; with `relax` internal forces are summed, too.
  void add_forces(std::uint32_t block, std::size_t thread, bool relax, const Particles& particles,
                  BlockDiscs& discs);
  void end_step();

  // Adds to the resultants of all cells, which turn by `dt` times their spin before.
  void find_forces(double dt, Particles& particles, protocol::Team& team);
  // The same for cells that have turned by their `spin` [rad], whatever they did before.
  void find_linear_forces(Particles& particles, protocol::Team& team);

  // What a facet does to its cells.
  FacetAction action(std::uint32_t facet, const Particles& particles) const;
  // Those that join their cells, and those at which the cells only touch; ascending.
  std::span<const std::uint32_t> joining() const { return joining_; }
  std::span<const std::uint32_t> touching() const { return touching_; }
  FacetState state(std::uint32_t facet, const Particles& particles) const;
  // Of the last step: facets that cracked, ascending; the largest |normal force|.
  std::span<const std::uint32_t> cracked() const { return cracked_; }
  bool any_parted() const;  // in the last step
  // What a cracked facet leaves, in the body at rest.
  Crack crack(std::uint32_t facet, const Particles& particles) const;
  Strongest strongest(const Particles& particles) const;
  // Sum of |force|, weighted, at the last step of statics [N].
  double internal_force() const { return internal_force_; }
  double strain_energy(const Particles& particles) const;  // weighted [J]
  double fracture() const { return fracture_; }            // dissipated since the start, weighted [J]
  void start_over() { fracture_ = 0; }

  // Takes the facets of another stage: those of the same two cells and law keep what they are, of which no
  // cell is fresh; the others begin free of stress as the cells lie now.
  void begin_stage(const Model& model, const std::vector<bool>& fresh, const Particles& particles);

  void exchange(state::Archive& archive);

 private:
  void divide();

  FacetSet set_;
  std::vector<FacetPatch> patches_;   // of blocks
  std::vector<FacetResult> results_;  // of blocks
  std::vector<FacetWork> work_;       // of threads
  std::vector<std::uint32_t> joining_, touching_;
  std::vector<std::uint32_t> cracked_;
  double fracture_ = 0, internal_force_ = 0;
};

}  // namespace adit::dem
