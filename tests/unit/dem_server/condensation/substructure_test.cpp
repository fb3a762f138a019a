// Requirement: a linear chain of particles, condensed to the points that move its ends, is the bar that it
// is: stiffness, mass, momentum and energy are those of the chain, what the particles are told puts each of
// them in equilibrium with its inertia, and what cannot be condensed is refused.
#include "dem_server/condensation/substructure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dem_server/condensation/tangent.hpp"

namespace adit::dem::substructure_test {
namespace {

constexpr std::size_t kParticles = 31;
constexpr double kSpring = 4e6, kTurning = 3e3, kMass = 2.5, kInertia = 0.1;

// Springs between neighbours in x, y and turn, and against turns, after a compression; `stop`: the middle one
// resists only pressure beyond the state at rest.
std::vector<double> forces_in(std::span<const double> motion, bool stop = false) {
  std::vector<double> forces(motion.size(), 0.0);
  for (std::size_t i = 0; i < kParticles; ++i)
    forces[kFreedoms * i + 2] = -kTurning * motion[kFreedoms * i + 2];
  for (std::size_t i = 0; i + 1 < kParticles; ++i)
    for (std::size_t k = 0; k < kFreedoms; ++k) {
      const double change = motion[kFreedoms * (i + 1) + k] - motion[kFreedoms * i + k];
      double force = (k == 2 ? kTurning : kSpring) * change - (k == 0 ? 1000 : 0);
      if (stop && i == kParticles / 2 && k == 0) force = std::min(force, -1000.0);
      forces[kFreedoms * i + k] += force;
      forces[kFreedoms * (i + 1) + k] -= force;
    }
  return forces;
}

Tangent chain_tangent(bool stop = false) {
  std::vector<std::uint32_t> first, second;
  for (std::uint32_t i = 0; i + 1 < kParticles; ++i) {
    first.push_back(i);
    second.push_back(i + 1);
  }
  return tangent_of(std::vector<double>(kParticles, 0.2), neighbourhood_of(kParticles, first, second),
                    [stop](std::span<const double> motion) { return forces_in(motion, stop); });
}

std::vector<double> masses() {
  std::vector<double> masses;
  for (std::size_t i = 0; i < kParticles; ++i) masses.insert(masses.end(), {kMass, kMass, kInertia});
  return masses;
}

// The ends follow a master each.
Substructure chain() {
  return {chain_tangent(), masses(), std::vector<std::uint32_t>{0, kParticles - 1},
          protocol::SparseRows({0, 1, 2}, {0, 1}, {1, 1}), 2};
}

TEST(Tangent, IsTheStiffnessOfLinearForces) {
  const Tangent tangent = chain_tangent();
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd motion(static_cast<Eigen::Index>(kFreedoms * kParticles));
  for (double& value : motion) value = uniform(engine);
  const std::vector<double> forces = forces_in(std::span(motion.data(), kFreedoms * kParticles));
  const Eigen::VectorXd resisted = tangent.stiffness * motion;
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const auto place = static_cast<std::size_t>(k);
    EXPECT_NEAR(resisted[k], tangent.forces[place] - forces[place], 1e-5 * kSpring);
  }
  EXPECT_LT(tangent.one_sidedness, 1e-5);
}

TEST(Tangent, TellsWhatHasOneSide) {
  EXPECT_GT(chain_tangent(true).one_sidedness, 1e-2);
}

TEST(Substructure, IsABar) {
  const Condensed bar = chain().condense();
  const double stiffness = kSpring / (kParticles - 1);
  for (const Eigen::Index component : {0, 1}) {
    EXPECT_NEAR(bar.stiffness(component, component), stiffness, 1e-6 * stiffness);
    EXPECT_NEAR(bar.stiffness(component, 2 + component), -stiffness, 1e-6 * stiffness);
    // Momentum: a motion of both masters moves all particles.
    EXPECT_NEAR(bar.mass.row(component).sum() + bar.mass.row(2 + component).sum(), kParticles * kMass,
                1e-6 * kParticles * kMass);
    double third = 0;  // of the shape that grows from one end to the other
    for (std::size_t i = 0; i < kParticles; ++i)
      third += kMass * std::pow(static_cast<double>(i) / (kParticles - 1), 2);
    EXPECT_NEAR(bar.mass(component, component), third, 1e-6 * third);
  }
  EXPECT_NEAR(bar.stiffness(0, 1), 0, 1e-6 * stiffness);
  EXPECT_NEAR(bar.force[0], -1000, 1e-3);  // the chain pushes both ends outwards
  EXPECT_NEAR(bar.force[2], 1000, 1e-3);
}

TEST(Substructure, KeepsEnergyAndMomentumOfWhatItTells) {
  const Substructure substructure = chain();
  const Condensed bar = substructure.condense();
  const std::vector<double> q{1e-3, -2e-3, 3e-3, 1e-3}, before{0.1, 0.2, -0.3, 0.4}, after = before;
  const ParticlesMotion told = substructure.recover({q, before, after}, 1e-4);
  const auto at = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  const Eigen::VectorXd u = at(told.displacements), v = at(told.velocities), m = at(masses());
  const Tangent tangent = chain_tangent();
  EXPECT_NEAR(u.dot(tangent.stiffness * u), at(q).dot(bar.stiffness * at(q)),
              1e-6 * u.dot(tangent.stiffness * u));
  EXPECT_NEAR(v.dot(m.cwiseProduct(v)), at(after).dot(bar.mass * at(after)), 1e-6 * v.dot(m.cwiseProduct(v)));
}

// The ends swing; the particles between them swing with them as a bar does, which the lag by inertia has to
// the first order.
TEST(Substructure, LagsByInertia) {
  const Substructure substructure = chain();
  const double acceleration = 7, dt = 1e-4;
  const std::vector<double> q(4, 0.0), before(4, 0.0);
  const std::vector<double> after{acceleration * dt, 0, acceleration * dt, 0};
  const ParticlesMotion told = substructure.recover({q, before, after}, dt);
  const std::vector<double> forces = forces_in(told.displacements),
                            at_rest = forces_in(std::vector<double>(93, 0.0));
  for (std::size_t i = 1; i + 1 < kParticles; ++i)
    EXPECT_NEAR(forces[kFreedoms * i] - at_rest[kFreedoms * i], kMass * acceleration,
                1e-4 * kMass * acceleration);
}

TEST(Substructure, RefusesWhatNothingHolds) {
  EXPECT_THROW(Substructure(chain_tangent(), masses(), std::vector<std::uint32_t>{},
                            protocol::SparseRows({0}, {}, {}), 1),
               Substructure::NotHeld);
}

}  // namespace
}  // namespace adit::dem::substructure_test
