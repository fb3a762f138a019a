// Pairs of discs that may pull on each other, as structure of arrays: those that were joined, and those that
// are near.
//
// A pair is cement and contact. Cement is a bond while it is whole, of a width w, with the springs
//   N = kn w (L - L0) + N0,    S += ks w dt slip_rate,    M += km w^3 dt turn_rate.
// It breaks in tension where N w + b |M| exceeds w^2 tensile_strength, else in shear where |S| exceeds
// w cohesion - N tan(friction angle). A parallel bond (laws/parallel_bond.hpp) has km = kn / 12 and b = 6, a
// contact bond w = 1 and neither.
//
// The contact of the surfaces (laws/linear_contact.hpp) acts beside the cement of a parallel bond, and of a
// contact bond once it is broken; it overlaps by -(L - L0 + slack).
//
// Discs belong to blocks of consecutive numbers, pairs to the block of their first disc, so that threads
// share the blocks: what a pair does to a disc of another block waits in `away` until that block gathers it,
// in a fixed order.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/bond_state.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

inline constexpr std::uint32_t kBlock = 1024;  // discs
inline constexpr std::uint32_t kChunk = 128;   // pairs that are computed at a time

inline std::size_t blocks_of(std::size_t discs) {
  return (discs + kBlock - 1) / kBlock;
}

// Of a width in metres, stiffnesses are in Pa/m and strengths in Pa; of the width 1 of contact bonds in N/m
// and N.
struct PairLaw {
  double kn = 0, ks = 0, km = 0;
  double tensile_strength = std::numeric_limits<double>::infinity();
  double bending = 0;  // b
  double cohesion = std::numeric_limits<double>::infinity();
  double tan_friction_angle = 0;
  bool beside = false;  // the contact acts beside the whole cement
  LinearContact contact{};
  bool operator==(const PairLaw&) const = default;
};

struct Pairs {
  std::vector<std::uint32_t> first, second, law;      // ascending by first, then by second
  std::vector<double> rest_x, rest_y;                 // from first to second at rest [m]
  std::vector<double> rest_length;                    // L0 [m]
  std::vector<double> half_difference;                // of the radii [m]
  std::vector<double> slack;                          // [m]
  std::vector<double> width;                          // w of the cement; empty: none
  std::vector<double> weight;                         // energy weight
  std::vector<double> slide;                          // shear force of the contact's spring [N]
  std::vector<double> normal_dashpot, shear_dashpot;  // forces [N]; empty: none
  std::vector<double> initial, shear, moment;         // of the cement: N0, S, M; empty: none
  std::vector<BondState> state;                       // of the cement; empty: none
  std::size_t size() const { return first.size(); }
  bool cemented() const { return !state.empty(); }

  // Consecutive pairs of one block. Varied: all whole, of one law, without initial force and weight. Plain:
  // of one width besides, without slack.
  enum class Kind : std::uint8_t { kPlain, kVaried, kGeneral };
  struct Chunk {
    std::uint32_t begin, end;
    Kind kind = Kind::kGeneral;
    bool one_law = false;
  };
  std::vector<Chunk> chunks;
  std::vector<std::uint32_t> chunk_starts;  // of each block, and the end

  // Forces on second discs of other blocks: slots by block of the first; arrivals, by block of the second.
  struct Arrival {
    std::uint32_t slot, disc;
  };
  std::vector<double> away_x, away_y, away_moment;
  std::vector<std::uint32_t> away_starts, arrival_starts;
  std::vector<Arrival> arrivals;

  // Makes room for the pairs' states and sorts them into blocks, once first and second are known.
  void finish(std::size_t discs, bool cement, bool dashpots);
  // Finds of which kind the chunks are.
  void sort_chunks();
};

}  // namespace adit::dem
