// Requirements on linings at rest, found by relaxation: closed forms of beams, rings and joints.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::statics_test {
namespace {

using std::numbers::pi;

constexpr double kThickness = 0.4, kLength = 5, kForce = 1e5;

struct Tip {
  double deflection, moment;  // at the free end; at the fixed one
};

// A cantilever along an oblique line under a force across its end, or the same spread evenly.
Tip cantilever(const Section& section, std::size_t beams, bool spread) {
  constexpr double kAngle = 0.6;
  const Frame frame(line(kLength, beams, kAngle), false, section, {}, {true, false});
  Load load{{}, {}, {}, constant};
  for (std::uint32_t i = 0; i <= beams; ++i) {
    const double end = i == 0 || i == beams ? 0.5 : 1;
    const double share = spread ? end / static_cast<double>(beams) : (i == beams ? 1.0 : 0.0);
    load.points.push_back(i);
    load.fx.push_back(-share * kForce * std::sin(kAngle));
    load.fy.push_back(share * kForce * std::cos(kAngle));
  }
  Continuum continuum = frame.continuum({load}, {fixed({0}, Axis::kX), fixed({0}, Axis::kY)});
  settle(continuum, 0.9 * frame.structures.critical_step());
  return {std::cos(kAngle) * continuum.uy()[beams] - std::sin(kAngle) * continuum.ux()[beams],
          forces_at(frame.lining, continuum.structures(), 0).moment};
}

// Loads at nodes: exact for any number of beams, in either theory.
TEST(LiningStatics, CantileverUnderATipLoadIsExact) {
  for (const bool shear : {true, false})
    for (const std::size_t beams : {1, 3, 8}) {
      const Section section = wall(kThickness, shear);
      const double deflection =
          kForce * std::pow(kLength, 3) / (3 * section.bending) + kForce * kLength / section.shear;
      const Tip tip = cantilever(section, beams, false);
      EXPECT_NEAR(tip.deflection / deflection, 1, 1e-9);
      EXPECT_NEAR(tip.moment / (kForce * kLength), 1, 1e-9);
    }
}

// A spread load, lumped to the nodes: second order.
TEST(LiningStatics, CantileverUnderASpreadLoadConverges) {
  const Section section = wall(kThickness);
  const double deflection =
      kForce * std::pow(kLength, 3) / (8 * section.bending) + kForce * kLength / (2 * section.shear);
  const double coarse = std::abs(cantilever(section, 4, true).deflection / deflection - 1);
  const double fine = std::abs(cantilever(section, 8, true).deflection / deflection - 1);
  EXPECT_LE(fine, 0.01);
  EXPECT_GE(std::log2(coarse / fine), 1.95);
}

constexpr double kRadius = 3, kPressure = 2e5;

// The load p(theta) along the outward normal at the nodes of a ring.
template <class Pressure>
Load radial(const Grid& grid, Pressure&& pressure) {
  Load load{{}, {}, {}, constant};
  const auto count = static_cast<double>(grid.x.size());
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    const double angle = std::atan2(grid.y[i], grid.x[i]);
    const double share = pressure(angle) * 2 * pi * kRadius / count;
    load.points.push_back(i);
    load.fx.push_back(share * std::cos(angle));
    load.fy.push_back(share * std::sin(angle));
  }
  return load;
}

struct Ring {
  double thrust, moment, displacement;  // of node 0, outward
  double crown_moment;
};
template <class Pressure>
Ring ring(const Section& section, std::size_t beams, Pressure&& pressure,
          std::vector<LiningJoint> joints = {}) {
  const Frame frame(circle(kRadius, beams), true, section, std::move(joints));
  Continuum continuum = frame.continuum({radial(frame.grid, pressure)});
  settle(continuum, 0.9 * frame.structures.critical_step());
  const auto side = forces_at(frame.lining, continuum.structures(), 0);
  const auto crown = forces_at(frame.lining, continuum.structures(), beams / 4);
  return {side.thrust, side.moment, continuum.ux()[0], crown.moment};
}

// What the polygon makes of a moment: (1 + c/n^2) of it in second order, c just above 10.
constexpr double kPolygon = 10.5;

double ovaling(double angle) {
  return kPressure * std::cos(2 * angle);
}

// Uniform pressure from inside: thrust p R, radial displacement p R^2/EA, in second order; no moment but
// that of the polygon's corners.
TEST(LiningStatics, RingUnderUniformPressure) {
  const Section section = wall(kThickness);
  std::array<double, 2> thrust{}, displacement{};
  for (const std::size_t beams : {24, 48}) {
    const Ring found = ring(section, beams, [](double) { return kPressure; });
    thrust[beams == 48] = std::abs(found.thrust / (kPressure * kRadius) - 1);
    displacement[beams == 48] =
        std::abs(found.displacement / (kPressure * kRadius * kRadius / section.axial) - 1);
    EXPECT_LE(std::abs(found.moment), 1e-8 * kPressure * kRadius * kRadius);
  }
  EXPECT_LE(thrust[1], 3e-3);
  EXPECT_GE(std::log2(thrust[0] / thrust[1]), 1.95);
  EXPECT_GE(std::log2(displacement[0] / displacement[1]), 1.95);
}

// Ovaling pressure p cos 2theta. Equilibrium alone gives M = m cos 2theta, N = n cos 2theta, Q = q sin
// 2theta with |m| = p R^2/3, |n| = p R/3, |q| = 2 p R/3; the work p u/2 equals the energy of all three:
// u = (m^2/EI + n^2/EA + q^2/GA_s)/p.
TEST(LiningStatics, RingUnderOvalingPressure) {
  for (const bool shear : {true, false}) {
    const Section section = wall(kThickness, shear);
    const double m = kPressure * kRadius * kRadius / 3, n = kPressure * kRadius / 3, q = 2 * n;
    const double u = (m * m / section.bending + n * n / section.axial + q * q / section.shear) / kPressure;
    std::array<double, 2> error{};
    for (const std::size_t beams : {24, 48}) {
      const Ring found = ring(section, beams, ovaling);
      error[beams == 48] = std::abs(found.displacement / u - 1);
      // drawn out along x, the ring is more curved there: the moment stretches its outside
      EXPECT_NEAR(found.moment / m, 1, kPolygon / (beams * beams));
      EXPECT_NEAR(found.crown_moment / m, -1, kPolygon / (beams * beams));
      EXPECT_NEAR(found.thrust / n, -1, 3 * kPolygon / (beams * beams));
    }
    EXPECT_LE(error[1], 5e-3);
    EXPECT_GE(std::log2(error[0] / error[1]), 1.9);
  }
}

// Joints at crown and invert: the same moments and a constant X that closes the ring:
//   2 pi R X/EI + 2 (X - m)/k = 0.  A hinge carries no moment.
TEST(LiningStatics, RingWithJoints) {
  const Section section = wall(kThickness);
  constexpr std::size_t kBeams = 48;
  const double m = kPressure * kRadius * kRadius / 3;
  for (const double stiffness : {0.0, section.bending / kRadius, 20 * section.bending / kRadius}) {
    const double x = m / (1 + pi * kRadius * stiffness / section.bending);
    const double inf = std::numeric_limits<double>::infinity();
    const Ring found =
        ring(section, kBeams, ovaling, {{kBeams / 4, stiffness, inf}, {3 * kBeams / 4, stiffness, inf}});
    EXPECT_NEAR(found.moment / m, 1 + x / m, 2 * kPolygon / (kBeams * kBeams));
    EXPECT_NEAR(found.crown_moment / m, -1 + x / m, kPolygon / (kBeams * kBeams));
    if (stiffness == 0) {
      EXPECT_LE(std::abs(found.crown_moment), 1e-8 * m);
    }
  }
}

// A joint that yields carries its yield moment, and the rest of the ring what equilibrium then needs.
TEST(LiningStatics, RingWithYieldingJoints) {
  const Section section = wall(kThickness);
  constexpr std::size_t kBeams = 48;
  const double m = kPressure * kRadius * kRadius / 3, yield = 0.3 * m;
  const double stiffness = 20 * section.bending / kRadius;
  const Ring found =
      ring(section, kBeams, ovaling, {{kBeams / 4, stiffness, yield}, {3 * kBeams / 4, stiffness, yield}});
  EXPECT_NEAR(found.crown_moment, -yield, 1e-6 * m);
  EXPECT_NEAR(found.moment / m, 2 - 0.3, 0.01);
}

}  // namespace
}  // namespace adit::fdm::test::statics_test
