// Requirements on hysteresis with a memory of reversals: in simple shear it is Iwan's elements, on any path
// it is its definition by nested spheres, its energy is accounted for, its loops have the damping that was
// given.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fdm_server/hysteresis/reversals.hpp"
#include "protocol/errors.hpp"
#include "tests/support/iwan_point.hpp"

namespace adit::fdm::test::reversals_test {
namespace {

using std::numbers::pi;

constexpr double kReference = 1e-3;
constexpr ZoneStrain kWeights{0.1, 0.2, 0.3, 0.4, 0.1, 0.2, 0.3, 0.4, 0.75};

std::vector<BackbonePoint> curve(std::size_t elements = 60) {
  return backbone(hyperbola(kReference, 0.919), 1e-3 * kReference, 10 * kReference, elements);
}

double inner(const ZoneStrain& a, const ZoneStrain& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kZoneStrains; ++i) sum += kWeights[i] * a[i] * b[i];
  return sum;
}

// A zone with its stress, work and dissipated energy.
struct Zone {
  const Polyline& line;
  ZoneMemory memory = {};
  ZoneStrain strain = {}, stress = {};
  double work = 0, size = 0, dissipated = 0, least = 0;

  void add(const ZoneStrain& step) {
    const auto [growth, lost] = advance(line.view(), kWeights, step, memory);
    ZoneStrain mean;
    for (std::size_t i = 0; i < kZoneStrains; ++i) {
      mean[i] = stress[i] + growth[i] / 2;
      stress[i] += growth[i];
      strain[i] += step[i];
    }
    work += inner(mean, step);
    size += std::abs(inner(mean, step));
    dissipated += lost;
    least = std::min(least, lost);
  }
  // In simple shear.
  double to(double goal, int steps) {
    const double from = strain[4];
    for (int i = 1; i <= steps; ++i) {
      const double step = from + (goal - from) * i / steps - strain[4];
      add({0, 0, 0, 0, step, step, step, step, 0});
    }
    return stress[4];
  }
};

// A history of strains along a line: reversals anywhere, then oscillations that fade by 1 % a reversal.
std::vector<double> history() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1.5 * kReference);
  std::vector<double> reversals;
  for (int i = 0; i < 500; ++i) reversals.push_back(normal(random));
  for (double size = 8 * kReference; std::abs(size) > 1e-4 * kReference; size *= -0.99)
    reversals.push_back(size);
  std::vector<double> strains{0};
  for (const double goal : reversals)
    for (int i = 1, n = 7; i <= n; ++i) strains.push_back(strains.back() + (goal - strains.back()) * i / n);
  return strains;
}

// Along any line through the origin, whatever the history, the stress and what is dissipated are those of
// Iwan's elements; reversals between which no element lies are forgotten.
TEST(Reversals, AreIwansElementsAlongALine) {
  const Elasticity unit{3, 1};
  const IwanElements elements = iwan_elements(curve());
  const Polyline line(curve());
  for (const auto& [t, s, z] :
       {std::array{0.0, 1.0, 0.0}, {0.8, 0.6, 0.0}, {-0.48, 0.64, 0.6 / std::sqrt(0.75)}}) {
    IwanPoint point(unit, elements);
    Zone zone{line};
    double lost = 0, last = 0;
    std::size_t most = 0;
    const double limit = line.backbone().back().stress;
    for (const double strain : history()) {
      const double step = strain - last;
      last = strain;
      const auto sum = point.add(-1.5 * z * step, t * step, s * step);
      lost += sum.dissipated;
      zone.add({t * step, t * step, t * step, t * step, s * step, s * step, s * step, s * step, z * step});
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_NEAR(zone.stress[k], sum.difference, 1e-12 * limit);
        ASSERT_NEAR(zone.stress[4 + k], sum.shear, 1e-12 * limit);
      }
      ASSERT_NEAR(zone.stress[8], sum.across, 1e-12 * limit);
      most = std::max(most, zone.memory.outer.size());
    }
    EXPECT_NEAR(zone.dissipated, lost, 1e-11 * lost);
    EXPECT_GT(most, 20u);
    EXPECT_LE(most, 2 * curve().size() + 1);
  }
}

// The definition: elements with their plastic strains, and the memory as a list of spheres (radius and
// centre) between which centres lie on straight lines. A step finds the largest sphere that it reaches by
// bisection.
class NestedSpheres {
 public:
  explicit NestedSpheres(const Polyline& line) : line_(line), plastic_(line.backbone().size()) {}

  ZoneStrain add(const ZoneStrain& step) {
    for (std::size_t i = 0; i < kZoneStrains; ++i) strain_[i] += step[i];
    const double elastic = line_.backbone().front().strain;
    if (radius_ > elastic && outside(radius_) < 0) turn_back();
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (outside(middle) >= 0 ? low : high) = middle;
    }
    radius_ = low;
    while (spheres_.size() > 1 && spheres_[1].radius < radius_) spheres_.erase(spheres_.begin());
    const ZoneStrain centre = centre_at(radius_);
    ZoneStrain stress{};
    double slope = 1;
    for (std::size_t k = 0; k < plastic_.size(); ++k) {
      const auto points = line_.backbone();
      const double x = points[k].strain;
      const double next =
          k + 1 < points.size() ? (points[k + 1].stress - points[k].stress) / (points[k + 1].strain - x) : 0;
      for (std::size_t i = 0; i < kZoneStrains; ++i) {
        if (x <= radius_) plastic_[k][i] = strain_[i] - x * (strain_[i] - centre[i]) / radius_;
        stress[i] += (slope - next) * (strain_[i] - plastic_[k][i]);
      }
      slope = next;
    }
    return stress;
  }
  const ZoneStrain& strain() const { return strain_; }

 private:
  struct Sphere {
    double radius;
    ZoneStrain centre;
  };
  ZoneStrain centre_at(double radius) const {
    for (std::size_t j = 0; j + 1 < spheres_.size(); ++j)
      if (radius <= spheres_[j + 1].radius) {
        const auto &a = spheres_[j], &b = spheres_[j + 1];
        ZoneStrain centre;
        const double share = (radius - a.radius) / (b.radius - a.radius);
        for (std::size_t i = 0; i < kZoneStrains; ++i)
          centre[i] = a.centre[i] + share * (b.centre[i] - a.centre[i]);
        return centre;
      }
    return {};
  }
  // How far the strain is outside the sphere of a radius.
  double outside(double radius) const {
    ZoneStrain away = centre_at(radius);
    for (std::size_t i = 0; i < kZoneStrains; ++i) away[i] = strain_[i] - away[i];
    return std::sqrt(inner(away, away)) - radius;
  }
  void turn_back() {
    // The sphere on which it was, and the point where it turned: the strain before this step.
    const Sphere at{radius_, centre_at(radius_)};
    if (!spheres_.empty()) spheres_.erase(spheres_.begin());
    const auto empty_between = [&](double a, double b) {
      for (const auto& point : line_.backbone())
        if (point.strain > a && point.strain < b) return false;
      return true;
    };
    if (spheres_.size() > 1 && empty_between(at.radius, spheres_[1].radius)) spheres_.erase(spheres_.begin());
    spheres_.insert(spheres_.begin(), at);
    spheres_.insert(spheres_.begin(), Sphere{0, turn_});
  }

 public:
  void remember_turn() { turn_ = strain_; }

 private:
  const Polyline& line_;
  std::vector<ZoneStrain> plastic_;
  std::vector<Sphere> spheres_;  // from the inside; beyond the last, centres are at 0
  ZoneStrain strain_{}, turn_{};
  double radius_ = 0;
};

// On paths that turn in any direction of nine, the stress is that of the definition.
TEST(Reversals, AreNestedSpheresOnAnyPath) {
  const Polyline line(curve(20));
  const double limit = line.backbone().back().stress;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 1);
  for (const double speed : {1e-6, 1e-5, 1e-4, 1e-3}) {
    Zone zone{line};
    NestedSpheres spheres(line);
    ZoneStrain direction{};
    for (int i = 0; i < 2000; ++i) {
      for (double& d : direction) d = i % 25 == 0 ? normal(random) : d + 0.2 * normal(random);
      ZoneStrain step = direction;
      for (double& d : step) d *= speed;
      zone.add(step);
      spheres.remember_turn();
      const ZoneStrain stress = spheres.add(step);
      for (std::size_t k = 0; k < kZoneStrains; ++k)
        ASSERT_NEAR(zone.stress[k], stress[k], 1e-11 * limit) << speed << ' ' << i;
    }
  }
}

// On any path, with Masing's loops and narrower ones: what the memory says that it holds is the stress and
// the strain; the work is what it stores and what was dissipated, which never falls where steps are resolved.
TEST(Reversals, WorkIsStoredOrDissipated) {
  Polyline masing(curve()), narrow(curve());
  narrow.narrow(darendeli_share(hyperbola(kReference, 0.919), 10), "");
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0, 1);
  for (const Polyline* line : {&masing, &narrow})
    for (const double speed : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      Zone zone{*line};
      ZoneStrain direction{};
      for (int i = 0; i < 20000; ++i) {
        for (double& d : direction) d = i % 40 == 0 ? normal(random) : d + 0.1 * normal(random);
        ZoneStrain step = direction;
        for (double& d : step) d *= speed;
        zone.add(step);
      }
      const auto [strain, stress, energy] =
          held(line->view(), kWeights, zone.memory.inner, zone.memory.outer);
      EXPECT_NEAR(energy + zone.dissipated, zone.work, 1e-12 * zone.size);
      EXPECT_GT(zone.dissipated, 0);
      if (speed < 1e-5) {
        EXPECT_GE(zone.least, -1e-3 * zone.dissipated / 20000) << speed;
      }
      for (std::size_t k = 0; k < kZoneStrains; ++k) {
        EXPECT_NEAR(stress[k], zone.stress[k], 1e-12);
        EXPECT_NEAR(strain[k], zone.strain[k], 1e-12);
      }
    }
}

// Loops of constant amplitude in simple shear: the secant modulus is the backbone's to rounding, the
// dissipated energy is the area of the loop, and the damping ratio is that of the given curve within 0.5 %,
// or Masing's where that is less.
TEST(Reversals, LoopsHaveTheDampingOfTheCurve) {
  const std::vector<double> strains{1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
  const std::vector<double> ratios{0.005, 0.006, 0.01, 0.022, 0.05, 0.1, 0.15, 0.19};
  const auto given = smooth_table(strains, ratios);
  const auto reduction = hyperbola(kReference, 0.919);
  Polyline line(curve(100));
  const Polyline masing = line;
  line.narrow([&](double x) { return std::min(1.0, given(x) / masing.masing_damping(x)); }, "");
  for (double amplitude = 2e-6; amplitude < 9.9e-3; amplitude *= 1.31) {
    Zone zone{line};
    const double tip = zone.to(amplitude, 10);
    EXPECT_NEAR(tip, line.stress(amplitude), 1e-12 * tip);
    EXPECT_NEAR(tip / amplitude, reduction(amplitude), 2e-3 * reduction(amplitude));
    EXPECT_NEAR(zone.to(-amplitude, 200), -tip, 1e-12 * tip);
    EXPECT_NEAR(zone.to(amplitude, 200), tip, 1e-12 * tip);
    const double work = zone.work, lost = zone.dissipated;
    zone.to(-amplitude, 4000);
    zone.to(amplitude, 4000);
    const double area = zone.work - work;
    EXPECT_NEAR(zone.dissipated - lost, area, 1e-11 * tip * amplitude);
    const double damping = area / (2 * pi * tip * amplitude);
    EXPECT_NEAR(damping, line.damping(amplitude), 1e-5);
    const double least = std::min(given(amplitude), masing.masing_damping(amplitude));
    EXPECT_NEAR(damping, least, 5e-3 * least + 2e-5) << amplitude;
  }
}

// Narrow loops inside a larger one keep the share of the largest strain; the backbone is found again.
TEST(Reversals, NarrowLoopsReturnToTheBackbone) {
  Polyline line(curve());
  line.narrow([](double) { return 0.4; }, "");
  Zone zone{line};
  zone.to(2 * kReference, 30);
  zone.to(-0.5 * kReference, 30);
  zone.to(0.3 * kReference, 30);
  zone.to(-2 * kReference, 30);
  EXPECT_NEAR(zone.stress[4], -line.stress(2 * kReference), 1e-12);
  zone.to(3 * kReference, 1);  // in one step across the old tip
  EXPECT_NEAR(zone.stress[4], line.stress(3 * kReference), 1e-12);
  EXPECT_NEAR(zone.stress[0], 0, 1e-15);
}

// A share that falls at once would let first loading give back energy.
TEST(Reversals, RefuseASuddenEndOfDamping) {
  Polyline line(curve());
  EXPECT_THROW(line.narrow([](double x) { return x < kReference ? 1.0 : 0.01; }, "damping"),
               protocol::UserError);
}

}  // namespace
}  // namespace adit::fdm::test::reversals_test
