// How fast discs of any size step: bond-steps per second of a beam with parallel bonds beside linear contacts
// with friction, spins, contact detection and the energy ledger. Prints one JSON object.
//
//   discs DISCS ROWS THREADS
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "dem_server/discs/arrange.hpp"
#include "dem_server/discs/critical_step.hpp"
#include "dem_server/discs/solver.hpp"
#include "dem_server/packing/hexagonal.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;

double heap_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

dem::Model beam(std::uint32_t discs, std::uint32_t rows) {
  constexpr double kRadius = 0.5, kMass = 2000;
  const dem::Packing packing =
      dem::pack_hexagonally({0, 1.0 * discs, 0, std::numbers::sqrt3 / 2 * rows}, kRadius);
  dem::Model model;
  model.discs = {packing.x, packing.y, std::vector(packing.x.size(), kRadius)};
  model.mass.assign(packing.x.size(), kMass);
  model.inertia.assign(packing.x.size(), kMass * kRadius * kRadius / 2);
  model.group.assign(packing.x.size(), 0);
  model.group_names = {""};
  model.contacts = {{1e10, 4e9, 0.5}};
  model.parallel_bonds = {{1e10, 4e9, kRadius, 1e9, 1e9, 0.5}};
  for (const dem::Link& link : packing.links)
    model.joined.push_back({link.first, link.second, dem::Joined::Law::kParallelBond, 0});
  arrange(model);
  return model;
}

struct Beam {
  dem::Solver solver;
  double dt;
  dem::Motions none;
  std::uint64_t next = 1;

  Beam(const dem::Model& model, std::size_t threads)
      : solver(model, threads), dt(0.5 * dem::critical_step(model)) {
    dem::Particles& p = solver.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = 1e-3 * std::sin(p.x[i] + 0.3 * p.y[i]);
      p.vy[i] = 1e-3 * std::cos(0.7 * p.x[i] - p.y[i]);
    }
  }
  double seconds_a_step(std::size_t threads, int steps) {
    const double total = bench::seconds(threads, [&] {
      for (int i = 0; i < steps; ++i) solver.step({next++, dt}, {}, none);
    });
    return total / steps;
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: discs DISCS ROWS THREADS\n");
    return 2;
  }
  const auto threads = static_cast<std::size_t>(std::atoi(argv[3]));
  const dem::Model model =
      beam(static_cast<std::uint32_t>(std::atoi(argv[1])), static_cast<std::uint32_t>(std::atoi(argv[2])));
  const double empty = heap_bytes();
  Beam run(model, threads);
  const double held = heap_bytes() - empty;
  const auto [step] = bench::least([&](int count) { return run.seconds_a_step(threads, count); });
  std::printf(
      "{\"particles\": %zu, \"bonds\": %zu, \"threads\": %zu, \"steps_per_s\": %.6g, \"bytes_held\": %.6g}\n",
      model.discs.size(), model.joined.size(), threads, 1 / step, held);
  return 0;
}
