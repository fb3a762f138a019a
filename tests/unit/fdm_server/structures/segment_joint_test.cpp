// Requirements on joints of segments: the closed form of Janssen, an energy from which all forces derive,
// bolts and gaskets, rings whose joints open against the method of forces, and the ledger.
#include "fdm_server/structures/segment_joint.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "fdm_server/supports/joint_use.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::segment_joint_test {
namespace {

using std::numbers::pi;

constexpr double kHeight = 0.2, kInf = std::numeric_limits<double>::infinity();

JointLaw faces() {
  JointLaw law{{kHeight, kConcrete}};
  law.edge = 0.175;
  return law;
}

// Two rows of bolts, and a gasket that presses with 40 kN/m while the joint is closed.
JointLaw bolted() {
  JointLaw law = faces();
  law.bolts = {{80e6, 120e3, 200e3, 0.03, 1.5}, {50e6, 0, 100e3, -0.06, 1}};
  law.gasket = JointGasket{{{-2e-3, 0, 4e-3, 1}, {-90e3, -40e3, 0, 0}}, 0.13, 0.03 * 400e3};
  return law;
}

std::vector<double> slack_of(const JointLaw& law) {
  std::vector<double> slack;
  for (const JointBolts& row : law.bolts)
    slack.push_back(opening_at(*law.installed(), row.position) - row.pretension / row.stiffness);
  return slack;
}

// Janssen's rotation of a joint under a thrust N < 0.
double janssen(double thrust, double moment) {
  const double n = -thrust, m = std::abs(moment);
  const double phi = m <= n * kHeight / 6
                         ? 12 * m / (kConcrete * kHeight * kHeight)
                         : 8 * n / (9 * kHeight * kConcrete * std::pow(2 * m / (n * kHeight) - 1, 2));
  return std::copysign(phi, moment);
}

// The opening of a joint under these forces.
JointOpening under(const JointLaw& law, double thrust, double moment) {
  const Eigen::Matrix2d soft = 1e-9 * law.faces.closed();
  JointOpening opening = JointOpening::Zero();
  for (int trial = 0; trial < 20; ++trial)
    opening += law.solve(opening, slack_of(law), soft, {thrust, moment});
  return opening;
}

// The rotation is that of Janssen for every thrust and moment, to either side, closed and open.
TEST(JointLaw, RotationIsJanssens) {
  for (const double thrust : {-1e3, -2e5, -3e6})
    for (const double share : {-0.495, -0.4, -0.2, -0.1, 0.05, 0.16, 0.17, 0.3, 0.45, 0.49}) {
      const double moment = share * kHeight * -thrust;
      EXPECT_NEAR(under(faces(), thrust, moment)[1] / janssen(thrust, moment), 1, 1e-6) << share;
    }
}

// Closed, the axis shortens by N/E; it does not feel the moment. Open, it lengthens as the joint turns about
// the end of its contact, where the opening is 0.
TEST(JointLaw, TheAxisLengthensAsTheJointOpens) {
  const double thrust = -1e6;
  EXPECT_NEAR(under(faces(), thrust, 0.1 * kHeight * 1e6)[0], thrust / kConcrete, 1e-12);
  const double eccentricity = 0.4 * kHeight, contact = 3 * (kHeight / 2 - eccentricity);
  const JointOpening open = under(faces(), thrust, -eccentricity * thrust);
  EXPECT_NEAR(opening_at(open, -kHeight / 2 + contact), 0, 1e-10);
  EXPECT_GT(open[0], 0);
}

// Forces are the derivative of the energy, and the stiffness is that of the forces.
TEST(JointLaw, ForcesAndStiffnessDeriveFromTheEnergy) {
  const JointLaw law = bolted();
  const auto slack = slack_of(law);
  constexpr double kStep = 1e-8;
  for (int k = 0; k < 200; ++k) {
    const JointOpening at{3e-4 * std::sin(3.7 * k), 4e-3 * std::cos(2.3 * k * k)};
    Eigen::Vector2d forces;
    Eigen::Matrix2d stiffness;
    for (int c = 0; c < 2; ++c) {
      JointOpening more = at, less = at;
      more[c] += kStep;
      less[c] -= kStep;
      forces[c] = (law.stored(more, slack) - law.stored(less, slack)) / (2 * kStep);
      stiffness.col(c) = (law.forces(more, slack) - law.forces(less, slack)) / (2 * kStep);
    }
    // Bolts yield without storing more.
    bool yields = false;
    for (std::size_t row = 0; row < 2; ++row)
      yields |=
          law.bolts[row].force(opening_at(at, law.bolts[row].position), slack[row]) == law.bolts[row].yield;
    if (!yields) {
      EXPECT_NEAR((forces - law.forces(at, slack)).norm(), 0, 1e-5 * law.forces(at, slack).norm() + 10) << k;
    }
    EXPECT_NEAR((stiffness - law.stiffness(at, slack)).norm(), 0, 1e-4 * law.stiffness(at, slack).norm())
        << k;
  }
}

// Installed, the joint is free of thrust and moment, and its bolts have their pretension.
TEST(JointLaw, PressureOfTheFacesBalancesThePretension) {
  const JointLaw law = bolted();
  const JointOpening opening = law.installed().value();
  const auto slack = slack_of(law);
  EXPECT_NEAR(law.forces(opening, slack).norm(), 0, 1e-6);
  EXPECT_NEAR(law.bolts[0].force(opening_at(opening, 0.03), slack[0]), 120e3, 1e-6);
  EXPECT_LT(opening[0], 0);
  JointLaw beside = faces();
  beside.bolts = {{80e6, 60e3, kInf, 0.12, 1}};
  EXPECT_FALSE(beside.installed().has_value());
  // A gasket that no bolt holds pushes the faces apart until it lets go.
  JointLaw loose = bolted();
  loose.bolts.clear();
  EXPECT_NEAR(opening_at(loose.installed().value(), 0.13), 4e-3, 1e-9);
}

// Pulled, a joint stays closed up to its pretension, then opens by the stiffness of its bolts, which yield
// and are slack when it closes again.
TEST(JointLaw, BoltsPullOnceTheJointOpens) {
  JointLaw law = faces();
  law.bolts = {{80e6, 60e3, 100e3, 0, 1}};
  EXPECT_LT(under(law, 59e3, 0)[0], 0);
  EXPECT_NEAR(under(law, 90e3, 0)[0] - under(law, 80e3, 0)[0], 10e3 / 80e6, 1e-9);
  // A beam that is pulled out by 3 mm and comes back.
  const Beam beam({0, 1}, {0, 1}, chord(0, 0, 1, 0), wall(0.35));
  SegmentJoint joint(std::make_shared<const JointLaw>(law), beam, 1);
  Beam moving = beam;
  std::vector<double> still(2), vx{0, 3e-5}, fx(2), fy(2), couple(2);
  const auto pull = [&](double speed, int steps) {
    vx[1] = speed;
    for (int n = 0; n < steps; ++n) {
      const PointView points{vx.data(), still.data(), fx.data(), fy.data()};
      const RotationView rotations{still.data(), couple.data()};
      const auto [e, b, a] = moving.rates(points, rotations);
      const BeamStrains left = joint.strain(moving, {e, b, a});
      moving.add_forces(moving.resultants() + moving.resists(left), points, rotations);
      joint.book(moving);
    }
  };
  pull(3e-5, 100);
  EXPECT_NEAR(moving.resultants().n, 100e3, 1e-3);
  const double opened = joint.opening()[0];
  pull(-3e-5, 90);
  EXPECT_NEAR(moving.resultants().n, 0, 1e-6);
  const double slack = joint.slack()[0], yielded = slack - (law.installed().value()[0] - 60e3 / 80e6);
  EXPECT_NEAR(slack, opened - 100e3 / 80e6, 1e-12);
  EXPECT_NEAR(joint.dissipated() / (100e3 * yielded / 2), 1, 0.02);  // half of the joint is in this end
}

// A gasket presses by its curve; its tightness is its pressure over that of the water.
TEST(JointUse, TightnessIsThePressureOfTheGasketOverThatOfTheWater) {
  JointLaw law = bolted();
  law.bolts.clear();
  Frame frame(line(2, 2), false, wall(0.35), {{1, 0, 0, std::make_shared<const JointLaw>(law)}},
              {true, true});
  Continuum continuum = frame.continuum({}, {fixed({0, 1, 2}, Axis::kY), fixed({0}, Axis::kX),
                                             PrescribedMotion{{2}, Axis::kX, -0.1, constant}});
  const double dt = 0.5 * frame.structures.critical_step();
  std::uint64_t n = 0;
  double last = 0;
  for (; n * dt * 0.1 < 6e-3; ++n) {
    continuum.step({n, dt});
    const JointUse use = joint_use(frame.lining, continuum.structures(), frame.lining.joints[0]);
    const double opening = use.gasket_opening, force = opening > 4e-3 ? 0
                                                       : opening > 0  ? 40e3 * (1 - opening / 4e-3)
                                                                      : 40e3 - 25e6 * opening;
    EXPECT_NEAR(use.tightness, force / (0.03 * 400e3), 1e-9);
    last = use.tightness;
  }
  EXPECT_GT(last, 2);
}

// A cantilever whose end is pushed and turned: its tip turns by the beam's own rotation and by Janssen's, at
// whichever of its nodes the joint is, and under either sign of the moment.
TEST(SegmentJoint, ACantileverTurnsByTheRotationOfJanssen) {
  const double length = 4, thrust = -2e6, load = 60e3;
  for (const double sign : {-1.0, 1.0})
    for (const std::size_t node : {2u, 3u}) {
      const double lever = length - static_cast<double>(node) / 2, moment = sign * load * lever;
      ASSERT_GT(std::abs(moment), -thrust * kHeight / 6);
      Frame jointed(line(length, 8), false, wall(0.35),
                    {{node, 0, 0, std::make_shared<const JointLaw>(faces())}}, {true, false});
      Frame whole(line(length, 8), false, wall(0.35), {}, {true, false});
      std::vector<double> tips, axes;
      for (Frame* frame : {&jointed, &whole}) {
        Continuum continuum = frame->continuum({Load{{8}, {thrust}, {sign * load}, constant}},
                                               {fixed({0}, Axis::kX), fixed({0}, Axis::kY)});
        settle(continuum, 0.5 * frame->structures.critical_step(), 0, 1e-16);
        tips.push_back(continuum.structures().rotations()[8]);
        axes.push_back(continuum.ux()[8]);
        if (frame == &jointed) {
          const JointUse use = joint_use(frame->lining, continuum.structures(), frame->lining.joints[0]);
          EXPECT_NEAR(use.rotation / janssen(thrust, moment), 1, 1e-5);
          EXPECT_NEAR(use.thrust / thrust, 1, 1e-6);
          EXPECT_NEAR(use.moment / moment, 1, 1e-5);
        }
      }
      EXPECT_NEAR((tips[0] - tips[1]) / janssen(thrust, moment), 1, 1e-5);
      EXPECT_NEAR(axes[0] - axes[1], under(faces(), thrust, moment)[0], 1e-4 * std::abs(axes[0]));
    }
}

// Half a joint at an end that cannot rotate is the joint of a model twice as long.
TEST(SegmentJoint, APlaneOfSymmetryHasHalfOfIt) {
  const auto law = std::make_shared<const JointLaw>(bolted());
  Frame half(line(2, 4), false, wall(0.35), {{0, 0, 0, law}}, {true, false});
  Frame whole(line(4, 8), false, wall(0.35), {{4, 0, 0, law}});
  Continuum one =
      half.continuum({Load{{4}, {-5e5}, {1e5}, constant}}, {fixed({0}, Axis::kX), fixed({0}, Axis::kY)});
  Continuum both = whole.continuum({Load{{0, 8}, {5e5, -5e5}, {1e5, 1e5}, constant}},
                                   {fixed({4}, Axis::kX), fixed({4}, Axis::kY)});
  const double dt = 0.5 * half.structures.critical_step();
  for (std::uint64_t n = 0; n < 2000; ++n) {
    one.step({n, dt});
    both.step({n, dt});
  }
  EXPECT_NE(one.ux()[4], 0);
  EXPECT_NEAR(one.ux()[4], both.ux()[8], 1e-12 * std::abs(one.ux()[4]));
  EXPECT_NEAR(one.uy()[4], both.uy()[8], 1e-12 * std::abs(one.uy()[4]));
  EXPECT_NEAR(joint_use(half.lining, one.structures(), half.lining.joints[0]).rotation,
              joint_use(whole.lining, both.structures(), whole.lining.joints[0]).rotation, 1e-14);
}

// A ring of six segments under pressure from all around and two opposed loads, P at its crown and invert, its
// joints at 0, 60, … degrees.
constexpr double kRadius = 4, kThickness = 0.35;
constexpr std::size_t kBeams = 48;

Frame ring(const JointLaw& law) {
  const auto shared = std::make_shared<const JointLaw>(law);
  std::vector<LiningJoint> joints;
  for (std::size_t k = 0; k < 6; ++k) joints.push_back({k * kBeams / 6, 0, 0, shared});
  return Frame(circle(kRadius, kBeams), true, wall(kThickness), joints);
}

Load loads(double pressure, double load) {
  Load all{{}, {}, {}, constant};
  for (std::uint32_t i = 0; i < kBeams; ++i) {
    const double angle = 2 * pi * i / kBeams, force = pressure * kRadius * 2 * pi / kBeams;
    all.points.push_back(i);
    all.fx.push_back(-force * std::cos(angle));
    all.fy.push_back(-force * std::sin(angle) + (i == kBeams / 4 ? -load : i == 3 * kBeams / 4 ? load : 0));
  }
  return all;
}

// The method of forces in a quarter of the ring, from its joint at 0 to the load: N = -pR - P/2 cos t, M =
// M_0 - PR/2 (1 - cos t), where M_0 is such that the quarter turns by nothing. The rotations of joints are
// Janssen's.
struct QuarterRing {
  double pressure, load, moment = 0;  // M_0

  double thrust(double t) const { return -pressure * kRadius - load / 2 * std::cos(t); }
  double bent(double t) const { return moment - load * kRadius / 2 * (1 - std::cos(t)); }

  QuarterRing(double pressure_, double load_) : pressure(pressure_), load(load_) {
    const Section section = wall(kThickness);
    // The moment of the quarter: int M R dt, by parts.
    const auto turn = [&] {
      return kRadius / section.bending * (moment * pi / 2 - load * kRadius / 2 * (pi / 2 - 1)) +
             janssen(thrust(0), bent(0)) / 2 + janssen(thrust(pi / 3), bent(pi / 3));
    };
    // The rotations are infinite where |M| = |N| h/2.
    const double limit = 0.4999 * kHeight;
    double low = std::max(thrust(0) * limit, thrust(pi / 3) * limit + load * kRadius / 4),
           high = std::min(-thrust(0) * limit, -thrust(pi / 3) * limit + load * kRadius / 4);
    for (int k = 0; k < 200; ++k) {
      moment = (low + high) / 2;
      (turn() < 0 ? low : high) = moment;
    }
  }
};

TEST(RingOfSegments, FollowsTheMethodOfForces) {
  for (const double load : {15e3, 40e3, 75e3}) {
    const double pressure = 100e3;
    const QuarterRing expected(pressure, load);
    Frame frame = ring(faces());
    Continuum continuum =
        frame.continuum({loads(pressure, load)},
                        {fixed({kBeams / 4, 3 * kBeams / 4}, Axis::kX), fixed({0, kBeams / 2}, Axis::kY)});
    settle(continuum, 0.8 * frame.structures.critical_step(), 0, 1e-20);
    const double largest = std::max(std::abs(expected.bent(0)), std::abs(expected.bent(pi / 2)));
    for (const std::size_t k : {0u, 1u}) {
      const double t = static_cast<double>(k) * pi / 3;
      const JointUse use = joint_use(frame.lining, continuum.structures(), frame.lining.joints[k]);
      EXPECT_NEAR(use.moment, expected.bent(t), 0.01 * largest);
      EXPECT_NEAR(use.thrust / expected.thrust(t), 1, 0.01);
      EXPECT_NEAR(use.rotation / janssen(expected.thrust(t), expected.bent(t)), 1, 0.01);
    }
    const double crown = forces_at(frame.lining, continuum.structures(), kBeams / 4).moment;
    EXPECT_NEAR(crown, expected.bent(pi / 2), 0.01 * largest);
  }
}

// Turned by a joint and mirrored, the ring moves turned and mirrored: no side of a joint is another one's.
TEST(RingOfSegments, HasNoSides) {
  const auto moved = [](int mirror) {
    Frame frame = ring(bolted());
    Load load = loads(100e3, 150e3);
    load.points.push_back(mirror > 0 ? 7 : kBeams - 7);
    load.fx.push_back(2e5);
    load.fy.push_back(mirror * 1e5);
    Continuum continuum = frame.continuum({load});
    const double dt = 0.8 * frame.structures.critical_step();
    for (std::uint64_t n = 0; n < 3000; ++n) continuum.step({n, dt});
    std::vector<double> places;
    for (std::size_t i = 0; i < kBeams; ++i) {
      const std::size_t k = mirror > 0 ? i : (kBeams - i) % kBeams;
      places.push_back(continuum.ux()[k]);
      places.push_back(mirror * continuum.uy()[k]);
    }
    return places;
  };
  const auto one = moved(1), other = moved(-1);
  const double size = std::abs(*std::ranges::max_element(one, {}, [](double u) { return std::abs(u); }));
  double apart = 0;
  for (std::size_t i = 0; i < one.size(); ++i) apart = std::max(apart, std::abs(one[i] - other[i]));
  EXPECT_LE(apart, 1e-9 * size);
}

// A shaken ring whose joints open and close, in steps of this share of the critical one.
struct Shaken {
  double peak = 0, drift = 0;  // of kinetic and strain energy; of the ledger
  double least = 0, most = 0;  // dissipated
  int turns = 0;               // of a joint, from open to closed and back

  Shaken(const JointLaw& law, double share) {
    Frame frame = ring(law);
    const auto shake = [](double t) { return std::sin(60 * t); };
    Load squeeze = loads(0, 150e3);
    squeeze.factor = shake;
    const std::vector<std::uint32_t> invert{3 * kBeams / 4};
    Continuum continuum =
        frame.continuum({loads(100e3, 0), squeeze},
                        {PrescribedMotion{invert, Axis::kX, 0.3, shake}, fixed(invert, Axis::kY)});
    const double dt = share * frame.structures.critical_step();
    Energies first{}, now{};
    continuum.step({0, dt}, &first);
    const auto balance = [](const Energies& e) {
      return e.kinetic + e.strain + e.dissipated - e.external_work;
    };
    bool open = false;
    for (std::uint64_t n = 1; static_cast<double>(n) * dt < 0.8; ++n) {
      continuum.step({n, dt}, &now);
      peak = std::max({peak, now.kinetic, now.strain});
      drift = std::max(drift, std::abs(balance(now) - balance(first)));
      least = std::min(least, now.dissipated);
      most = std::max(most, now.dissipated);
      const bool opened =
          joint_use(frame.lining, continuum.structures(), frame.lining.joints[0]).largest_opening() > 1e-4;
      turns += opened != open;
      open = opened;
    }
  }
};

// The ledger is kept to rounding. Joints never give more energy than they got, whatever the step; without
// yield of bolts what they take vanishes with it.
TEST(RingOfSegments, KeepsTheLedgerAsItsJointsOpenAndClose) {
  for (const double share : {0.999, 0.1}) {
    const Shaken plain(faces(), share), with_bolts(bolted(), share);
    for (const Shaken* ring : {&plain, &with_bolts}) {
      EXPECT_LE(ring->drift, 1e-10 * ring->peak);
      EXPECT_GE(ring->least, -1e-10 * ring->peak);
      EXPECT_GE(ring->turns, 20);
    }
    EXPECT_LE(plain.most, (share < 0.5 ? 0.01 : 0.3) * plain.peak);
    EXPECT_GE(with_bolts.most, 0.05 * with_bolts.peak);
  }
}

// The same with beams that move by mean acceleration, in steps of the ground around them.
TEST(RingOfSegments, GivesNoEnergyInLongerSteps) {
  Grid grid = make_grid(Block{0, 8, 0, 4, 8, 4});
  Structures structures;
  const auto law = std::make_shared<const JointLaw>(faces());
  Path along{{}, false};
  for (std::uint32_t point = 18; point <= 26; ++point) along.points.push_back(point);
  const std::vector<LiningJoint> joints{{2, 0, 0, law}, {5, 0, 0, law}};
  const Lining roof = add_lining({"roof", along, wall(0.3), joints, true, false}, grid, structures);
  const PlaneLaw soft = plane_strain(50e6, 0.3);
  auto masses = lumped_masses(grid, ones(grid), 2000);
  structures.add_masses(masses);
  const double dt = 0.9 * critical_step(ZoneKind::kAssumedStrain, grid, soft, 2000);
  const auto shake = [](double t) { return std::sin(40 * t); };
  const std::vector<std::uint32_t> base{0, 1, 2, 3, 4, 5, 6, 7, 8};
  Continuum continuum{ZoneSet(ZoneKind::kAssumedStrain, grid, soft, ones(grid)),
                      masses,
                      {Load{{18, 26, 22, 24}, {4e5, -4e5, 0, 0}, {0, 0, -3e5, 2e5}, shake}},
                      {PrescribedMotion{base, Axis::kX, 0.5, shake}, fixed(base, Axis::kY)},
                      1,
                      structures};
  ASSERT_TRUE(continuum.longer_than_structures(dt));
  Energies first{}, now{};
  continuum.step({0, dt}, &first);
  double peak = 0, drift = 0, least = 0;
  int turns = 0;
  bool open = false;
  const auto balance = [](const Energies& e) {
    return e.kinetic + e.strain + e.dissipated - e.external_work;
  };
  for (std::uint64_t n = 1; n <= 60000; ++n) {
    continuum.step({n, dt}, &now);
    peak = std::max({peak, now.kinetic, now.strain});
    drift = std::max(drift, std::abs(balance(now) - balance(first)));
    least = std::min(least, now.dissipated);
    const bool opened = joint_use(roof, continuum.structures(), roof.joints[0]).largest_opening() > 1e-4;
    turns += opened != open;
    open = opened;
  }
  EXPECT_LE(drift, 1e-10 * peak);
  EXPECT_GE(least, -1e-10 * peak);
  EXPECT_LE(now.dissipated, 0.1 * peak);
  EXPECT_GE(turns, 10);
}

}  // namespace
}  // namespace adit::fdm::test::segment_joint_test
