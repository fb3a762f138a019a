// Requirements on the hysteretic law at a point: its backbone is the curve, its loops are Masing's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "fdm_server/materials/hysteretic.hpp"

namespace adit::fdm::test {
namespace {

using std::numbers::pi;

const Elasticity kElasticity{400e6, 150e6};
constexpr double kReference = 1e-3;

Hysteretic hyperbolic(double exponent = 1, std::size_t elements = 60) {
  return Hysteretic(backbone(hyperbola(kReference, exponent), 2e-3 * kReference, 10 * kReference, elements));
}

// A point in simple shear.
struct Shear {
  const Hysteretic& law;
  std::vector<double> state = std::vector<double>(law.values(), 0.0);
  SolidStress stress{};
  double gamma = 0, dissipated = 0;

  double to(double strain, int steps) {
    const double from = gamma;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (strain - from) * i / steps;
      const double lost = law.add(kElasticity, {0, 0, 0, next - gamma}, state, stress);
      EXPECT_GE(lost, 0);
      dissipated += lost;
      gamma = next;
    }
    return stress.xy;
  }
};

// First loading follows the hyperbola within 1 % from a thousandth to ten times the reference strain; at the
// same time it is exactly the law's own backbone, in one step or in many.
TEST(Hysteretic, BackboneIsTheReductionCurve) {
  for (const double exponent : {1.0, 0.919}) {
    const auto law = hyperbolic(exponent);
    const auto curve = hyperbola(kReference, exponent);
    Shear many{law};
    for (double x = 1e-3; x < 10; x *= 1.07) {
      const double strain = x * kReference, tau = many.to(strain, 3);
      EXPECT_NEAR(tau, kElasticity.shear * law.stress(strain), 1e-12 * tau);
      EXPECT_NEAR(tau, kElasticity.shear * strain * curve(strain), 0.01 * tau) << x;
      EXPECT_NEAR(Shear{law}.to(strain, 1), tau, 1e-12 * tau);
    }
  }
}

// Closed form of Masing's damping of the hyperbola tau = G gamma/(1 + x), x = gamma/reference.
double masing_damping(double x) {
  return 4 / pi * (1 + 1 / x) * (1 - std::log1p(x) / x) - 2 / pi;
}

// Loops of constant amplitude: the secant modulus is the curve's, the damping ratio Masing's closed form
// within 1 %, and exactly that of the law's own backbone.
TEST(Hysteretic, LoopsHaveMasingsDamping) {
  const auto law = hyperbolic();
  for (const double x : {0.03, 0.1, 0.3, 1.0, 3.0, 8.0}) {
    const double amplitude = x * kReference;
    Shear point{law};
    const double tau = point.to(amplitude, 10);
    EXPECT_NEAR(point.to(-amplitude, 200), -tau, 1e-12 * tau);
    const double before = point.dissipated;
    double work = 0, last = point.stress.xy;
    for (const double goal : {amplitude, -amplitude})
      for (int i = 0, n = 2000; i < n; ++i) {
        const double from = point.gamma;
        const double now = point.to(-goal + 2 * goal * (i + 1) / n, 1);
        work += (last + now) / 2 * (point.gamma - from);
        last = now;
      }
    EXPECT_NEAR(last, -tau, 1e-11 * tau);
    EXPECT_NEAR(work, point.dissipated - before, 1e-11 * work);  // a closed loop stores nothing
    const double damping = work / (2 * pi * tau * amplitude);
    EXPECT_NEAR(damping, law.damping_ratio(amplitude), 0.002 * damping) << x;
    EXPECT_NEAR(damping, masing_damping(x), 0.01 * damping) << x;
  }
}

// Masing's extended rules on an irregular path: a branch from a reversal is the backbone doubled, it ends at
// the older branch that it meets and follows that, and nothing overshoots the backbone. Independent: a stack
// of reversal points.
class MasingRules {
 public:
  explicit MasingRules(const Hysteretic& law) : law_(law) {}
  double to(double strain) {
    const double direction = strain > last_ ? 1 : -1;
    if (direction != direction_) {
      if (direction_ != 0) turns_.push_back({last_, stress(last_)});
      direction_ = direction;
    }
    last_ = strain;
    // a loop is closed where the branch passes the reversal before the last
    while (turns_.size() >= 2 && direction * (strain - turns_[turns_.size() - 2].strain) >= 0)
      turns_.resize(turns_.size() - 2);
    // the backbone is reached again beyond the mirrored first reversal
    if (turns_.size() == 1 && std::abs(strain) >= std::abs(turns_[0].strain) &&
        direction * turns_[0].strain < 0)
      turns_.clear();
    return stress(strain);
  }

 private:
  struct Turn {
    double strain, stress;
  };
  double stress(double strain) const {
    if (turns_.empty()) return std::copysign(kElasticity.shear * law_.stress(std::abs(strain)), strain);
    const auto& [from, at] = turns_.back();
    const double half = (strain - from) / 2;
    return at + 2 * std::copysign(kElasticity.shear * law_.stress(std::abs(half)), half);
  }
  const Hysteretic& law_;
  std::vector<Turn> turns_;
  double last_ = 0, direction_ = 0;
};

TEST(Hysteretic, IrregularLoadingFollowsMasingsExtendedRules) {
  const auto law = hyperbolic();
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1.5 * kReference);
  Shear point{law};
  MasingRules rules(law);
  for (int reversal = 0; reversal < 400; ++reversal) {
    const double from = point.gamma, goal = normal(random);
    for (int i = 1; i <= 20; ++i) {
      const double strain = from + (goal - from) * i / 20;
      const double tau = point.to(strain, 1);
      ASSERT_NEAR(tau, rules.to(strain), 1e-9 * kElasticity.shear * kReference) << reversal;
      ASSERT_LE(std::abs(tau), kElasticity.shear * law.backbone().back().stress * (1 + 1e-12));
    }
  }
}

// On any path in the plane, from any initial stress: the work is what is stored and what is dissipated, to
// rounding.
TEST(Hysteretic, WorkIsStoredOrDissipated) {
  const auto law = hyperbolic(0.919);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 4e-4);
  std::vector<double> state(law.values());
  SolidStress stress{-200e3, -500e3, -230e3, 40e3};
  law.set_stress(state, stress);
  const double first = law.energy(kElasticity, state, stress);
  double work = 0, dissipated = 0, size = 0;
  for (int i = 0; i < 3000; ++i) {
    const Strain strain{normal(random), normal(random), 0, normal(random)};
    const auto before = stress;
    const double lost = law.add(kElasticity, strain, state, stress);
    ASSERT_GE(lost, 0);
    dissipated += lost;
    work += product(before + stress, strain) / 2;
    size += std::abs(product(before + stress, strain) / 2);
  }
  EXPECT_NEAR(law.energy(kElasticity, state, stress) - first + dissipated, work, 1e-12 * size);
}

// Iwan's elements one after another, as their definition says: (xx - yy)/2, xy and zz of each.
struct Elements {
  std::vector<double> stiffness, limit, t, s, z;

  explicit Elements(const Hysteretic& law) {
    const auto curve = law.backbone();
    double slope = 1;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const double next = k + 1 < curve.size() ? (curve[k + 1].stress - curve[k].stress) /
                                                     (curve[k + 1].strain - curve[k].strain)
                                               : 0;
      stiffness.push_back((slope - next) * kElasticity.shear);
      limit.push_back(stiffness.back() * curve[k].strain);
      slope = next;
    }
    t = s = z = std::vector<double>(curve.size(), 0.0);
  }
  // Their sum.
  std::array<double, 3> add(const Strain& strain) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < t.size(); ++i) {
      t[i] += stiffness[i] * (strain.xx - strain.yy);
      s[i] += stiffness[i] * strain.xy;
      z[i] -= stiffness[i] * 2 * (strain.xx + strain.yy) / 3;
      const double ratio = limit[i] / std::sqrt(t[i] * t[i] + s[i] * s[i] + 0.75 * z[i] * z[i]);
      if (ratio < 1)
        for (double* part : {&t[i], &s[i], &z[i]}) *part *= ratio;
      sum = {sum[0] + t[i], sum[1] + s[i], sum[2] + z[i]};
    }
    return sum;
  }
};

// Elements that sleep until they could yield have the stress of elements that are all computed in every step,
// to 1e-12 of it: a million strains of elements, slow and fast, in any direction, there and back.
TEST(Hysteretic, SleepingElementsAreThoseThatAreAlwaysAwake) {
  const auto law = hyperbolic();
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal(0, 1);
  Elements elements(law);
  std::vector<double> state(law.values(), 0.0);
  SolidStress stress{};
  Strain direction{};
  double speed = 0;
  for (int i = 0; i < 1000000 / 60; ++i) {
    if (i % 20 == 0) {
      speed = std::pow(10, -7 + 3 * std::abs(std::sin(i)));
      direction = i % 40 == 0 ? Strain{normal(random), normal(random), 0, normal(random)}
                              : Strain{-direction.xx, -direction.yy, 0, -direction.xy};
    }
    const Strain strain{speed * direction.xx, speed * direction.yy, 0, speed * direction.xy};
    law.add(kElasticity, strain, state, stress);
    const auto [t, s, z] = elements.add(strain);
    const double mean = (stress.xx + stress.yy + stress.zz) / 3, size = std::hypot(t, s, z);
    ASSERT_NEAR((stress.xx - stress.yy) / 2, t, 1e-12 * (size + std::abs(mean))) << i;
    ASSERT_NEAR(stress.xy, s, 1e-12 * (size + std::abs(mean))) << i;
    ASSERT_NEAR(stress.zz - mean, z, 1e-12 * (size + std::abs(mean))) << i;
  }
}

// The initial stress is where the curve begins: shear from it has the same loops, and volume changes
// elastically.
TEST(Hysteretic, CurveBeginsAtTheInitialStress) {
  const auto law = hyperbolic();
  Shear fresh{law}, loaded{law};
  loaded.stress = {-100e3, -300e3, -100e3, 0};
  law.set_stress(loaded.state, loaded.stress);
  EXPECT_NEAR(loaded.to(2e-3, 10), fresh.to(2e-3, 10), 1e-9);
  EXPECT_NEAR(loaded.stress.xx + loaded.stress.yy + loaded.stress.zz, -500e3, 1e-6);
}

// A measured table: monotone between its points, through them, and followed by the law within 1 % of the
// strength where the curve itself does not stiffen.
TEST(Hysteretic, TableIsFollowed) {
  const std::vector<double> strain{1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
  const std::vector<double> ratio{1, 0.985, 0.945, 0.83, 0.61, 0.33, 0.15, 0.06};
  const auto curve = smooth_table(strain, ratio);
  for (std::size_t i = 0; i < strain.size(); ++i) EXPECT_NEAR(curve(strain[i]), ratio[i], 1e-12);
  double last = 1;
  for (double x = 1e-6; x < 1e-2; x *= 1.01) {
    EXPECT_LE(curve(x), last + 1e-12);
    last = curve(x);
  }
  const Hysteretic law(backbone(curve, 1e-6, 1e-2, 32));
  for (const double x : {2e-5, 1e-4, 2e-4, 1e-3, 3e-3, 1e-2})
    EXPECT_NEAR(law.stress(x) / x, curve(x), 0.012 * curve(x)) << x;
}

// The largest error of a table of a hyperbola whose points lie unevenly over the logarithm of the strain.
double error_of_uneven_table(double step) {
  const auto exact = hyperbola(1e-3, 1);
  std::vector<double> strain{1e-5}, ratio{exact(1e-5)};
  for (bool wide = true; strain.back() < 0.1; wide = !wide) {
    strain.push_back(strain.back() * std::exp(wide ? step : step / 4));
    ratio.push_back(exact(strain.back()));
  }
  const auto curve = smooth_table(strain, ratio);
  double largest = 0;
  for (double x = 2e-4; x < 5e-3; x *= 1.01) largest = std::max(largest, std::abs(curve(x) - exact(x)));
  return largest;
}

// Uneven points leave the table as accurate as its slopes are: at most half of what chords that are weighed
// the wrong way round would give, which is 1.5e-3 and 3.8e-4.
TEST(Hysteretic, UnevenTableFollowsItsCurve) {
  EXPECT_LT(error_of_uneven_table(0.5), 8e-4);
  EXPECT_LT(error_of_uneven_table(0.25), 2e-4);
}

}  // namespace
}  // namespace adit::fdm::test
