// Requirements on beams of members: rigid motion, second order, sliding, loss.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdm_server/structures/member.hpp"
#include "fdm_server/structures/member_beam.hpp"
#include "fdm_server/supports/lining.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::member_beam_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLength = 4, kThin = 0.05;

// Beams along x, whose ends move as they are told.
struct Chain {
  std::vector<Beam> beams;
  std::vector<MemberBeam> members;
  std::vector<double> vx, vy, fx, fy, rate, couple;

  explicit Chain(std::uint32_t count, const Section& section = wall(kThin, false)) {
    for (std::uint32_t k = 0; k < count; ++k) {
      beams.push_back(Beam({k, k + 1}, {k, k + 1}, {1, 0, kLength / count}, section));
      members.emplace_back(beams.back());
    }
    for (auto* of : {&vx, &vy, &fx, &fy, &rate, &couple}) of->assign(count + 1, 0.0);
  }
  // Moves by these velocities for a second; forces afterwards.
  void move() {
    for (auto* of : {&fx, &fy, &couple}) std::ranges::fill(*of, 0.0);
    for (std::size_t k = 0; k < beams.size(); ++k)
      members[k].add_forces(beams[k], 1, {vx.data(), vy.data(), fx.data(), fy.data()},
                            {rate.data(), couple.data()});
    for (auto* of : {&vx, &vy, &rate}) std::ranges::fill(*of, 0.0);
  }
  double& velocity(std::size_t freedom) {  // of vy, then of rate
    return freedom < vy.size() ? vy[freedom] : rate[freedom - vy.size()];
  }
  double force(std::size_t freedom) const {
    return freedom < fy.size() ? fy[freedom] : couple[freedom - fy.size()];
  }
};

// The smallest eigenvalue of the stiffness across the chain under a thrust, over these freedoms.
double least_stiffness(double thrust, const std::vector<std::size_t>& free) {
  Chain bent(8);
  const double shortening = thrust * kLength / (kConcrete / (1 - kNu * kNu) * kThin);
  for (std::size_t i = 0; i <= 8; ++i) bent.vx[i] = shortening * static_cast<double>(i) / 8;
  bent.move();
  constexpr double kSmall = 1e-6;
  Eigen::MatrixXd k(free.size(), free.size());
  for (std::size_t column = 0; column < free.size(); ++column) {
    Chain plus = bent, minus = bent;
    plus.velocity(free[column]) = kSmall;
    minus.velocity(free[column]) = -kSmall;
    plus.move();
    minus.move();
    for (std::size_t row = 0; row < free.size(); ++row)
      k(row, column) = (minus.force(free[row]) - plus.force(free[row])) / (2 * kSmall);
  }
  EXPECT_LE((k - k.transpose()).norm(), 1e-6 * k.norm());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues()[0];
}

// The compression at which it vanishes.
double buckling_load(const std::vector<std::size_t>& free, double guess) {
  double low = 0.5 * guess, high = 2 * guess;
  EXPECT_GT(least_stiffness(-low, free), 0);
  EXPECT_LT(least_stiffness(-high, free), 0);
  for (int i = 0; i < 40; ++i) (least_stiffness(-(low + high) / 2, free) > 0 ? low : high) = (low + high) / 2;
  return low;
}

std::vector<std::size_t> all_but(std::initializer_list<std::size_t> held) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < 18; ++i)
    if (std::ranges::find(held, i) == held.end()) free.push_back(i);
  return free;
}

// Eight beams buckle under Euler's loads within 1 %; tension stiffens them.
TEST(MemberBeam, BucklesUnderEulersLoad) {
  const double euler =
      kPi * kPi * kConcrete / (1 - kNu * kNu) * std::pow(kThin, 3) / 12 / (kLength * kLength);
  const auto pinned = all_but({0, 8}), fixed = all_but({0, 8, 9, 17}), cantilever = all_but({0, 9});
  EXPECT_NEAR(buckling_load(pinned, euler) / euler, 1, 2e-3);
  EXPECT_NEAR(buckling_load(fixed, 4 * euler) / (4 * euler), 1, 5e-3);
  EXPECT_NEAR(buckling_load(cantilever, euler / 4) / (euler / 4), 1, 1e-3);
  EXPECT_GT(least_stiffness(euler, pinned), least_stiffness(0, pinned));
}

// A turn by any angle strains nothing.
TEST(MemberBeam, FollowsRigidMotion) {
  Chain chain(4, wall(0.4));
  constexpr int kSteps = 300;
  constexpr double kTurn = 3.0 / kSteps;
  for (int n = 0; n < kSteps; ++n) {
    for (std::size_t i = 0; i <= 4; ++i) {
      const double r = static_cast<double>(i), now = n * kTurn, next = now + kTurn;
      chain.vx[i] = r * (std::cos(next) - std::cos(now)) + 0.1;
      chain.vy[i] = r * (std::sin(next) - std::sin(now)) - 0.2;
      chain.rate[i] = kTurn;
    }
    chain.move();
  }
  const double scale = kConcrete * 0.4;  // of a force at a strain of 1
  for (std::size_t i = 0; i <= 4; ++i) {
    EXPECT_NEAR(chain.fx[i], 0, 1e-11 * scale);
    EXPECT_NEAR(chain.fy[i], 0, 1e-11 * scale);
    EXPECT_NEAR(chain.couple[i], 0, 1e-11 * scale);
  }
}

// Small motions strain it as beam.hpp says.
TEST(MemberBeam, IsTheElasticBeamAtFirst) {
  Chain chain(1, wall(0.4));
  Beam beam({0, 1}, {0, 1}, {1, 0, kLength}, wall(0.4));
  std::vector<double> vx{0, 2e-9}, vy{0, 1e-9}, rate{3e-9, -2e-9}, fx(2), fy(2), couple(2);
  beam.add_forces(1, {vx.data(), vy.data(), fx.data(), fy.data()}, {rate.data(), couple.data()});
  chain.vx = vx;
  chain.vy = vy;
  chain.rate = rate;
  chain.move();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(chain.fx[i], fx[i], 1e-7 * std::abs(fx[0]));
    EXPECT_NEAR(chain.fy[i], fy[i], 1e-7 * std::abs(fy[0]));
    EXPECT_NEAR(chain.couple[i], couple[i], 1e-7 * std::abs(couple[0]));
  }
}

// The work that the ledger books on a curved path differs from what is stored by a share that falls with the
// square of the step.
TEST(MemberBeam, MissesOfTheWorkWhatFallsWithTheSquareOfTheStep) {
  const auto missed = [](int steps) {
    Chain chain(1, wall(0.4));
    const auto at = [](double t) {
      return std::array{2e-4 * std::sin(3 * t), 0.05 * std::sin(5 * t), 0.02 * std::sin(4 * t)};
    };
    for (int n = 0; n < steps; ++n) {
      const auto before = at(static_cast<double>(n) / steps), after = at((n + 1.0) / steps);
      chain.vx[1] = after[0] - before[0];
      chain.vy[1] = after[1] - before[1];
      chain.rate[1] = after[2] - before[2];
      chain.move();
    }
    return chain.members[0].dissipated() / chain.members[0].stored();
  };
  EXPECT_NEAR(missed(2000) / missed(4000), 4, 0.1);
  EXPECT_LE(std::abs(missed(4000)), 1e-4);
}

// A beam that slides passes on its strength, and dissipates it times the slip.
TEST(MemberBeam, SlidesUnderItsStrength) {
  Chain chain(1, wall(0.4));
  constexpr double kStrength = 1e5, kWay = 0.02;
  chain.members[0].limit_shear(kStrength);
  for (int n = 0; n < 2000; ++n) {
    chain.vy[1] = kWay / 2000;
    chain.move();
    EXPECT_LE(std::abs(chain.beams[0].forces().shear), kStrength * (1 + 1e-12));
  }
  const double elastic = kStrength / chain.beams[0].strains()[2].stiffness * kLength / 2 * kLength / 2;
  EXPECT_NEAR(chain.members[0].slip(), kWay - elastic, 2e-3 * kWay);
  EXPECT_NEAR(chain.members[0].dissipated() / (kStrength * chain.members[0].slip()), 1, 2e-3);
}

// What a lost beam stored is dissipated, and it bears nothing.
TEST(MemberBeam, ALostBeamGivesUpItsEnergy) {
  Chain chain(1, wall(0.4));
  chain.vy[1] = 1e-3;
  chain.move();
  const double stored = chain.members[0].stored();
  EXPECT_GT(stored, 0);
  const double work = stored + chain.members[0].dissipated();
  chain.members[0].lose();
  chain.move();
  EXPECT_EQ(chain.members[0].stored(), 0);
  EXPECT_NEAR(chain.members[0].dissipated(), work, 1e-12 * work);
  EXPECT_EQ(chain.fy[1], 0);
  EXPECT_EQ(chain.beams[0].forces().thrust, 0);
}

// Steps of six critical ones are stable from a rough start while one end moves across the other, by 0.07 of
// the length, and the ledger closes.
TEST(MemberBeam, IsStableInLongSteps) {
  constexpr double kRough = 0.02, kTurned = 0.07;  // [m/s], of the length
  Grid grid = line(kLength, 8);
  Path path{{}, false};
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) path.points.push_back(i);
  Structures structures;
  LiningPlan plan{"member", path, wall(0.4), {}, false, false};
  plan.spacing = 1;
  add_lining(plan, grid, structures);
  std::vector<double> masses(grid.x.size(), 0.0);
  structures.add_masses(masses);
  const double dt = 6 * structures.critical_step();
  constexpr std::uint64_t kSteps = 20000;
  const double across = kTurned * kLength / (kSteps * dt);
  Continuum continuum = beams_alone(
      grid, structures, masses, {},
      {fixed({0}, Axis::kX), fixed({0}, Axis::kY), PrescribedMotion{{8}, Axis::kY, across, constant}});
  continuum.step({0, dt});
  for (std::size_t i = 1; i < grid.x.size(); ++i) {
    continuum.vx()[i] = kRough * std::sin(7.0 * static_cast<double>(i * i));
    if (i < 8) continuum.vy()[i] = kRough * std::cos(5.0 * static_cast<double>(i * i));
  }
  Energies first{}, now{};
  continuum.step({1, dt}, &first);
  const double start = first.kinetic + first.strain;
  for (std::uint64_t n = 2; n <= kSteps; ++n) {
    continuum.step({n, dt}, &now);
    ASSERT_LE(now.kinetic + now.strain, 1.5 * start) << n;
  }
  EXPECT_NEAR(now.kinetic + now.strain + now.dissipated - now.external_work,
              first.kinetic + first.strain + first.dissipated - first.external_work, 1e-10 * start);
  EXPECT_NEAR(continuum.uy()[8], kTurned * kLength, 0.01 * kLength);
}

// Elwood and Moehle's drift at axial failure, by hand: 1.0 MN on stirrups of 150 mm^2 every 0.3 m, 300 MPa,
// in a core of 0.32 m: tan 65 = 2.1445, A f d tan/s = 102.9 kN.
TEST(MemberFailure, DriftAtAxialFailureIsElwoodAndMoehles) {
  const MemberStrength strength{{30e6, 1, 30e6, 300e6, 150e-6 / 0.3}, 0, 0.02, 0.32};
  EXPECT_NEAR(axial_failure_drift(strength, -1e6), 0.04 * 5.5989 / (2.1445 + 1e6 / 102.94e3), 1e-5);
  EXPECT_NEAR(axial_failure_drift(strength, 1e6), 0.04 * 5.5989 / 2.1445, 1e-5);  // tension
}

}  // namespace
}  // namespace adit::fdm::test::member_beam_test
