// A rank's part of the particles: its own ones, then the ghosts that its pairs reach. What changes hands
// between ranks are columns of values and records of pairs; who gives and takes them is LAMMPS (carrier.hpp).
//
// Forces are those of the general engine's kernels (dem_server/engines/general/pairs), block by block in the
// same order: one rank gives the bits of dem_server.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "adapters/lammps/particles/pair_records.hpp"
#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/general/pairs/pair_forces.hpp"
#include "dem_server/engines/general/pairs/pair_state.hpp"
#include "dem_server/particles/displacement_bound.hpp"
#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::lammps {

// The laws of a model's pairs, known to all ranks.
struct Laws {
  std::vector<dem::PairLaw> all;
  std::uint32_t first_contact = 0, groups = 1;
  double skin = 0;  // [m]: pairs with a smaller gap are listed
  bool bonded = false, dashpots = false;
};

struct Broken {
  double number, state;
};

class Part {
 public:
  static constexpr std::size_t kColumns = 18;
  using Near = std::vector<dem::Pair>;  // by their places

  // Values of a particle that travel with it.
  std::array<std::vector<double>*, kColumns> columns();
  // Room for so many; new ones are without mass.
  void resize(std::size_t places);

  // While LAMMPS gives particles other places.
  void open(std::size_t room, const PlaceOf& place_of);
  std::size_t most_pairs() const;  // that one of the own particles takes along
  void copy(std::size_t from, std::size_t to);
  std::vector<PairRecord> bonds_of(std::size_t place) const;
  std::vector<PairRecord> contacts_of(std::size_t place) const;
  void arrive(std::size_t place, std::vector<PairRecord> bonds, std::vector<PairRecord> contacts);
  // They have them: `numbers` of all, the first `own` of which are this rank's. `near` may touch.
  void close(Numbers numbers, std::uint32_t own, const PlaceOf& place_of, const Near& near);

  // Pairs from the start, before the first close().
  void take_bond(const PairRecord& bond) { bonds_out_.push_back(bond); }
  void take_contact(const PairRecord& contact) { contacts_out_.push_back(contact); }

  void move(double dt);
  void pull(double dt);
  protocol::IndexRange own_range() const { return {0, own_}; }

  // How far a particle may have moved since the last close(), own ones [m].
  dem::DisplacementBound moved;

  dem::Particles particles;
  std::vector<double> group, conditions;  // numbers
  dem::Velocities before;
  Laws laws;

  std::uint32_t own() const { return own_; }
  void own(std::uint32_t count) { own_ = count; }
  const Numbers& numbers() const { return particles.id; }
  // Of the last step: bonds with a first particle of this rank.
  std::span<const Broken> broken() const { return broken_; }
  const dem::Strongest& strongest() const { return strongest_; }
  // An intact bond reaches beyond the ghosts: it bears nothing any more.
  bool torn() const { return torn_; }
  // Half of what pairs of two ranks hold belongs to each.
  dem::Stored stored() const;
  double friction = 0, dashpots = 0, released = 0;  // since the start, likewise [J]

  // The pairs whose first particle is this rank's.
  void for_each_bond(const std::function<void(const PairRecord&)>& see) const;
  void for_each_contact(const std::function<void(const PairRecord&)>& see) const;

 private:
  struct Share {
    PairSet set;
    double share;  // of its sums
  };
  struct Arrival {
    std::vector<PairRecord> bonds, contacts;
  };
  void for_each(const std::array<Share, 2>& sets, const std::function<void(const PairRecord&)>& see) const;
  bool is_own(double number, const PlaceOf& place_of) const { return place_of(number) < own_; }
  void keep_own(std::vector<PairRecord>& records, const PlaceOf& place_of) const;
  std::vector<PairRecord> list(const Near& near) const;
  std::vector<PairRecord> bonds_in_reach(const PlaceOf& place_of);
  std::array<Share, 2> divide(const std::vector<PairRecord>& records, const PlaceOf& place_of,
                              bool bonded) const;
  void add(const dem::PairResult& result, const Share& from);

  std::uint32_t own_ = 0;
  std::array<Share, 2> bonds_{}, contacts_{};  // of own particles; of an own one and a ghost
  std::vector<PairRecord> apart_;              // broken bonds whose other particle no ghost shows
  mutable dem::BlockDiscs discs_;              // room for a block in work
  std::vector<Broken> broken_;
  dem::Strongest strongest_;
  bool torn_ = false;

  // While it is open.
  std::vector<PairRecord> bonds_out_, contacts_out_;
  // Which records a particle that was here takes along: ascending by its place.
  struct Entry {
    std::uint32_t place, record;
  };
  using Index = std::vector<Entry>;
  static Index index_of(const std::vector<PairRecord>& records, const PlaceOf& place_of);
  std::vector<PairRecord> taken_along(std::size_t place, const Index& index,
                                      const std::vector<PairRecord>& records,
                                      std::vector<PairRecord> Arrival::*arrived) const;
  Index bonds_at_, contacts_at_;
  std::vector<std::int64_t> origin_;  // place before, or -1 - k: arrived as number k
  std::vector<Arrival> arrivals_;
};

}  // namespace adit::lammps
