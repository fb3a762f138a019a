// How fast bonded particles step: bond-steps per second of a beam of touching discs with contact bonds, spins
// and contact detection, beside what the machine allows, measured in turn with it. Prints one JSON object.
//
//   particles DISCS ROWS THREADS
#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "dem_server/contacts.hpp"
#include "dem_server/critical_step.hpp"
#include "dem_server/sweep.hpp"
#include "protocol/vector_clones.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;

// A step reads and writes displacement, velocity and spin of a particle and the shear force of a bond, and
// reads inverse mass and inertia, once each.
constexpr double kBytesOfParticle = (2 * 5 + 2) * sizeof(double), kBytesOfBond = 2 * sizeof(double);
// Sums and products of a bond-step: the law, what it adds to its two particles, and a third of their motion.
constexpr double kOperations = 40 + 6 + 9;

double heap_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Beam {
  dem::Assembly assembly;
  dem::Contacts contacts;
  dem::Sweep sweep;
  protocol::Team team;
  dem::BondLaw law{
      {1.8e10, 6e9}, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double dt;
  std::uint64_t next = 1;
  std::vector<std::uint32_t> broken;

  Beam(std::uint32_t discs, std::uint32_t rows, std::size_t threads)
      : assembly(dem::assemble(
            dem::pack_hexagonally({0, 1.0 * discs, 0, std::numbers::sqrt3 / 2 * rows}, 0.5), 2000)),
        contacts(assembly),
        sweep(assembly.bonds.runs, std::vector(assembly.particles.size(), dem::Role::kSwept),
              std::vector<bool>(assembly.particles.size(), true), threads),
        team(threads),
        dt(0.5 * dem::critical_step(assembly, law.stiffness)) {
    dem::Particles& p = assembly.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = 1e-3 * std::sin(p.x[i] + 0.3 * p.y[i]);
      p.vy[i] = 1e-3 * std::cos(0.7 * p.x[i] - p.y[i]);
    }
  }
  double seconds_a_step(int steps) {
    const double total = bench::seconds(team.threads(), [&] {
      for (int i = 0; i < steps; ++i) {
        const protocol::Step step{next++, dt};
        dem::ContactResult result;
        contacts.update(dt, assembly);
        contacts.moved(dt, sweep.run(team, law, step, assembly, result, broken));
        sweep.predict(team, step.kick(), assembly.particles);
      }
    });
    return total / steps;
  }
};

constexpr std::size_t kInCache = 1024;

// One square root and one division a bond: what the divider allows, however the rest is done.
ADIT_VECTOR_CLONES void divide(const double* __restrict from, double* __restrict to) {
  for (std::size_t i = 0; i < kInCache; ++i) to[i] = 1 / std::sqrt(from[i]);
}

// Eight independent sums of products for each number.
constexpr int kFlops = 16;
ADIT_VECTOR_CLONES void multiply(const double* __restrict from, double* __restrict to) {
  for (std::size_t i = 0; i < kInCache; ++i) {
    const double x = from[i];
    const double a = x * 1.1 + 0.1, b = x * 1.2 + 0.2, c = x * 1.3 + 0.3, d = x * 1.4 + 0.4;
    const double e = x * 1.5 + 0.5, f = x * 1.6 + 0.6, g = x * 1.7 + 0.7;
    to[i] = ((a * b + c) + (d * e + f)) * g;
  }
}

double seconds_a_pass(void (*pass)(const double*, double*), int passes) {
  static const std::vector<double> from(kInCache, 1.5);
  static std::vector<double> to(kInCache);
  return bench::seconds(1,
                        [&] {
                          for (int i = 0; i < passes; ++i) pass(from.data(), to.data());
                        }) /
         passes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: particles DISCS ROWS THREADS\n");
    return 2;
  }
  const auto discs = static_cast<std::uint32_t>(std::atoi(argv[1])),
             rows = static_cast<std::uint32_t>(std::atoi(argv[2]));
  const auto threads = static_cast<std::size_t>(std::atoi(argv[3]));
  const double empty = heap_bytes();
  Beam beam(discs, rows, threads);
  const double held = heap_bytes() - empty;
  const auto particles = static_cast<double>(beam.assembly.particles.size()),
             bonds = static_cast<double>(beam.assembly.bonds.size());
  const double traffic = particles * kBytesOfParticle + bonds * kBytesOfBond;
  bench::Triad triad(traffic, threads);
  const auto [step, triad_pass, division, product] =
      bench::least([&](int count) { return beam.seconds_a_step(count); },
                   [&](int count) { return triad.seconds_a_pass(count); },
                   [](int count) { return seconds_a_pass(divide, count); },
                   [](int count) { return seconds_a_pass(multiply, count); });
  const double of_all = static_cast<double>(threads * kInCache);
  std::printf(
      "{\"particles\": %.0f, \"bonds\": %.0f, \"threads\": %zu, \"steps_per_s\": %.6g, \"bytes_held\": %.6g, "
      "\"traffic_per_step\": %.6g, \"triad_bytes_per_s\": %.6g, \"divisions_per_s\": %.6g, "
      "\"operations_per_bond\": %.0f, \"operations_per_s\": %.6g}\n",
      particles, bonds, threads, 1 / step, held, traffic, triad.bytes() / triad_pass, of_all / division,
      kOperations, of_all * kFlops / product);
  return 0;
}
