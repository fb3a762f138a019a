// Requirement: the critical step of discs that only touch is a bound: below the exact limit of a pile whose
// contacts are all closed, 2 over its highest circular frequency, and not wastefully so.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::critical_step_test {
namespace {

constexpr double kNormal = 1e8;

using Disc = std::array<double, 3>;  // x, y, radius

// A hexagonal pile with this many rings around its middle.
std::vector<Disc> hexagon(int rings) {
  std::vector<Disc> discs;
  for (int j = -rings; j <= rings; ++j)
    for (int i = -rings; i <= rings; ++i)
      if (std::abs(i + j) <= rings) discs.push_back({i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j, 0.5});
  return discs;
}

// Twelve small discs around a large one.
std::vector<Disc> wreath() {
  const double sine = std::sin(std::numbers::pi / 12), small = sine / (1 - sine);
  std::vector<Disc> discs = {{0, 0, 1}};
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi / 6 * k;
    discs.push_back({(1 + small) * std::cos(angle), (1 + small) * std::sin(angle), small});
  }
  return discs;
}

scene::Scene loose(const std::vector<Disc>& discs, double shear) {
  std::string table = "x_m,y_m,radius_m\n";
  for (const auto& [x, y, radius] : discs) table += fmt::format("{:.17g},{:.17g},{:.17g}\n", x, y, radius);
  auto scene = test::placed_scene(table);
  scene.mutable_particles()->mutable_contacts()->set_normal_stiffness(kNormal);
  scene.mutable_particles()->mutable_contacts()->set_shear_stiffness(shear);
  return scene;
}

// Of solid discs.
Masses own_masses(const std::vector<Disc>& discs) {
  Masses masses;
  for (const auto& [x, y, radius] : discs) {
    masses.mass.push_back(test::kDensity * std::numbers::pi * radius * radius);
    masses.inertia.push_back(masses.mass.back() * radius * radius / 2);
  }
  return masses;
}

// Of discs whose touching pairs all stick: x, y and rotation of each.
double exact_step(const std::vector<Disc>& discs, double shear, const Masses& masses) {
  const auto size = static_cast<Eigen::Index>(3 * discs.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd root(size);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const auto& [x, y, radius] = discs[i];
    root.segment<3>(3 * i) << 1 / std::sqrt(masses.mass[i]), 1 / std::sqrt(masses.mass[i]),
        1 / std::sqrt(masses.inertia[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const double dx = discs[j][0] - x, dy = discs[j][1] - y, length = std::hypot(dx, dy);
      if (length > radius + discs[j][2] + 1e-9) continue;
      Eigen::VectorXd stretch = Eigen::VectorXd::Zero(size), slip = stretch;
      stretch.segment<2>(3 * i) << -dx / length, -dy / length;
      stretch.segment<2>(3 * j) << dx / length, dy / length;
      slip.segment<3>(3 * i) << dy / length, -dx / length, -radius;
      slip.segment<3>(3 * j) << -dy / length, dx / length, -discs[j][2];
      stiffness += kNormal * stretch * stretch.transpose() + shear * slip * slip.transpose();
    }
  }
  const Eigen::MatrixXd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
  return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
                           .eigenvalues()
                           .maxCoeff());
}

TEST(CriticalStepOfLooseDiscs, IsBelowTheExactStepOfAnyPile) {
  for (const auto& discs : {hexagon(4), wreath()})
    for (const double shear : {0.0, 0.5 * kNormal, kNormal, 2 * kNormal}) {
      const double bound = test::InProcessRun(loose(discs, shear)).model.critical_dt();
      const double exact = exact_step(discs, shear, own_masses(discs));
      EXPECT_LE(bound, exact) << discs.size() << " discs, shear stiffness " << shear;
      EXPECT_GT(bound, 0.5 * exact) << discs.size() << " discs, shear stiffness " << shear;
    }
}

// It is nearer to the exact one where discs differ.
TEST(CriticalStepOfLooseDiscs, IsTheOneThatTheMassesOfStaticsAreMadeFor) {
  for (const auto& discs : {hexagon(4), wreath()})
    for (const double shear : {0.0, 0.5 * kNormal, kNormal, 2 * kNormal}) {
      const Model model = test::loose_discs(discs, {kNormal, shear, 1, 0, 0});
      const CriticalElement critical = critical_element(model);
      const double bound = critical.static_step,
                   exact = exact_step(discs, shear, scaled_masses(model, critical.mass_per_stiffness));
      EXPECT_LE(bound, exact) << discs.size() << " discs, shear stiffness " << shear;
      EXPECT_GT(bound, 0.5 * exact) << discs.size() << " discs, shear stiffness " << shear;
    }
}

// Dashpots shorten the step of time alone; in statics they neither act nor count.
TEST(CriticalStepOfLooseDiscs, OfStaticsIsThatOfTheSprings) {
  const auto model_of = [](double damping) {
    auto scene = loose(hexagon(3), 0.5 * kNormal);
    scene.mutable_particles()->mutable_contacts()->set_normal_damping(damping);
    scene.mutable_particles()->mutable_contacts()->set_shear_damping(damping);
    return test::InProcessRun(scene).model;
  };
  const wire::Model undamped = model_of(0), damped = model_of(0.5);
  EXPECT_EQ(undamped.critical_static_dt(), undamped.critical_dt());
  EXPECT_EQ(damped.critical_static_dt(), undamped.critical_dt());
  EXPECT_LT(damped.critical_dt(), 0.5 * undamped.critical_dt());
}

// Two discs pressed on each other and on a wall: their dashpots change the motion in time, and not in
// statics.
TEST(CriticalStepOfLooseDiscs, DashpotsRestInStatics) {
  const auto pressed = [](double damping, bool relax) {
    const LinearContact contact{kNormal, 0.4 * kNormal, 0.5, damping, damping};
    Model model = test::loose_discs({{0.0, 0.45, 0.5}, {0.3, 1.35, 0.5}}, contact);
    model.walls.push_back(test::wall(-3, 0, 3, 0, contact));
    model.overlaps_free = false;
    Solver solver(model, 1);
    PrescribedMotions motions;
    Loads loads;
    for (std::uint64_t n = 1; n <= 100; ++n) solver.step({n, 2e-4, relax}, loads, motions);
    std::vector<double> places = solver.particles().ux;
    places.insert(places.end(), solver.particles().uy.begin(), solver.particles().uy.end());
    return places;
  };
  EXPECT_EQ(pressed(0.5, true), pressed(0, true));
  EXPECT_NE(pressed(0.5, false), pressed(0, false));
}

}  // namespace
}  // namespace adit::dem::critical_step_test
