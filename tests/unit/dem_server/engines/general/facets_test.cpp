// Bodies of cells that facets join deform like the solid, whatever their cells, keep their momentum and their
// energy, and break by what was stated.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/facets/facets.hpp"
#include "dem_server/engines/general/renumber.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::facets_test {
namespace {

scene::Scene block_of_cells(double width, double height, double size, double nu, scene::Plane plane,
                            std::uint64_t seed = 1) {
  auto scene = test::empty_scene();
  scene.set_plane(plane);
  scene.mutable_material()->set_poisson_ratio(nu);
  auto& cells = *scene.mutable_particles()->mutable_cells();
  test::set_box(cells, width, height);
  cells.set_size(size);
  cells.set_seed(seed);
  return scene;
}

struct Strain {
  double xx, yy, xy;
};

Particles strained(const Model& model, const Strain& strain) {
  Particles p = at_rest(model);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.ux[i] = strain.xx * p.x[i] + strain.xy * p.y[i];
    p.uy[i] = strain.xy * p.x[i] + strain.yy * p.y[i];
  }
  return p;
}

// Of cells without a free face: their facets close around them.
std::vector<bool> inside(const Model& model) {
  std::vector<double> doubled(model.discs.size(), 0.0);
  for (const Bond& bond : model.bonds)
    for (const std::uint32_t i : {bond.first, bond.second})
      doubled[i] += model.facets[bond.number].length * model.facets[bond.number].half_distance;
  std::vector<bool> inside;
  for (std::size_t i = 0; i < doubled.size(); ++i)
    inside.push_back(std::abs(doubled[i] - 2 * model.cell_area(i)) < 1e-9 * model.cell_area(i));
  return inside;
}

struct Case {
  double nu;
  scene::Plane plane;
};

class UniformStrain : public testing::TestWithParam<Case> {};

// Facets carry the solid's stress times their normal, away from the border, and cells are in balance.
TEST_P(UniformStrain, GivesTheStressOfTheSolid) {
  const auto [nu, plane] = GetParam();
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    auto scene = block_of_cells(1, 1, 0.1, nu, plane, seed);
    if (seed == 4) {  // sizes that differ
      auto& finer = *scene.mutable_particles()->mutable_cells()->add_finer();
      finer.mutable_where()->set_x_max(0.2);
      finer.set_size(0.03);
    }
    Model model = read_model(scene);
    renumber(model);
    const Strain strain{3e-9, -1e-9, 2e-9};
    Particles p = strained(model, strain);
    Facets facets(model, 1);
    protocol::Team team;
    facets.find_forces(0, p, team);

    double e = 10e9, v = nu;
    if (plane == scene::PLANE_STRAIN) {
      e /= 1 - v * v;
      v /= 1 - v;
    }
    const double factor = e / (1 - v * v);
    const double xx = factor * (strain.xx + v * strain.yy), yy = factor * (strain.yy + v * strain.xx),
                 xy = factor * (1 - v) * strain.xy;
    const std::vector<bool> in = inside(model);
    std::size_t seen = 0;
    double worst = 0, unbalanced = 0;
    for (std::uint32_t k = 0; k < facets.size(); ++k) {
      const std::uint32_t i = facets.set().first[k], j = facets.set().second[k];
      if (!in[i] || !in[j]) continue;
      ++seen;
      const double nx = facets.set().nx[k], ny = facets.set().ny[k], length = facets.set().length[k];
      const auto [x, y, m_1, m_2] = facets.action(k, p);
      worst = std::max(
          {worst, std::abs(x / length - (xx * nx + xy * ny)), std::abs(y / length - (xy * nx + yy * ny))});
    }
    std::vector<bool> far = in;  // all neighbours are inside
    for (std::uint32_t k = 0; k < facets.size(); ++k)
      if (!in[facets.set().first[k]] || !in[facets.set().second[k]])
        far[facets.set().first[k]] = far[facets.set().second[k]] = false;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (far[i]) unbalanced = std::max({unbalanced, std::abs(p.fx[i]), std::abs(p.fy[i])});
    EXPECT_GT(seen, 50u);
    EXPECT_LT(worst, 1e-9 * std::abs(xx));
    EXPECT_LT(unbalanced, 1e-9 * std::abs(xx) * 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, UniformStrain,
                         testing::Values(Case{0, scene::PLANE_STRESS}, Case{0.2, scene::PLANE_STRESS},
                                         Case{0.3, scene::PLANE_STRAIN}, Case{0.45, scene::PLANE_STRAIN}));

// The force on every cell is the gradient of the strain energy, whatever cells do, and however far they move
// and turn against each other: central differences of the energy.
class FacetMotions : public testing::TestWithParam<double> {};  // over the size of the cells

TEST_P(FacetMotions, GiveForcesThatAreTheGradientOfTheirEnergy) {
  auto scene = block_of_cells(0.5, 0.5, 0.1, 0.3, scene::PLANE_STRAIN);
  auto& soft = *scene.mutable_particles()->add_groups();
  soft.set_name("soft");
  soft.mutable_where()->set_x_min(0.25);
  *soft.mutable_material() = scene.material();
  soft.mutable_material()->set_young_modulus(2e9);
  Model model = read_model(scene);
  renumber(model);
  std::uint64_t state = 7;
  const auto random = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 40) / (1 << 24) - 0.5;
  };
  for (double& weight : model.weight) weight = 1 + random();
  for (Bond& bond : model.bonds) bond.weight = 1 + random();
  Particles p = at_rest(model);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.ux[i] = 0.1 * GetParam() * random();
    p.uy[i] = 0.1 * GetParam() * random();
    p.spin[i] = GetParam() * random();
  }
  protocol::Team team;
  const auto energy = [&](const Particles& at, double dt) {
    Particles copy = at;
    Facets facets(model, 1);
    facets.find_forces(dt, copy, team);
    return std::pair(facets.strain_energy(copy), copy);
  };
  const Particles forces = energy(p, 1).second;
  const double step = 1e-4 * GetParam();
  double largest = 0;
  for (const double f : forces.fx) largest = std::max(largest, std::abs(f));
  for (const std::size_t i : {3u, 11u, 17u}) {
    for (auto [values, force] :
         {std::pair{&Particles::ux, forces.fx[i]}, std::pair{&Particles::uy, forces.fy[i]},
          std::pair{&Particles::spin, forces.moment[i]}}) {
      Particles more = p, less = p;
      (more.*values)[i] += step;
      (less.*values)[i] -= step;
      const double found = -(energy(more, 1).first - energy(less, 1).first) / (2 * step);
      EXPECT_NEAR(found, force, 1e-5 * largest) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(NearAndFar, FacetMotions, testing::Values(1e-5, 1.0));

// Layers of unlike stiffness under one stress across them bear it, each by its own strain: the growth of a
// cell's area is that of its own solid.
TEST(FacetForces, OfLayersAreOneStress) {
  for (const double nu : {0.0, 0.3}) {
    auto scene = block_of_cells(2, 1, 0.1, nu, scene::PLANE_STRAIN);
    auto& soft = *scene.mutable_particles()->add_groups();
    soft.set_name("soft");
    soft.mutable_where()->set_x_min(1);
    *soft.mutable_material() = scene.material();
    const double ratio = 50;
    soft.mutable_material()->set_young_modulus(10e9 / ratio);
    Model model = read_model(scene);
    renumber(model);
    Particles p = at_rest(model);
    for (std::size_t i = 0; i < p.size(); ++i)
      p.ux[i] = 1e-9 * (p.x[i] < 1 ? p.x[i] : 1 + ratio * (p.x[i] - 1));
    Facets facets(model, 1);
    protocol::Team team;
    facets.find_forces(0, p, team);
    const double stress = 1e-9 * 10e9 * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const std::vector<bool> in = inside(model);
    std::size_t seen = 0;
    for (std::uint32_t k = 0; k < facets.size(); ++k) {
      const std::uint32_t i = facets.set().first[k], j = facets.set().second[k];
      if (!in[i] || !in[j] || (p.x[i] < 1) == (p.x[j] < 1)) continue;
      ++seen;
      EXPECT_NEAR(facets.action(k, p).x / (facets.set().length[k] * facets.set().nx[k]), stress,
                  0.02 * stress);
    }
    EXPECT_GT(seen, 5u);
  }
}

// A body that moves and turns far as a whole bears nothing.
TEST(FacetForces, VanishInRigidMotion) {
  Model model = read_model(block_of_cells(1, 0.5, 0.1, 0.2, scene::PLANE_STRESS));
  renumber(model);
  Particles p = at_rest(model);
  const double turn = 2.1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.ux[i] = std::cos(turn) * p.x[i] - std::sin(turn) * p.y[i] - p.x[i] + 5;
    p.uy[i] = std::sin(turn) * p.x[i] + std::cos(turn) * p.y[i] - p.y[i] - 3;
    p.spin[i] = turn;
  }
  Facets facets(model, 1);
  protocol::Team team;
  facets.find_forces(1, p, team);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.fx[i], 0, 10e9 * 1e-14);
    EXPECT_NEAR(p.moment[i], 0, 10e9 * 1e-14);
  }
}

Model brittle_block() {
  auto scene = block_of_cells(1, 0.5, 0.02, 0.2, scene::PLANE_STRESS);
  auto& fracture = *scene.mutable_material()->mutable_fracture();
  fracture.set_tensile_strength(3e6);
  fracture.set_fracture_energy(100);
  fracture.set_compressive_strength(30e6);
  Model model = read_model(scene);
  renumber(model);
  return model;
}

Particles shaken(const Model& model) {
  Particles p = at_rest(model);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.ux[i] = 1e-3 * std::sin(7 * p.x[i] + 3 * p.y[i]);
    p.uy[i] = 1e-3 * std::cos(5 * p.x[i] - 4 * p.y[i]);
    p.spin[i] = 0.01 * std::sin(9 * p.x[i]);
  }
  return p;
}

// Forces and moments about one point of all cells sum to nothing, broken or not, and across the border of two
// blocks, where each side computes the facets for itself.
TEST(FacetForces, KeepMomentum) {
  const Model model = brittle_block();
  Facets facets(model, 1);
  protocol::Team team;
  std::size_t cracked = 0;
  for (int step = 1; step <= 3; ++step) {
    Particles p = shaken(model);
    facets.find_forces(step == 1 ? 1 : 0.01, p, team);
    cracked += facets.cracked().size();
    double x = 0, y = 0, moment = 0, sizes = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      x += p.fx[i];
      y += p.fy[i];
      moment += p.moment[i] + (p.x[i] + p.ux[i]) * p.fy[i] - (p.y[i] + p.uy[i]) * p.fx[i];
      sizes += std::abs(p.fx[i]);
    }
    EXPECT_NEAR(x, 0, 1e-12 * sizes);
    EXPECT_NEAR(y, 0, 1e-12 * sizes);
    EXPECT_NEAR(moment, 0, 1e-12 * sizes);
  }
  EXPECT_GT(facets.set().cells(), 1024u);
  EXPECT_GT(cracked, 100u);
}

// Cells that a body falls apart into are free of pressure soon, whatever Poisson's ratio: open facets are
// free faces.
TEST(FacetForces, LeaveNoPressureInCellsThatNothingJoins) {
  for (const double nu : {0.2, 0.3, 0.45}) {
    auto scene = block_of_cells(1, 1, 0.1, nu, scene::PLANE_STRAIN);
    auto& fracture = *scene.mutable_material()->mutable_fracture();
    fracture.set_tensile_strength(1e5);
    fracture.set_fracture_energy(0.1);
    fracture.set_cohesion(1e6);
    Model model = read_model(scene);
    renumber(model);
    Facets facets(model, 1);
    protocol::Team team;
    const double strain = 1e-3;
    double first = 0;
    for (int step = 0; step < 120; ++step) {
      Particles p = strained(model, {strain, strain, 0});
      facets.find_forces(0, p, team);
      if (step == 0) first = std::ranges::max(facets.set().pressure);
    }
    EXPECT_GT(first, 1e5);
    for (const double pressure : facets.set().pressure) EXPECT_NEAR(pressure, 0, 1e-6 * first);
  }
}

// What observers find of single facets is what cells got in the step.
TEST(FacetForces, OfSingleFacetsSumToThoseOfCells) {
  const Model model = brittle_block();
  Facets facets(model, 1);
  protocol::Team team;
  Particles p = shaken(model);
  facets.find_forces(1, p, team);
  std::vector<double> x(p.size(), 0.0), moment(p.size(), 0.0);
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    const FacetAction action = facets.action(k, p);
    const std::uint32_t i = facets.set().first[k], j = facets.set().second[k];
    x[i] += action.x;
    x[j] -= action.x;
    moment[i] += action.moment_1;
    moment[j] += action.moment_2;
  }
  const auto size = [](double sum, double value) { return std::max(sum, std::abs(value)); };
  const double largest = std::accumulate(p.fx.begin(), p.fx.end(), 0.0, size),
               largest_moment = std::accumulate(p.moment.begin(), p.moment.end(), 0.0, size);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.fx[i], x[i], 1e-12 * largest);
    EXPECT_NEAR(p.moment[i], moment[i], 1e-12 * largest_moment);
  }
}

// Results do not depend on the number of threads.
TEST(FacetForces, AreTheSameByAnyThreads) {
  const Model model = brittle_block();
  std::vector<std::vector<double>> found;
  for (const std::size_t threads : {1u, 2u, 3u}) {
    Facets facets(model, threads);
    protocol::Team team(threads);
    for (const double turning : {1.0, 0.01}) {
      Particles p = shaken(model);
      facets.find_forces(turning, p, team);
      found.push_back(p.fx);
    }
  }
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_EQ(found[k], found[2 + k]);
    EXPECT_EQ(found[k], found[4 + k]);
  }
}

double kinetic(const Particles& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    twice += p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + p.inertia[i] * p.spin[i] * p.spin[i];
  return twice / 2;
}

// A body that was disturbed everywhere neither gains energy by steps just below the critical one, nor would a
// step do that is a tenth larger.
TEST(FacetSteps, AreStableUpToTheCriticalOne) {
  for (const double nu : {0.0, 0.2, 0.45}) {
    Model model = read_model(block_of_cells(1, 1, 0.1, nu, scene::PLANE_STRAIN));
    renumber(model);
    const auto grows = [&](double share) {
      test::Run run(model, share * critical_step(model));
      Particles& p = run.solver.particles();
      for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = i % 2 == 0 ? 1e-6 : -1e-6;
      const double before = kinetic(p);
      run.steps(2000);
      return !(kinetic(p) <= 10 * before);
    };
    EXPECT_FALSE(grows(0.99)) << nu;
    EXPECT_TRUE(grows(1.1)) << nu;
  }
}

// A body that is shaken to pieces, many of whose facets are half open, makes no energy by the pressures of
// its cells; steps are long beside the time in which facets lose their strength.
TEST(FacetSteps, MakeNoEnergyAsABodyFallsToPieces) {
  for (const double nu : {0.2, 0.3, 0.45}) {
    auto scene = block_of_cells(1, 0.5, 0.05, nu, scene::PLANE_STRAIN);
    auto& fracture = *scene.mutable_material()->mutable_fracture();
    fracture.set_tensile_strength(3e6);
    fracture.set_fracture_energy(100);
    fracture.set_compressive_strength(30e6);
    Model model = read_model(scene);
    renumber(model);
    test::Run run(model, 0.3 * critical_step(model));
    Particles& p = run.solver.particles();
    for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = i % 2 == 0 ? 3 : -3;
    const double start = kinetic(p);
    run.steps(2000);
    EXPECT_LT(kinetic(p), 0.8 * start);
    EXPECT_LT(-run.solver.time_step_share(run.solver.strain_energy().sum()), 0.03 * start) << nu;
  }
}

}  // namespace
}  // namespace adit::dem::facets_test
