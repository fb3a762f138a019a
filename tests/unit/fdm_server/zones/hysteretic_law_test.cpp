// Requirements on zones with Iwan's elements: the backbone is the curve, loops are Masing's, energy is
// accounted for; asleep or awake, alone or in batches that begin and end anywhere, elements have the stress
// of their definition.
#include "fdm_server/zones/laws/hysteretic_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "fdm_server/hysteresis/polyline.hpp"
#include "tests/support/hysteretic_zone.hpp"
#include "tests/support/iwan_point.hpp"

namespace adit::fdm::test::hysteretic_law_test {
namespace {

using std::numbers::pi;

constexpr Elasticity kElasticity{400e6, 150e6};
constexpr double kReference = 1e-3;

std::vector<BackbonePoint> hyperbolic(double exponent = 1) {
  return backbone(hyperbola(kReference, exponent), 2e-3 * kReference, 10 * kReference, 60);
}

// A zone in simple shear.
struct Shear {
  HystereticZone zone;
  double gamma = 0, dissipated = 0;

  explicit Shear(const Polyline& line) : zone(kElasticity, iwan_elements(line.backbone())) {}

  double to(double strain, int steps) {
    const double from = gamma;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (strain - from) * i / steps;
      const double lost = zone.add({0, 0, 0, next - gamma});
      EXPECT_GE(lost, 0);
      dissipated += lost;
      gamma = next;
    }
    return zone.stress().xy;
  }
};

// First loading follows the hyperbola within 1 % from a thousandth to ten times the reference strain; at the
// same time it is exactly its own backbone, in one step or in many.
TEST(HystereticLaw, BackboneIsTheReductionCurve) {
  for (const double exponent : {1.0, 0.919}) {
    const Polyline line(hyperbolic(exponent));
    const auto curve = hyperbola(kReference, exponent);
    Shear many(line);
    for (double x = 1e-3; x < 10; x *= 1.07) {
      const double strain = x * kReference, tau = many.to(strain, 3);
      EXPECT_NEAR(tau, kElasticity.shear * line.stress(strain), 1e-12 * tau);
      EXPECT_NEAR(tau, kElasticity.shear * strain * curve(strain), 0.01 * tau) << x;
      EXPECT_NEAR(Shear(line).to(strain, 1), tau, 1e-12 * tau);
    }
  }
}

// Closed form of Masing's damping of the hyperbola tau = G gamma/(1 + x), x = gamma/reference.
double masing_damping(double x) {
  return 4 / pi * (1 + 1 / x) * (1 - std::log1p(x) / x) - 2 / pi;
}

// Loops of constant amplitude: the secant modulus is the curve's, the damping ratio Masing's closed form
// within 1 %, and exactly that of its backbone.
TEST(HystereticLaw, LoopsHaveMasingsDamping) {
  const Polyline line(hyperbolic());
  for (const double x : {0.03, 0.1, 0.3, 1.0, 3.0, 8.0}) {
    const double amplitude = x * kReference;
    Shear point(line);
    const double tau = point.to(amplitude, 10);
    EXPECT_NEAR(point.to(-amplitude, 200), -tau, 1e-12 * tau);
    const double before = point.dissipated;
    double work = 0, last = point.zone.stress().xy;
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
    EXPECT_NEAR(damping, line.masing_damping(amplitude), 0.002 * damping) << x;
    EXPECT_NEAR(damping, masing_damping(x), 0.01 * damping) << x;
  }
}

// Masing's extended rules on an irregular path: a branch from a reversal is the backbone doubled, it ends at
// the older branch that it meets and follows that, and nothing overshoots the backbone. Independent: a stack
// of reversal points.
class MasingRules {
 public:
  explicit MasingRules(const Polyline& line) : line_(line) {}
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
    if (turns_.empty()) return std::copysign(kElasticity.shear * line_.stress(std::abs(strain)), strain);
    const auto& [from, at] = turns_.back();
    const double half = (strain - from) / 2;
    return at + 2 * std::copysign(kElasticity.shear * line_.stress(std::abs(half)), half);
  }
  const Polyline& line_;
  std::vector<Turn> turns_;
  double last_ = 0, direction_ = 0;
};

TEST(HystereticLaw, IrregularLoadingFollowsMasingsExtendedRules) {
  const Polyline line(hyperbolic());
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1.5 * kReference);
  Shear point(line);
  MasingRules rules(line);
  for (int reversal = 0; reversal < 400; ++reversal) {
    const double from = point.gamma, goal = normal(random);
    for (int i = 1; i <= 20; ++i) {
      const double strain = from + (goal - from) * i / 20;
      const double tau = point.to(strain, 1);
      ASSERT_NEAR(tau, rules.to(strain), 1e-9 * kElasticity.shear * kReference) << reversal;
      ASSERT_LE(std::abs(tau), kElasticity.shear * line.backbone().back().stress * (1 + 1e-12));
    }
  }
}

// On any path in the plane, from any initial stress: the work is what is stored and what is dissipated, to
// rounding.
TEST(HystereticLaw, WorkIsStoredOrDissipated) {
  HystereticZone zone(kElasticity, iwan_elements(hyperbolic(0.919)));
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 4e-4);
  zone.set_stress({-200e3, -500e3, -230e3, 40e3});
  const double first = zone.energy();
  double work = 0, dissipated = 0, size = 0;
  for (int i = 0; i < 3000; ++i) {
    const Strain strain{normal(random), normal(random), 0, normal(random)};
    const auto before = zone.stress();
    const double lost = zone.add(strain), done = product(before + zone.stress(), strain) / 2;
    ASSERT_GE(lost, 0);
    dissipated += lost;
    work += done;
    size += std::abs(done);
  }
  EXPECT_NEAR(zone.energy() - first + dissipated, work, 1e-12 * size);
}

// Elements that sleep until they could yield have the stress of elements that are all computed in every step,
// to 1e-12 of it: a million strains of elements, slow and fast, in any direction, there and back.
TEST(HystereticLaw, SleepingElementsAreThoseThatAreAlwaysAwake) {
  const Polyline line(hyperbolic());
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal(0, 1);
  const IwanElements elements = iwan_elements(line.backbone());
  IwanPoint point(kElasticity, elements);
  HystereticZone zone(kElasticity, elements);
  Strain direction{};
  double speed = 0;
  for (int i = 0; i < 1000000 / 60; ++i) {
    if (i % 20 == 0) {
      speed = std::pow(10, -7 + 3 * std::abs(std::sin(i)));
      direction = i % 40 == 0 ? Strain{normal(random), normal(random), 0, normal(random)}
                              : Strain{-direction.xx, -direction.yy, 0, -direction.xy};
    }
    const Strain strain{speed * direction.xx, speed * direction.yy, 0, speed * direction.xy};
    zone.add(strain);
    const auto [t, s, z, lost] = point.add(strain.xx + strain.yy, strain.xx - strain.yy, strain.xy);
    const SolidStress stress = zone.stress();
    const double mean = (stress.xx + stress.yy + stress.zz) / 3, size = std::hypot(t, s, z);
    ASSERT_NEAR((stress.xx - stress.yy) / 2, t, 1e-12 * (size + std::abs(mean))) << i;
    ASSERT_NEAR(stress.xy, s, 1e-12 * (size + std::abs(mean))) << i;
    ASSERT_NEAR(stress.zz - mean, z, 1e-12 * (size + std::abs(mean))) << i;
  }
}

// The initial stress is where the curve begins: shear from it has the same loops, and volume changes
// elastically.
TEST(HystereticLaw, CurveBeginsAtTheInitialStress) {
  const Polyline line(hyperbolic());
  Shear fresh(line), loaded(line);
  loaded.zone.set_stress({-100e3, -300e3, -100e3, 0});
  EXPECT_NEAR(loaded.to(2e-3, 10), fresh.to(2e-3, 10), 1e-9);
  const SolidStress stress = loaded.zone.stress();
  EXPECT_NEAR(stress.xx + stress.yy + stress.zz, -500e3, 1e-6);
}

TEST(HystereticLaw, ZonesTogetherAreSinglePoints) {
  const auto curve = backbone(hyperbola(2e-4, 1), 4e-7, 2e-3, 41);
  const IwanElements elements = iwan_elements(curve);
  constexpr std::uint32_t kZones = 61;
  HystereticLaw law(kElasticity, elements, kZones, false);
  StressFields stresses(kZones);
  std::vector<double> dissipated(kZones, 0.0), lost(kZones, 0.0);
  std::vector<IwanPoint> points(4 * kZones, IwanPoint(kElasticity, elements));
  const auto strains = std::make_unique<StrainBatch>();
  const auto areas = std::make_unique<PointValues>();
  for (auto& of_point : *areas) of_point.fill(0.5);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1);
  const double limit = 1e-12 * kElasticity.shear * curve.back().stress;
  for (int step = 0; step < 1500; ++step) {
    const std::uint32_t cut = 1 + random() % (kZones - 1);  // zones of two batches
    for (const auto& [first, count] : {std::pair{0u, cut}, {cut, kZones - cut}}) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const double phase = 0.05 * step * (1 + 0.03 * (first + i));
        const double size = (first + i) % 8 == 3 ? 1e-11 : 3e-5 * std::sin(phase) * std::sin(0.01 * step);
        strains->volume[i] = 0.3 * size * normal(random);
        for (std::size_t k = 0; k < 4; ++k) {
          strains->difference[k][i] = size * (1 + 0.2 * normal(random));
          strains->shear[k][i] = size * (std::cos(phase) + 0.2 * normal(random));
        }
      }
      law.advance({first, count, *areas, *strains, view(stresses, first), &dissipated[first]});
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t zone = first + i;
        double across = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const auto sum =
              points[4 * zone + k].add(strains->volume[i], strains->difference[k][i], strains->shear[k][i]);
          ASSERT_NEAR(stresses[kDifference + k][zone], sum.difference, limit) << step;
          ASSERT_NEAR(stresses[kShearStress + k][zone], sum.shear, limit) << step;
          across += sum.across / 4;
          lost[zone] += 0.5 * sum.dissipated;
        }
        const double pressure = (2 * stresses[kMeanStress][zone] + stresses[kAcross][zone]) / 3;
        ASSERT_NEAR(stresses[kAcross][zone] - pressure, across, limit + 1e-12 * std::abs(pressure)) << step;
        ASSERT_NEAR(dissipated[zone], lost[zone], 1e-12 * lost[zone]) << step;
      }
    }
  }
  EXPECT_GT(lost[0], 0);
  EXPECT_EQ(lost[3], 0);
}

}  // namespace
}  // namespace adit::fdm::test::hysteretic_law_test
