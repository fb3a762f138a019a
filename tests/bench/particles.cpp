// How fast bonded particles step: bond-steps per second of a beam of touching discs with bonds, spins and
// contact detection, beside what the machine allows, measured in turn with it. Prints one JSON object.
//
//   particles KIND DISCS ROWS THREADS [FILE]
//
// KIND: lattice, the engine of equal discs with contact bonds; contact_bonds and parallel_bonds, the general
// one; cells, the general one with cells joined over facets, which are its bonds; packing, the general one
// with discs of many sizes that press each other between walls, with friction and without bonds, so that they
// stay in contact: FILE then gets a line for each disc, x y radius mass.
#include <malloc.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/model/lattice.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/packing/random/pressed_discs.hpp"
#include "dem_server/packing/regular.hpp"
#include "protocol/motion/random.hpp"
#include "protocol/threads/vector_clones.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;

constexpr double kNormal = 1.8e10, kShear = 6e9, kCellMass = 2000, kRadius = 0.5;

// What a step must read and write, once each, and the sums and products of a bond-step: the law, what it adds
// to its two particles, and a third of their motion.
struct Costs {
  double bytes_of_particle, bytes_of_bond, operations;
};
// Displacement, velocity and spin, read and written, inverse mass and inertia; the bond's shear force.
constexpr Costs kLattice{12.0 * sizeof(double), 2 * sizeof(double), 40 + 6 + 9};
// Also places at rest, resultants, read and written, and whether the disc is swept; the bond's discs, length
// at rest, difference of the radii and shear force, and for parallel bonds the moment and the force of the
// contact beside.
constexpr double kBytesOfDisc = kLattice.bytes_of_particle + 8.0 * sizeof(double) + sizeof(std::uint8_t);
constexpr double kBytesOfShape = 2 * sizeof(std::uint32_t) + 2 * sizeof(double);
constexpr Costs kContactBonds{kBytesOfDisc, kBytesOfShape + 2 * sizeof(double), 49 + 8 + 9};
constexpr Costs kParallelBonds{kBytesOfDisc, kBytesOfShape + 6 * sizeof(double), 73 + 8 + 9};
// Its place at rest is not asked for; turn, sine and versine, bulk and pressure, read and written. The
// facet's cells, normal, half distance, skew, length and stiffness.
constexpr Costs kFacets{kBytesOfDisc + 6.0 * sizeof(double), 2 * sizeof(std::uint32_t) + 6 * sizeof(double),
                        75 + 60 + 8 + 9};
constexpr Costs kContacts{kBytesOfDisc, kBytesOfShape + 2 * sizeof(double), 49 + 8 + 9};

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

// A beam of touching discs: contact bonds with contacts without friction, or parallel bonds beside contacts
// with friction.
dem::Model beam_of(const std::string& kind, std::uint32_t discs, std::uint32_t rows) {
  const double height = std::numbers::sqrt3 / 2 * rows;
  dem::HexagonalLattice lattice = dem::pack_hexagonally({0, 1.0 * discs, 0, height}, kRadius);
  const bool parallel = kind == "parallel_bonds";
  dem::Model model;
  const std::size_t size = lattice.discs.size();
  model.discs = std::move(lattice.discs);
  model.extent = lattice.cells;
  model.mass.assign(size, kCellMass);
  model.weight.assign(size, 1);
  model.group.assign(size, 0);
  for (std::uint32_t i = 0; i < size; ++i) model.id.push_back(i);
  model.contacts = {{kNormal, kShear, kind == "lattice" ? 0 : 0.5}};
  model.contact_bonds = {{{kNormal, kShear}}};
  model.parallel_bonds = {{kNormal, kShear, kRadius, dem::kUnbreakable, dem::kUnbreakable, 0}};
  const auto law = parallel ? dem::Bond::Law::kParallelBond : dem::Bond::Law::kContactBond;
  for (const dem::Pair& pair : dem::pairs_within(model.discs, 1e-6 * kRadius))
    model.bonds.push_back({pair.first, pair.second, law, 0});
  dem::sort_by_rows(model);
  return model;
}

// A beam of the same size by cells of concrete's ratio of strengths, which do not break.
dem::Model cells_of(std::uint32_t discs, std::uint32_t rows) {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_time()->set_duration(1);
  scene::Material& material = *scene.mutable_material();
  material.set_young_modulus(kNormal);
  material.set_poisson_ratio(0.2);
  material.set_density(kCellMass);
  material.mutable_fracture()->set_tensile_strength(1e-4 * kNormal);
  material.mutable_fracture()->set_compressive_strength(1e-3 * kNormal);
  material.mutable_fracture()->set_fracture_energy(1e-4 * kNormal);
  scene::CellPacking& cells = *scene.mutable_particles()->mutable_cells();
  cells.set_x_max(1.0 * discs);
  cells.set_y_max(std::numbers::sqrt3 / 2 * rows);
  cells.set_size(2 * kRadius);
  cells.set_seed(1);
  return dem::read_model(scene);
}

constexpr double kPressed = 1e-3;  // stress of the packing, over the normal stiffness

// Discs that press each other and the walls of their box, at rest without friction.
dem::Discs pressed(const geometry::BoundingBox& box, std::uint32_t discs, std::uint32_t rows) {
  dem::Discs packed;
  motion::Random random(1);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t k = 0; k < discs; ++k) {
      packed.x.push_back(k + 0.45 + 0.1 * random.uniform());
      packed.y.push_back((row + 0.5) * box.y_max / rows);
      packed.radius.push_back(kRadius * (0.6 + 0.35 * random.uniform()));
    }
  protocol::Team team;
  dem::PressedDiscs growing(packed, box, team);
  growing.relax(1e-3, 300);
  while (growing.wall_stress()[0] < kPressed) {
    growing.scale_radii(1.003);
    growing.relax(1e-3, 300);
  }
  growing.relax(1e-3, 3000);
  return growing.discs();
}

dem::Model packing_of(std::uint32_t discs, std::uint32_t rows) {
  const geometry::BoundingBox box{0, 1.0 * discs, 0, std::numbers::sqrt3 / 2 * rows};
  const dem::LinearContact contact{kNormal, kShear, 0.5};
  dem::Model model;
  model.discs = pressed(box, discs, rows);
  model.extent = box;
  for (const double radius : model.discs.radius) {
    model.mass.push_back(kCellMass * radius * radius / (kRadius * kRadius));
    model.id.push_back(static_cast<std::uint32_t>(model.id.size()));
  }
  model.weight.assign(model.mass.size(), 1);
  model.group.assign(model.mass.size(), 0);
  model.contacts = {contact};
  model.overlaps_free = false;
  const auto stands = [](double) { return 0.0; };
  for (const auto& [x_1, y_1, x_2, y_2] :
       {std::array{0.0, 0.0, box.x_max, 0.0}, std::array{box.x_max, 0.0, box.x_max, box.y_max},
        std::array{box.x_max, box.y_max, 0.0, box.y_max}, std::array{0.0, box.y_max, 0.0, 0.0}})
    model.walls.push_back({"wall", x_1, y_1, x_2, y_2, contact, 0, 0, stands});
  return model;
}

void write(const dem::Model& model, const char* path) {
  std::FILE* file = std::fopen(path, "w");
  for (std::size_t i = 0; i < model.mass.size(); ++i)
    std::fprintf(file, "%.17g %.17g %.17g %.17g\n", model.discs.x[i], model.discs.y[i], model.discs.radius[i],
                 model.mass[i]);
  std::fclose(file);
}

struct Beam {
  std::unique_ptr<dem::LocalEngine> engine;
  double dt;
  std::uint64_t next = 1;

  Beam(const dem::Model& model, bool lattice, std::size_t threads) {
    if (lattice)
      engine = std::make_unique<dem::LatticeEngine>(model, threads);
    else
      engine = std::make_unique<dem::GeneralEngine>(model, threads);
    dt = 0.5 * engine->critical_step();
    if (!model.bonds.empty()) stir(engine->particles());  // a packing stays as it is pressed
  }
  std::size_t contacts() const {
    std::size_t count = 0;
    engine->for_each_contact([&](const dem::ObservedPair&) { ++count; });
    return count;
  }
  void step() {
    const protocol::Step step{next++, dt};
    engine->prepare(false);
    engine->step_interface(step);
    engine->step_interior(step);
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

void measure(const dem::Model& model, bool lattice, const Costs& costs, std::size_t threads) {
  const auto particles = static_cast<double>(model.discs.size());
  const double empty = heap_bytes();
  Beam beam(model, lattice, threads);
  const double held = heap_bytes() - empty;
  const std::size_t touching = beam.contacts();
  const auto bonds = static_cast<double>(model.bonds.empty() ? touching : model.bonds.size());
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
      "\"operations_per_bond\": %.0f, \"operations_per_s\": %.6g, \"contacts\": [%zu, %zu]}\n",
      particles, bonds, threads, 1 / step, held, traffic, triad.bytes() / triad_pass, of_all / division,
      costs.operations, of_all * kFlops / product, touching, beam.contacts());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc >= 5 ? argv[1] : "";
  const std::map<std::string, Costs> costs{{"lattice", kLattice},
                                           {"contact_bonds", kContactBonds},
                                           {"parallel_bonds", kParallelBonds},
                                           {"cells", kFacets},
                                           {"packing", kContacts}};
  if (!costs.contains(kind)) {
    std::fprintf(
        stderr,
        "usage: particles lattice|contact_bonds|parallel_bonds|cells|packing DISCS ROWS THREADS [FILE]\n");
    return 2;
  }
  const auto number = [argv](int k) { return static_cast<std::uint32_t>(std::atoi(argv[k])); };
  const dem::Model model = kind == "packing" ? packing_of(number(2), number(3))
                           : kind == "cells" ? cells_of(number(2), number(3))
                                             : beam_of(kind, number(2), number(3));
  if (argc > 5) write(model, argv[5]);
  measure(model, kind == "lattice", costs.at(kind), number(4));
  return 0;
}
