// How fast bonded particles step: bond-steps per second of a beam of touching discs with bonds, spins and
// contact detection, beside what the machine allows, measured in turn with it. Prints one JSON object.
//
//   particles KIND DISCS ROWS THREADS
//
// KIND: lattice, equal discs with contact bonds; contact_bonds and parallel_bonds, discs of any size.
#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>

#include "dem_server/engines/general/arrange.hpp"
#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/engines/lattice/contacts.hpp"
#include "dem_server/engines/lattice/critical_step.hpp"
#include "dem_server/engines/lattice/sweep.hpp"
#include "protocol/threads/vector_clones.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;

constexpr double kUnbreakable = std::numeric_limits<double>::infinity();
constexpr double kNormal = 1.8e10, kShear = 6e9, kCellMass = 2000, kRadius = 0.5;

// What a step must read and write, once each, and the sums and products of a bond-step: the law, what it adds
// to its two particles, and a third of their motion.
struct Costs {
  double bytes_of_particle, bytes_of_bond, operations;
};
// Displacement, velocity and spin, read and written, inverse mass and inertia; the bond's shear force.
constexpr Costs kLattice{12.0 * sizeof(double), 2 * sizeof(double), 40 + 6 + 9};
// Also resultants of bonds and of all; the bond's discs and law, shape at rest, shear force and moment, and
// beside parallel bonds the contact's force.
constexpr double kBytesOfDisc = kLattice.bytes_of_particle + 12.0 * sizeof(double);
constexpr double kBytesOfShape = 3 * sizeof(std::uint32_t) + 4 * sizeof(double);
constexpr Costs kContactBonds{kBytesOfDisc, kBytesOfShape + 4 * sizeof(double), 49 + 8 + 9};
constexpr Costs kParallelBonds{kBytesOfDisc, kBytesOfShape + 6 * sizeof(double), 73 + 8 + 9};

dem::Packing packed(std::uint32_t discs, std::uint32_t rows) {
  return dem::pack_hexagonally({0, 1.0 * discs, 0, std::numbers::sqrt3 / 2 * rows}, kRadius);
}

void stir(dem::Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 1e-3 * std::sin(p.x[i] + 0.3 * p.y[i]);
    p.vy[i] = 1e-3 * std::cos(0.7 * p.x[i] - p.y[i]);
  }
}

double heap_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Lattice {
  dem::Assembly assembly;
  dem::Contacts contacts;
  dem::Sweep sweep;
  protocol::Team team;
  dem::BondLaw law{{kNormal, kShear}, kUnbreakable, kUnbreakable};
  double dt;
  std::uint64_t next = 1;
  std::vector<std::uint32_t> broken;

  Lattice(const dem::Packing& packing, std::size_t threads)
      : assembly(dem::assemble(packing, kCellMass)),
        contacts(assembly),
        sweep(assembly.bonds.runs, std::vector(assembly.particles.size(), dem::Role::kSwept),
              std::vector<bool>(assembly.particles.size(), true), threads),
        team(threads),
        dt(0.5 * dem::critical_step(assembly, law.stiffness)) {
    stir(assembly.particles);
  }
  void step() {
    const protocol::Step step{next++, dt};
    dem::ContactResult result;
    contacts.update(dt, assembly);
    contacts.moved(dt, sweep.run(team, law, step, assembly, result, broken));
    sweep.predict(team, step.kick(), assembly.particles);
  }
};

dem::Model model_of(const dem::Packing& packing, bool parallel) {
  dem::Model model;
  const std::size_t size = packing.x.size();
  model.discs = {packing.x, packing.y, std::vector(size, kRadius)};
  model.mass.assign(size, kCellMass);
  model.inertia.assign(size, kCellMass * kRadius * kRadius / 2);
  model.group.assign(size, 0);
  model.group_names = {""};
  model.contacts = {{kNormal, kShear, 0.5}};
  model.contact_bonds = {{kNormal, kShear, kUnbreakable, kUnbreakable}};
  model.parallel_bonds = {{kNormal, kShear, kRadius, kUnbreakable, kUnbreakable, 0}};
  for (const dem::Link& link : packing.links)
    model.joined.push_back({std::min(link.first, link.second), std::max(link.first, link.second),
                            parallel ? dem::Joined::Law::kParallelBond : dem::Joined::Law::kContactBond, 0});
  dem::arrange(model);
  return model;
}

struct Discs {
  double dt;
  dem::Solver solver;
  dem::Motions motions;
  std::uint64_t next = 1;

  Discs(const dem::Model& model, std::size_t threads)
      : dt(0.5 * dem::critical_step(model)), solver(model, threads) {
    stir(solver.particles());
  }
  void step() { solver.step({next++, dt}, {}, motions); }
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

template <class Beam, class Description>
void measure(const Description& description, double particles, double bonds, const Costs& costs,
             std::size_t threads) {
  const double empty = heap_bytes();
  Beam beam(description, threads);
  const double held = heap_bytes() - empty;
  const double traffic = particles * costs.bytes_of_particle + bonds * costs.bytes_of_bond;
  bench::Triad triad(traffic, threads);
  const auto [step, triad_pass, division, product] = bench::least(
      [&](int count) {
        return bench::seconds(threads,
                              [&] {
                                for (int i = 0; i < count; ++i) beam.step();
                              }) /
               count;
      },
      [&](int count) { return triad.seconds_a_pass(count); },
      [](int count) { return seconds_a_pass(divide, count); },
      [](int count) { return seconds_a_pass(multiply, count); });
  const double of_all = static_cast<double>(threads * kInCache);
  std::printf(
      "{\"particles\": %.0f, \"bonds\": %.0f, \"threads\": %zu, \"steps_per_s\": %.6g, \"bytes_held\": %.6g, "
      "\"traffic_per_step\": %.6g, \"triad_bytes_per_s\": %.6g, \"divisions_per_s\": %.6g, "
      "\"operations_per_bond\": %.0f, \"operations_per_s\": %.6g}\n",
      particles, bonds, threads, 1 / step, held, traffic, triad.bytes() / triad_pass, of_all / division,
      costs.operations, of_all * kFlops / product);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc == 5 ? argv[1] : "";
  const bool parallel = kind == "parallel_bonds";
  if (kind != "lattice" && kind != "contact_bonds" && !parallel) {
    std::fprintf(stderr, "usage: particles lattice|contact_bonds|parallel_bonds DISCS ROWS THREADS\n");
    return 2;
  }
  const auto number = [argv](int k) { return static_cast<std::uint32_t>(std::atoi(argv[k])); };
  const dem::Packing packing = packed(number(2), number(3));
  const auto particles = static_cast<double>(packing.x.size()),
             bonds = static_cast<double>(packing.links.size());
  if (kind == "lattice")
    measure<Lattice>(packing, particles, bonds, kLattice, number(4));
  else
    measure<Discs>(model_of(packing, parallel), particles, bonds, parallel ? kParallelBonds : kContactBonds,
                   number(4));
  return 0;
}
