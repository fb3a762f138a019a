// How fast the continuum steps: zone-steps per second of a block of equal elastic zones, beside the bandwidth
// of the machine measured in turn with it. Prints one JSON object a line.
//
//   continuum ZONES_X ZONES_Y THREADS
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;

constexpr double kDensity = 2500;
// A zone-step reads and writes u and v of one point and reads its inverse masses, once each.
constexpr double kTraffic = (4 + 4 + 2) * sizeof(double);

struct Ground {
  std::size_t threads;
  fdm::Continuum continuum;
  double dt;
  std::uint64_t next = 1;

  Ground(fdm::ZoneKind kind, const fdm::Grid& grid, std::size_t threads)
      : threads(threads),
        continuum(fdm::ZoneSet(kind, grid, law(), ones(grid)), fdm::lumped_masses(grid, ones(grid), kDensity),
                  {}, {}, threads),
        dt(0.8 * fdm::critical_step(kind, grid, law(), kDensity)) {
    continuum.step({0, dt});
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      continuum.vx()[i] = 1e-3 * std::sin(grid.x[i] + 0.3 * grid.y[i]);
      continuum.vy()[i] = 1e-3 * std::cos(0.7 * grid.x[i] - grid.y[i]);
    }
  }
  static fdm::PlaneLaw law() { return fdm::plane_strain(25e9, 0.2); }
  static std::vector<double> ones(const fdm::Grid& grid) {
    return std::vector<double>(grid.zones.size(), 1.0);
  }
  double seconds_a_step(int steps) {
    const double total = bench::seconds(threads, [&] {
      for (int i = 0; i < steps; ++i) continuum.step({next++, dt});
    });
    return total / steps;
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: continuum ZONES_X ZONES_Y THREADS\n");
    return 2;
  }
  const auto nx = static_cast<std::uint32_t>(std::atoi(argv[1])),
             ny = static_cast<std::uint32_t>(std::atoi(argv[2]));
  const auto threads = static_cast<std::size_t>(std::atoi(argv[3]));
  const fdm::Grid grid = fdm::make_grid({0, 0.5 * nx, 0, 0.25 * ny, nx, ny});
  const double zones = static_cast<double>(nx) * ny;
  for (const auto kind : {fdm::ZoneKind::kAssumedStrain, fdm::ZoneKind::kMixedDiscretization}) {
    Ground ground(kind, grid, threads);
    bench::Triad triad(kTraffic * zones, threads);
    const auto [step, pass] = bench::least([&](int steps) { return ground.seconds_a_step(steps); },
                                           [&](int passes) { return triad.seconds_a_pass(passes); });
    std::printf(
        "{\"kind\": \"%s\", \"zones\": %.0f, \"threads\": %zu, \"zone_steps_per_s\": %.6g, "
        "\"bytes_per_zone\": %.0f, \"triad_bytes_per_s\": %.6g}\n",
        kind == fdm::ZoneKind::kAssumedStrain ? "assumed strain" : "mixed discretization", zones, threads,
        zones / step, kTraffic, triad.bytes() / pass);
    std::fflush(stdout);
  }
  return 0;
}
