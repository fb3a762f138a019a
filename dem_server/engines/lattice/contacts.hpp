// Contacts between particles that no bond joins: which may touch, and what they do where they do.
//
// All pairs nearer than a diameter and a skin are listed. The list holds until two particles may have come
// closer by the skin, that is until one has moved by half of it: the sum of dt max |v| bounds that at no
// cost, and only where the bound is reached are the displacements themselves looked at.
//
// A contact is without friction: Fn = min(kn (L - 2 R), 0), weighted by the mean of its particles' weights.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/packing/discs.hpp"
#include "dem_server/particles/bonded_neighbours.hpp"
#include "dem_server/particles/displacement_bound.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class Contacts {
 public:
  Contacts() = default;
  explicit Contacts(const Assembly& assembly);

  // Before a step of dt: makes a new list where the particles have moved so far that the old one may miss a
  // contact. Returns whether it changed.
  bool update(double dt, const Assembly& assembly);
  // Takes the largest speed at which a particle moved in a step of dt [m/s].
  void moved(double dt, double speed) {
    moved_.add(dt * speed);
    speed_ = speed;
  }

  std::span<const Pair> pairs() const { return pairs_; }
  std::uint64_t lists() const { return lists_; }  // made so far

  void exchange(state::Archive& archive) {
    archive("contact_pairs", pairs_);
    moved_.exchange(archive);
    archive("speed", speed_);
    archive("lists", lists_);
  }

 private:
  void list(const Assembly& assembly);

  BondedNeighbours bonded_;
  std::vector<Pair> pairs_;
  DisplacementBound moved_;  // since the list was made
  double skin_ = 0;          // [m]
  double speed_ = 0;         // of the last step
  std::uint64_t lists_ = 0;
};

// Adds the forces of the pairs that touch to the resultants.
void add_contacts(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                  const Particles& particles, const Resultants& resultants);
// Strain energy of the pairs that touch, weighted [J].
double contact_energy(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                      const Particles& particles);

}  // namespace adit::dem
