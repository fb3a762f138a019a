// Requirements on the capacity of sections: thrust and moment at the strain limits, moments at a curvature
// and the utilisation are those of a hand calculation by strain compatibility.
#include "protocol/sections/capacity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_section.hpp"

namespace adit::sections::test::capacity_test {
namespace {

// The hand calculation's limit state with the neutral axis at this depth.
HandForces at_limit(const HandSection& of, double x) {
  double deepest = 0;
  for (const auto& [depth, area] : of.bars) deepest = std::max(deepest, depth);
  const double h = of.thickness;
  if (x > h) {  // pivot C
    const double fixed = (1 - of.peak / of.ultimate) * h;
    const double curvature = of.peak / (x - fixed);
    return hand_forces(of, curvature * x, curvature);
  }
  // Pivot B, or A where the bars would reach their limit.
  const double curvature = std::min(of.ultimate / x, of.limit / (deepest - x > 0 ? deepest - x : 1e-9));
  return hand_forces(of, curvature * x, curvature);
}

// Requirement: the ultimate moments of ten sections, at thrusts from tension-controlled to wholly compressed
// ones and with either face stretched, are within 1 % of the hand calculation.
TEST(Capacity, UltimateMomentsAreThoseOfTheHandCalculation) {
  for (const HandSection& of : ten_sections()) {
    const Capacity capacity = capacity_of(of);
    for (const double share : {0.08, 0.15, 0.25, 0.4, 0.6, 0.8, 0.95, 1.1, 1.4, 2.0}) {
      const double x = share * of.thickness;
      const HandForces outer = at_limit(of, x), inner = at_limit(turned(of), x);
      const double scale = std::abs(at_limit(of, 0.5 * of.thickness).moment);
      EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, outer.thrust), outer.moment,
                  0.01 * std::max(std::abs(outer.moment), 0.1 * scale))
          << of.name << ", x = " << x;
      EXPECT_NEAR(capacity.moment(Bending::kInnerStretched, inner.thrust), -inner.moment,
                  0.01 * std::max(std::abs(inner.moment), 0.1 * scale))
          << of.name << ", x = " << x;
    }
  }
}

// Requirement: in pure tension all bars yield; in pure compression the strain is eps_c2 throughout.
TEST(Capacity, EndsInPureTensionAndCompression) {
  for (const HandSection& of : ten_sections()) {
    const Capacity capacity = capacity_of(of);
    double tension = 0, compression = -of.concrete * of.thickness * of.width;
    for (const auto& [depth, area] : of.bars) {
      tension += area * of.steel;
      compression -= area * (std::min(of.modulus * of.peak, of.steel) - of.concrete);
    }
    EXPECT_NEAR(capacity.largest_thrust(), tension, 1e-9 * tension) << of.name;
    EXPECT_NEAR(capacity.least_thrust(), compression, -1e-9 * compression) << of.name;
  }
}

// Requirement: below the limit, the moment at a curvature and a thrust is within 1 % of the hand calculation.
TEST(Capacity, MomentAtACurvatureIsThatOfTheHandCalculation) {
  for (const HandSection& of : ten_sections()) {
    const Capacity capacity = capacity_of(of);
    const double squash = of.concrete * of.thickness * of.width;
    for (const double thrust : {0.0, -0.1 * squash, -0.3 * squash})
      for (const double reach : {0.0005, 0.001, 0.002, 0.004, 0.006}) {
        const double curvature = reach / of.thickness;
        double low = -0.05, high = 0.05;  // the strain of the compressed face
        for (int i = 0; i < 100; ++i) {
          const double middle = (low + high) / 2;
          (hand_forces(of, middle, curvature).thrust > thrust ? low : high) = middle;
        }
        const double moment = hand_forces(of, low, curvature).moment;
        EXPECT_NEAR(capacity.moment_at_curvature(thrust, curvature), moment, 0.01 * moment)
            << of.name << ", N = " << thrust << ", curvature " << curvature;
      }
  }
}

// Requirement: a state at the limit has a utilisation of 1, half of its thrust and moment one of 1/2, and
// none where nothing acts.
TEST(Capacity, UtilisationIsOneAtTheLimit) {
  for (const HandSection& of : ten_sections()) {
    const Capacity capacity = capacity_of(of);
    for (const double share : {0.1, 0.2, 0.35, 0.6, 0.9, 1.2, 1.8}) {
      const HandForces outer = at_limit(of, share * of.thickness),
                       inner = at_limit(turned(of), share * of.thickness);
      EXPECT_NEAR(capacity.utilisation({outer.thrust, outer.moment}), 1, 0.01) << of.name << ' ' << share;
      EXPECT_NEAR(capacity.utilisation({inner.thrust, -inner.moment}), 1, 0.01) << of.name << ' ' << share;
      EXPECT_NEAR(capacity.utilisation({outer.thrust / 2, outer.moment / 2}), 0.5, 0.005) << of.name;
    }
    const SectionForces tension = capacity.limit(Bending::kOuterStretched, 0);
    EXPECT_NEAR(capacity.utilisation({2 * tension.thrust, 2 * tension.moment}), 2, 0.02) << of.name;
    EXPECT_EQ(capacity.utilisation({0, 0}), 0);
  }
}

// Requirement: fibres of residual strength f_Ftu by the rigid-plastic model give a section without bars the
// moment f b h^2/2 of a thin compressed zone, less its share x/h of the depth.
TEST(Capacity, FibresResistWithoutBars) {
  const double h = 0.35, residual = 1.5e6, strength = 40e6;
  const Capacity capacity({h, 1, {}},
                          {{strength, 0.002, 0.0035, 2}, 200e9, 435e6, 0.045, {residual, residual, 0.02}});
  // A zone of depth y at the full strength: f_c y = f_Ftu (h - y).
  const double y = residual * h / (residual + strength);
  EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, 0), residual * (h - y) * h / 2,
              0.015 * residual * h * h / 2);
  EXPECT_NEAR(capacity.largest_thrust(), residual * h, 1e-9 * residual * h);
}

}  // namespace
}  // namespace adit::sections::test::capacity_test
