// How fast the continuum steps: zone-steps per second of a block of equal elastic zones, beside the bandwidth
// of the machine measured in turn with it. Prints one JSON object a line.
//
//   continuum ZONES_X ZONES_Y THREADS
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "protocol/team.hpp"

namespace {

using namespace adit;

constexpr double kDensity = 2500;
constexpr double kWindow = 5e-4, kBudget = 3;  // s
// A zone-step reads and writes u and v of one point and reads its inverse masses, once each.
constexpr double kTraffic = (4 + 4 + 2) * sizeof(double);

double seconds(auto&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// STREAM's triad a = b + s c: bytes per second over arrays of so many bytes in all.
class Triad {
 public:
  Triad(double bytes, std::size_t threads)
      : team_(threads),
        a_(static_cast<std::size_t>(bytes / 24), 0.0),
        b_(a_.size(), 1.0),
        c_(a_.size(), 2.0) {}
  double seconds_a_pass(int passes) {
    const std::size_t parts = team_.threads();
    const double total = seconds([&] {
      for (int pass = 0; pass < passes; ++pass)
        team_.run(parts, [&](std::size_t part, std::size_t) {
          double *a = a_.data(), *b = b_.data(), *c = c_.data();
          const std::size_t end = a_.size() * (part + 1) / parts;
#pragma GCC ivdep
          for (std::size_t i = a_.size() * part / parts; i < end; ++i) a[i] = b[i] + 3.0 * c[i];
        });
    });
    return total / passes;
  }
  double bytes() const {
    return 24.0 * static_cast<double>(a_.size());
  }

 private:
  protocol::Team team_;
  std::vector<double> a_, b_, c_;
};

struct Ground {
  fdm::Continuum continuum;
  double dt;
  std::uint64_t next = 1;

  Ground(fdm::ZoneKind kind, const fdm::Grid& grid, std::size_t threads)
      : continuum(fdm::make_zones(kind, grid, law(), ones(grid)),
                  fdm::lumped_masses(grid, ones(grid), kDensity), {}, {}, threads),
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
    const double total = seconds([&] {
      for (int i = 0; i < steps; ++i) continuum.step({next++, dt});
    });
    return total / steps;
  }
};

// The least time of each, measured in turn in windows so short that many of them pass undisturbed on a
// machine with other work.
std::array<double, 2> least(auto&& first, auto&& second) {
  std::array<double, 2> result{first(3), second(3)};
  for (double spent = 0; spent < kBudget;) {
    const auto measure = [&](auto&& work, double& best) {
      const int count = std::max(1, static_cast<int>(kWindow / best));
      const double mean = work(count);
      best = std::min(best, mean);
      spent += mean * count;
    };
    measure(first, result[0]);
    measure(second, result[1]);
  }
  return result;
}

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
    Triad triad(kTraffic * zones, threads);
    const auto [step, pass] = least([&](int steps) { return ground.seconds_a_step(steps); },
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
