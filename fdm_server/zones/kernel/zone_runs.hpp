// How zones are laid out for the kernels. A run is a row of consecutive zones of one shape whose four point
// numbers all grow by one: their data are then contiguous, and the loop over them is vectorized without
// gathering. A grid without any order has runs of one zone.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

struct ZoneRun {
  std::uint32_t first;  // zone
  std::uint32_t count;
  std::uint32_t shape;     // number of the shape
  ZonePoints points;       // of the first zone
  std::uint32_t part = 0;  // which of the kernels computes it (zone_set.hpp)
};

struct ZoneLayout {
  std::vector<Corners> shapes;  // zones that differ by a translation only share one
  std::vector<ZoneRun> runs;    // cover the zones in their order
};

ZoneLayout lay_out(const Grid& grid);

// Runs whose zones all touch a chosen point, and runs of which none does.
struct SplitRuns {
  std::vector<ZoneRun> touching, others;
};
SplitRuns split(std::span<const ZoneRun> runs, const std::vector<bool>& chosen);

// The runs without the zones whose flag is set.
std::vector<ZoneRun> without(std::span<const ZoneRun> runs, const std::vector<bool>& zones);

// What the kernels read and add to, one value a grid point.
struct PointView {
  const double* vx;  // [m/s]
  const double* vy;
  double* fx;  // [N]
  double* fy;
};

// Forces of a batch of zones at their corners, kept in the first-level cache until they are added.
inline constexpr std::uint32_t kBatch = 64;
struct CornerForces {
  alignas(64) std::array<std::array<double, kBatch>, 4> x, y;
};

// Those of one zone at its corners [N].
struct ZoneForces {
  std::array<double, 4> x, y;
};
inline ZoneForces first_of(const CornerForces& forces) {
  ZoneForces first{};
  for (std::size_t c = 0; c < 4; ++c) {
    first.x[c] = forces.x[c][0];
    first.y[c] = forces.y[c][0];
  }
  return first;
}

// Adds the forces of zones `done` … `done + count` of the run, which begin at place `from`, to their points.
// Zones side by side share two points, which get the sum of both.
inline void scatter(const CornerForces& forces, std::uint32_t from, const ZoneRun& run, std::uint32_t done,
                    std::uint32_t count, const PointView& points) {
  const auto add = [count](const double* force, double* to) {
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < count; ++i) to[i] += force[i];
  };
  const auto add_pair = [count](const double* left, const double* right, double* to) {
    to[0] += left[0];
#pragma GCC ivdep
    for (std::uint32_t i = 1; i < count; ++i) to[i] += left[i] + right[i - 1];
    to[count] += right[count - 1];
  };
  for (const auto& [f, to] : {std::pair{&forces.x, points.fx + done}, std::pair{&forces.y, points.fy + done}})
    for (const auto& [left, right] : {std::pair{0, 1}, std::pair{3, 2}}) {
      const double *of_left = (*f)[left].data() + from, *of_right = (*f)[right].data() + from;
      if (run.points[right] == run.points[left] + 1) {
        add_pair(of_left, of_right, to + run.points[left]);
      } else {
        add(of_left, to + run.points[left]);
        add(of_right, to + run.points[right]);
      }
    }
}

// Takes the runs' zones batch by batch: batch(run, done, count, forces) fills the forces of zones `done` …
// `done` + `count` of the run, which are then added to their points.
template <class Batch>
void add_batches(std::span<const ZoneRun> runs, const PointView& points, Batch&& batch) {
  CornerForces forces;
  for (const auto& run : runs)
    for (std::uint32_t done = 0; done < run.count; done += kBatch) {
      const auto count = std::min(kBatch, run.count - done);
      batch(run, done, count, forces);
      scatter(forces, 0, run, done, count, points);
    }
}

}  // namespace adit::fdm
