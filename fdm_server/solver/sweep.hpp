// The order in which a step takes zones and points: one way through memory, shared by threads.
//
// A zone needs its points moved; a point is complete once the last of its zones has pulled on it. So zones
// are taken in blocks of some rows: move the points that a block is the first to meet, add its forces,
// predict the velocities of the points that it is the last to pull on. Forces live in a buffer in the cache,
// never in memory.
//
// Blocks belong to chunks, fixed by the grid and not by the number of threads. A point of several chunks is
// moved before all of them, and gets their forces, in their order, after them: results are the same to the
// bit whoever computed what.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/zones/zone_set.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"
#include "protocol/threads/team.hpp"

namespace adit::fdm {

class Damping;

// One value a point: displacements, velocities, forces for others to add to, masses; steady forces,
// which every point gets beside those of its zones, null where there are none.
struct PointArrays {
  double *ux, *uy, *vx, *vy, *fx, *fy;
  const double *mass, *inverse_mass_x, *inverse_mass_y;
  const double *steady_x, *steady_y;
  // Local damping of statics (protocol/participant/local_damping.hpp): its share, and the forces of the ties.
  double damping = 0;
  const double *tie_x = nullptr, *tie_y = nullptr;
};

// What a sweep does with a point, if its zones pull on it.
enum class Role : std::uint8_t {
  kForeign,  // adds the forces to fx, fy; another sweep predicts it
  kKept,     // adds the forces to fx, fy, for predict() to take with what else is added there
  kSwept,    // predicts it at once: nothing else pulls on it
};

// How many threads of this machine are worth calling for a grid of so many zones.
std::size_t useful_threads(std::size_t zones);

class Sweep {
 public:
  Sweep() = default;
  // `roles` and `moved`, whether this sweep moves it: of every point of the grid. No swept point is without
  // zones.
  Sweep(std::span<const ZoneRun> runs, std::span<const Role> roles, const std::vector<bool>& moved,
        std::size_t threads);
  Sweep(Sweep&&) = default;
  Sweep& operator=(Sweep&&) = default;

  // Moves by dt v, then adds the zones' forces, damps and predicts the swept points: v += kick f/m. Returns
  // what the damping of the material took there [J].
  double run(protocol::Team& team, ZoneSet& zones, const protocol::Step& step, const PointArrays& points,
             Damping& damping);
  // Predicts the kept points, and empties their fx, fy.
  void predict(protocol::Team& team, double kick, const PointArrays& points) const;

 private:
  using IndexRanges = std::vector<protocol::IndexRange>;
  struct Survey;
  struct Block {
    std::span<const ZoneRun> runs;
    IndexRanges moved, swept, left;  // left: forces go to fx, fy
  };
  // Points of several chunks, and where their forces from one of these wait.
  struct Shared {
    protocol::IndexRange points;
    std::size_t place;
  };
  struct Chunk {
    std::uint32_t first_point = 0;  // in the buffer
    std::vector<Block> blocks;
    std::vector<Shared> shared;
    // of the points that no earlier chunk has: those to move before all chunks, forces to be summed after
    // them, then to be predicted; and those that are kept
    IndexRanges moved;
    std::vector<Shared> sums;
    IndexRanges swept, kept;
  };
  struct Buffer {
    std::vector<double> x, y;
    void hold(std::size_t size) {
      if (size <= x.size()) return;
      x.resize(size, 0.0);
      y.resize(size, 0.0);
    }
  };

  void fill(std::uint32_t number, std::span<const ZoneRun> runs, std::span<const Role> roles,
            const std::vector<bool>& moved, Survey& survey);
  void share(std::uint32_t chunk, std::uint32_t first, std::uint32_t point);
  double compute(const Chunk& chunk, Buffer& buffer, ZoneSet& zones, const protocol::Step& step,
                 const PointArrays& points, Damping& damping);

  bool streamed_ = false;  // more points than caches hold
  std::vector<ZoneRun> runs_;
  std::vector<Chunk> chunks_;
  std::vector<Buffer> buffers_;  // of each thread: forces of the chunk in work
  Buffer waiting_;               // forces at points of several chunks
  std::vector<double> damped_;   // in each chunk [J]
};

}  // namespace adit::fdm
