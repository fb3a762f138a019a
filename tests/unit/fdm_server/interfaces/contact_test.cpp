// Requirements on the law of two faces that touch.
#include "fdm_server/interfaces/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace adit::fdm::test::contact_test {
namespace {

constexpr double kNormal = 2e9, kShear = 1e9;
constexpr double kNever = std::numeric_limits<double>::infinity();

ContactLaw law(const ContactStrength& peak, double residual_slip = kNever) {
  return {kNormal, kShear, peak, {0, peak.tan_friction / 2, 0, 0}, residual_slip};
}

// Whatever the way, work is never won: a thousand long strokes through sticking, sliding, open and closed
// faces.
TEST(Contact, NeverMakesEnergy) {
  std::mt19937 random(1);
  std::normal_distribution<double> way(0, 1e-4);
  for (const auto& it : {law({0, 0.5, 0, 0}), law({2e4, 0.5, 0.3, 1e4}), law({2e4, 0.5, 0.3, 1e4}, 1e-3),
                         law({2e4, 0.5, 0, 4e4}, 0), law({0, 0, 0, 5e4})}) {
    ContactState state;
    double work = 0;
    for (int i = 0; i < 1000; ++i) {
      const double du = way(random), ds = way(random);
      const ContactState before = state;
      const Stroke stroke = move(it, du, ds, state);
      work += stroke.normal * du + stroke.shear * ds;
      // Dilation opens faces against the pressure with work of friction.
      EXPECT_GE(dissipated(it, before, stroke, state),
                -1e-9 * (strain_energy(it, before) + strain_energy(it, state) + 1));
    }
    EXPECT_GE(work, strain_energy(it, state));
  }
}

// Whatever the size of a way, down to what numbers can tell: before a wave arrives only its rounding has.
TEST(Contact, BearsANumber) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-320, -3), factor(-1, 1);
  const auto way = [&] { return factor(random) * std::pow(10, exponent(random)); };
  for (const auto& it : {law({0, 0.05, 0, 0}), law({2e4, 0.5, 0.3, 1e4}), law({6e4, 0, 0, 3e4}, 0)})
    for (int i = 0; i < 200000; ++i) {
      ContactState state;
      for (int before = 0; before < 3; ++before) move(it, way(), way(), state);
      const double shear = std::abs(state.shear);
      const double du = way(), ds = way();
      const Stroke stroke = move(it, du, ds, state);
      const double sum = stroke.normal_slopes.by_normal + stroke.normal_slopes.by_shear +
                         stroke.shear_slopes.by_normal + stroke.shear_slopes.by_shear;
      ASSERT_TRUE(std::isfinite(stroke.normal + stroke.shear + sum)) << du << ' ' << ds;
      ASSERT_LE(std::abs(stroke.shear), shear + kShear * std::abs(ds) * (1 + 1e-9)) << du << ' ' << ds;
    }
}

// Faces without friction that meet and part give back all that they took, in strokes of any length.
TEST(Contact, GivesBackWhatItTook) {
  const ContactLaw smooth = law({0, 0, 0, 0});
  for (const double step : {1e-7, 3e-6, 7e-5}) {
    ContactState state;
    double work = 0;
    const auto go = [&](double way) {
      for (double gone = 0; std::abs(gone) < std::abs(way); gone += std::copysign(step, way)) {
        const double du = std::copysign(step, way);
        work += move(smooth, du, 0, state).normal * du;
      }
    };
    go(5e-5);
    go(-2e-4);
    EXPECT_GT(work, 0);
    go(3e-4);
    EXPECT_EQ(state.status, ContactStatus::kOpen);
    EXPECT_NEAR(work, 0, 1e-9);
  }
}

// A long stroke bears in its mean what a thousand short ones bear.
TEST(Contact, BearsTheMeanOfItsWay) {
  const ContactLaw it = law({1e4, 0.4, 0, 0});
  const auto after = [&](double du, double ds, int parts) {
    ContactState state;
    move(it, -1e-5, 2e-6, state);
    double work = 0;
    for (int i = 0; i < parts; ++i) {
      const Stroke stroke = move(it, du / parts, ds / parts, state);
      work += stroke.normal * du / parts + stroke.shear * ds / parts;
    }
    return work;
  };
  EXPECT_NEAR(after(0, 4e-5, 1) / after(0, 4e-5, 1000), 1, 1e-12);
  EXPECT_NEAR(after(0, -4e-5, 1) / after(0, -4e-5, 1000), 1, 1e-12);
  EXPECT_NEAR(after(5e-5, 0, 1) / after(5e-5, 0, 1000), 1, 1e-12);
  EXPECT_NEAR(after(-5e-5, 0, 1) / after(-5e-5, 0, 1000), 1, 1e-12);
}

// The slope of the means against the end of the stroke, by which Newton's method finds them.
TEST(Contact, KnowsItsSlopes) {
  const ContactLaw it = law({1e4, 0.4, 0.3, 2e4});
  const auto mean = [&](double start, double du, double ds, double sheared = 3e-6) {
    ContactState state;
    move(it, start, sheared, state);
    if (start > 0) state.closure = start;  // open by so much
    return move(it, du, ds, state);
  };
  constexpr double kLittle = 1e-10;
  const std::array<std::array<double, 2>, 3> starts{{{-2e-5, 3e-6}, {2e-5, 3e-6}, {-6e-5, 2e-5}}};
  for (const auto& [start, sheared] : starts)
    for (const double du : {-5e-5, -1e-6, 4e-5, 5.5e-5})
      for (const double ds : {0.0, 1e-6, 3e-5, 2e-4, -3e-5, -6e-5}) {
        const auto at = [&, start = start, sheared = sheared](double more_du, double more_ds) {
          return mean(start, du + more_du, ds + more_ds, sheared);
        };
        const Stroke here = at(0, 0);
        const auto [left, right] = std::pair(at(-kLittle, 0), at(kLittle, 0));
        const auto [back, ahead] = std::pair(at(0, -kLittle), at(0, kLittle));
        const auto expect = [&](double found, double from, double to, const char* which) {
          const double slope = (to - from) / (2 * kLittle);
          EXPECT_NEAR(found / kNormal, slope / kNormal, 1e-4) << which << start << ' ' << du << ' ' << ds;
        };
        expect(here.normal_slopes.by_normal, left.normal, right.normal, "normal by normal ");
        expect(here.normal_slopes.by_shear, back.normal, ahead.normal, "normal by shear ");
        expect(here.shear_slopes.by_normal, left.shear, right.shear, "shear by normal ");
        expect(here.shear_slopes.by_shear, back.shear, ahead.shear, "shear by shear ");
      }
}

// Newton's method finds a stroke whose forces depend continuously on where it ends, also where cohesion and
// tension are lost (faces that dilate press on each other as soon as they touch).
class ContactBears : public testing::TestWithParam<ContactStrength> {};

TEST_P(ContactBears, Continuously) {
  std::mt19937 random(2);
  std::normal_distribution<double> way(0, 1e-4);
  const ContactLaw it = law(GetParam());
  ContactState state;
  move(it, -1e-5, 0, state);  // without pressure and tension cohesion is lost by any opening
  for (int i = 0; i < 300; ++i) {
    const double du[] = {way(random), way(random)}, ds[] = {way(random), way(random)};
    constexpr int kParts = 2000;
    Stroke before{};
    for (int k = 0; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts;
      ContactState moved = state;
      const Stroke stroke = move(it, du[0] + t * (du[1] - du[0]), ds[0] + t * (ds[1] - ds[0]), moved);
      const double little = 5 * kNormal * (std::abs(du[1] - du[0]) + std::abs(ds[1] - ds[0])) / kParts;
      if (k > 0) {
        ASSERT_NEAR(stroke.normal, before.normal, little) << i << " at " << t;
        ASSERT_NEAR(stroke.shear, before.shear, little) << i << " at " << t;
      }
      before = stroke;
    }
    move(it, du[0], ds[0], state);
  }
}

INSTANTIATE_TEST_SUITE_P(Strengths, ContactBears,
                         testing::Values(ContactStrength{0, 0.5, 0, 0}, ContactStrength{6e4, 0.5, 0, 0},
                                         ContactStrength{6e4, 0, 0, 3e4}, ContactStrength{6e4, 0.5, 0, 1e5}));

// The same where the pressure falls below what the shear stress needs, and the slip turns back: the mean
// falls without a jump from what is left of the strength to its opposite, and what was lost is dissipated.
TEST(Contact, TurnsBackContinuouslyFromBeyondItsStrength) {
  const ContactLaw it = law({0, 0.5, 0, 0});
  ContactState loaded;
  move(it, -1e-4, 0, loaded);
  move(it, 0, 0.95 * 0.5 * kNormal * 1e-4 / kShear, loaded);
  for (const double du : {2e-5, 6e-5, 9e-5}) {
    constexpr int kParts = 4000;
    constexpr double kWay = -4e-4;
    double before = 0;
    for (int k = 0; k <= kParts; ++k) {
      const double ds = kWay * k / kParts;
      ContactState moved = loaded;
      const Stroke stroke = move(it, du, ds, moved);
      if (k > 0) {
        ASSERT_NEAR(stroke.shear, before, 2 * kShear * -kWay / kParts) << du << ' ' << ds;
      }
      ASSERT_GE(dissipated(it, loaded, stroke, moved), -1e-12) << du << ' ' << ds;
      before = stroke.shear;
    }
    EXPECT_LT(before, 0);
  }
}

// Slip at constant pressure: the shear stress is c + p tan(phi), and the faces open by slip tan(psi).
TEST(Contact, DilatesByItsAngle) {
  const ContactLaw it = law({1e4, 0.6, 0.2, 0});
  ContactState state;
  const double pressure = 5e4, strength = 1e4 + 0.6 * pressure;
  move(it, -pressure / kNormal, 0, state);
  const double yield = strength / kShear, slip = 1.6e-4;
  move(it, 0, yield, state);
  for (int i = 0; i < 100; ++i) {  // as far apart as slip opens them
    move(it, slip * 0.2 / 100, slip / 100, state);
    EXPECT_NEAR(normal_stress(it, state), -pressure, 1e-9 * pressure);
    EXPECT_NEAR(state.shear, strength, 1e-9 * strength);
  }
  EXPECT_NEAR(opening(state), slip * 0.2, 1e-12);
}

// Between rigid faces dilation raises the pressure by k_n slip tan(psi), and the strength with it: for the
// way s, k_s (s - l) = c + (p + k_n l tan(psi)) tan(phi).
TEST(Contact, DilationRaisesThePressureOfFacesThatCannotPart) {
  const ContactLaw it = law({0, 0.6, 0.2, 0});
  ContactState state;
  const double pressure = 5e4, way = 2e-4;
  move(it, -pressure / kNormal, 0, state);
  for (int i = 0; i < 100; ++i) move(it, 0, way / 100, state);
  const double slip = (kShear * way - 0.6 * pressure) / (kShear + kNormal * 0.6 * 0.2);
  EXPECT_NEAR(-normal_stress(it, state), pressure + kNormal * slip * 0.2, 1e-6 * pressure);
  EXPECT_NEAR(state.shear, 0.6 * (pressure + kNormal * slip * 0.2), 1e-6 * pressure);
}

// Strength falls to the residual one over the stated slip, tension is lost where faces part.
TEST(Contact, FallsToWhatIsLeft) {
  const ContactLaw it = law({2e4, 0.6, 0, 1e4}, 1e-3);
  ContactState state;
  const double pressure = 5e4;
  move(it, -pressure / kNormal, 0, state);
  for (int i = 0; i < 500; ++i) move(it, 0, 1e-6, state);
  // The slip l of the way s is s - tau/k_s; tau = peak - l/slip (peak - residual).
  const double peak = 2e4 + 0.6 * pressure, fall = (peak - 0.3 * pressure) / 1e-3;
  EXPECT_NEAR(state.shear, (peak - fall * 500e-6) / (1 - fall / kShear), 2e-3 * peak);
  for (int i = 0; i < 2000; ++i) move(it, 0, 1e-6, state);
  EXPECT_NEAR(state.shear, 0.3 * pressure, 1e-6 * pressure);

  ContactState torn;
  move(it, 0.9e4 / kNormal, 0, torn);
  EXPECT_NEAR(normal_stress(it, torn), 0.9e4, 1);
  move(it, 0.2e4 / kNormal, 0, torn);
  EXPECT_EQ(normal_stress(it, torn), 0);
  move(it, -2e4 / kNormal, 0, torn);
  EXPECT_NEAR(normal_stress(it, torn), -0.9e4, 1);
  move(it, 1e4 / kNormal, 0, torn);
  EXPECT_EQ(normal_stress(it, torn), 0);  // no tension any more
}

}  // namespace
}  // namespace adit::fdm::test::contact_test
