// The order in which a step takes particles and bonds: one way through memory, shared by threads.
//
// A bond needs its particles moved; a particle is complete once the last of its bonds has pulled on it. So
// bonds are taken in beats of a hundred or two: move the particles that a beat is the first to need, add its
// forces, predict the velocities of the particles that it is the last to pull on. Resultants live in a buffer
// in the cache, never in memory.
//
// Beats belong to blocks of consecutive particles, fixed by the model and not by the number of threads. Bonds
// between two blocks, their seam, are taken after both. Particles are numbered so that bonds join near
// numbers, and blocks are so large that no particle has a part in two seams: results are the same to the bit
// whoever computed what.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/engines/lattice/bond_forces.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

// What a sweep does with a particle that its bonds pull on.
enum class Role : std::uint8_t {
  kForeign,  // adds to the resultants; another sweep predicts it
  kKept,     // adds to the resultants, for predict() to take with what else is added there
  kSwept,    // predicts it at once: nothing else pulls on it
};

class Sweep {
 public:
  Sweep() = default;
  // `roles` and `moved`, whether this sweep moves it: of every particle.
  Sweep(std::span<const Run> runs, std::span<const Role> roles, const std::vector<bool>& moved,
        std::size_t threads);

  // Moves by dt v, unless the step starts from rest, and sets the resultants of what it moves to those of the
  // bonds; adds to those of others, and the weight to those of kept ones. Predicts the swept particles.
  // `result` grows to that of all bonds of the step so far; bonds that broke are appended to `broken`,
  // ascending. Returns the largest speed of what it moved [m/s].
  double run(protocol::Team& team, const ContactBond& law, const protocol::Step& step, Assembly& assembly,
             BondResult& result, std::vector<std::uint32_t>& broken);
  // Predicts the kept particles from their resultants.
  void predict(protocol::Team& team, const protocol::Step& step, Particles& particles) const;

 private:
  using IndexRanges = std::vector<protocol::IndexRange>;
  struct Beat {
    std::vector<Run> runs;
    IndexRanges moved, swept;
  };
  struct Block {
    protocol::IndexRange particles;
    std::vector<Beat> beats;
    IndexRanges cleared, left;  // left: what beats pull on whose resultants go to memory
    IndexRanges kept;
    // with the next block
    std::vector<Run> seam;
    IndexRanges seam_swept;
  };
  struct Outcome {
    BondResult contacts;
    std::vector<std::uint32_t> broken;
    double fastest = 0;  // speed squared
  };

  struct Buffer {
    std::vector<double> fx, fy, moment;
  };

  void lay_out(std::span<const Run> runs, std::uint32_t particles);
  void deal(std::span<const Run> runs);
  static void set_beats(std::vector<Run> runs, Block& block);
  void run_block(const Block& block, Buffer& buffer, const ContactBond& law, const protocol::Step& step,
                 Assembly& assembly, Outcome& outcome) const;
  void run_seam(const Block& block, const ContactBond& law, const protocol::Step& step, Assembly& assembly,
                Outcome& outcome) const;

  std::vector<Block> blocks_;
  std::vector<Outcome> outcomes_;  // of the blocks, then of the seams
  std::vector<Buffer> buffers_;    // of each thread: resultants of the block in work
};

}  // namespace adit::dem
