// Which discs may touch that were never joined: pairs nearer than a skin, listed anew when needed and no
// sooner.
//
// The list holds until two discs may have come closer by the skin, that is until one has moved by half of it:
// the sum of dt max |v| bounds that at no cost, and only where the bound is reached are the displacements
// themselves looked at. A pair that stays listed keeps the forces of its springs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/packing/discs.hpp"
#include "dem_server/particles/displacement_bound.hpp"

namespace adit::dem {

class Neighbours {
 public:
  Neighbours() = default;
  // Of so many particles that are no discs, none of which touches as discs do.
  explicit Neighbours(std::size_t particles) : radius_(particles, 0.0) {
    pairs_.finish(particles, false, false);
  }
  // `joined`: ascending; these never enter the list. The law of a contact of discs of groups a and b is
  // first_law + group_pair_number(groups, a, b). Overlaps at the start bear no force where `overlaps_free`,
  // except what the pairs of `touching` bear.
  Neighbours(const Particles& particles, std::vector<double> radius, std::vector<Pair> joined,
             std::vector<std::uint32_t> group, std::uint32_t groups, std::uint32_t first_law, bool dashpots,
             bool overlaps_free, std::span<const TouchingPair> touching, std::span<const PairLaw> laws);

  // Pairs and groups become those of a new stage. Pairs that were not listed before, and those of discs that
  // begin (`fresh`), start free of force at their present places; discs that were taken away have none.
  void begin_stage(const Particles& particles, std::vector<Pair> joined, std::vector<std::uint32_t> group,
                   std::uint32_t first_law, const std::vector<bool>& fresh);

  // A step moved the discs, and walls, by at most this [m].
  void moved(double farthest, double farthest_wall) {
    moved_.add(farthest);
    walls_travelled_ += farthest_wall;
  }
  // Before the forces: makes a new list where all have moved so far that the old one may miss a contact.
  // Returns whether it changed.
  bool update(const Particles& particles);

  void exchange(std::span<const PairLaw> laws, state::Archive& archive) {
    pairs_.exchange(radius_.size(), laws, archive);
    moved_.exchange(archive);
    archive("walls_travelled", walls_travelled_);
    archive("lists", lists_);
  }

  const Pairs& pairs() const { return pairs_; }
  Pairs& pairs() { return pairs_; }
  double skin() const { return skin_; }           // [m]
  std::uint64_t lists() const { return lists_; }  // made so far

 private:
  // Returns which pairs the earlier list held too. The chunks wait to be sorted until the slack is known.
  std::vector<bool> list(const Particles& particles);
  void press(std::span<const TouchingPair> touching, std::span<const PairLaw> laws);

  std::vector<double> radius_;
  std::vector<Pair> joined_;
  std::vector<std::uint32_t> group_;
  std::uint32_t groups_ = 1, first_law_ = 0;
  bool dashpots_ = false;
  Pairs pairs_;
  DisplacementBound moved_;     // of the discs since the list was made
  double skin_ = 0;             // [m]
  double walls_travelled_ = 0;  // at most, by any wall since the list was made [m]
  std::uint64_t lists_ = 0;
};

}  // namespace adit::dem
