// Pairs of discs that act on each other, as structure of arrays: those that were bonded, and those that are
// near.
//
// A pair is a bond and a contact. The bond is of a width w (laws/parallel_bond.hpp; a contact bond has w = 1)
// and acts while it is intact. The contact of the surfaces (laws/linear_contact.hpp) acts beside a parallel
// bond, and in place of a contact bond once that is broken; its gap is L - L0 + slack.
//
// Discs belong to blocks of consecutive numbers, pairs to the block of their first disc, so that threads
// share the blocks. A block computes with copies of the discs that it reaches (block_discs.hpp); what its
// pairs do to a disc of another block waits in `away` until that block gathers it, in a fixed order.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "dem_server/laws/bond_state.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

inline constexpr std::uint32_t kBlock = 1024;  // discs
inline constexpr std::uint32_t kChunk = 128;   // pairs that are computed at a time

inline constexpr std::uint32_t kDiscValues = 8;  // that the list of a block holds of a disc

inline std::size_t blocks_of(std::size_t discs) {
  return (discs + kBlock - 1) / kBlock;
}

// If `width` is in metres, stiffnesses are in Pa/m and strengths in Pa; contact bonds have width 1, N/m and
// N.
struct PairLaw {
  double kn = 0, ks = 0, km = 0;
  double tensile_strength = std::numeric_limits<double>::infinity();
  double moment_factor = 0;
  double cohesion = std::numeric_limits<double>::infinity();
  double tan_friction_angle = 0;
  bool contact_beside_bond = false;  // the contact acts while the bond is intact, too
  LinearContact contact{};
  auto operator<=>(const PairLaw&) const = default;
};

struct Pairs {
  std::vector<std::uint32_t> first, second, law;      // ascending by first, then by second
  std::vector<double> rest_x, rest_y;                 // from first to second at rest [m]
  std::vector<double> rest_length;                    // L0 [m]
  std::vector<double> half_difference;                // of the radii [m]
  std::vector<double> slack;                          // [m]
  std::vector<double> width;                          // w of the bond; empty: none
  std::vector<double> weight;                         // energy weight
  std::vector<double> slide;                          // shear force of the contact's spring [N]
  std::vector<double> normal_dashpot, shear_dashpot;  // forces [N]; empty: none
  std::vector<double> initial, shear, moment;         // of the bond: N0, S, M; empty: none
  std::vector<BondState> state;                       // of the bond; empty: none
  std::size_t size() const { return first.size(); }
  bool bonded() const { return !state.empty(); }
  bool in_block(std::uint32_t block) const { return chunk_starts[block] < chunk_starts[block + 1]; }

  // Consecutive pairs of one block. Intact: all bonds are, and contacts act beside all of them or beside
  // none. Varied: of one law besides, without initial force and weight. Plain: of one width besides, without
  // slack. Chunks of contacts without bonds are plain, varied or intact by the same rules.
  enum class Kind : std::uint8_t { kPlain, kVaried, kIntact, kGeneral };
  struct Chunk {
    std::uint32_t begin, end;
    std::uint32_t law = 0;  // of the first, which lies in memory that a chunk of one law need not touch
    Kind kind = Kind::kGeneral;
    bool one_law = false;
    bool contacts_beside_bonds = false;  // beside the first; or no pair is bonded
    bool contacts_act() const { return contacts_beside_bonds || kind == Kind::kGeneral; }
  };
  std::vector<Chunk> chunks;
  std::vector<std::uint32_t> chunk_starts;  // of each block, and the end

  // Where the list of the block has the discs (block_discs.hpp), in numbers of values.
  std::vector<std::uint32_t> first_place, second_place;
  // Second discs in other blocks than the first: by block of the first, ascending, and the forces on them;
  // arrivals: which of these are in a block.
  struct Arrival {
    std::uint32_t slot, disc;
  };
  std::vector<std::uint32_t> reached, reach_starts, arrival_starts;
  std::vector<double> away_x, away_y, away_moment;
  std::vector<Arrival> arrivals;

  // Makes room for the pairs' states and sorts them into blocks, once first and second are known.
  void finish(std::size_t discs, bool bonded, bool dashpots);
  // Finds of which kind the chunks are; without bonds no laws are needed.
  void sort_chunks(std::span<const PairLaw> laws);

  // All but the chunks and blocks, which finish() makes of the pairs, and what they are waiting for between
  // two steps.
  void exchange(std::size_t discs, std::span<const PairLaw> laws, state::Archive& archive);

 private:
  void divide(std::size_t discs);
  void find_places(std::uint32_t block, std::uint32_t begin, std::uint32_t end);
  void exchange_kinds(std::span<const PairLaw> laws, state::Archive& archive);
};

}  // namespace adit::dem
