// Requirements on hysteretic zones within a strength: they are hysteretic within it, yield at it, unload
// elastically, and account for their energy.
#include "fdm_server/zones/laws/limited_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "fdm_server/materials/admissible.hpp"
#include "fdm_server/model/ground.hpp"

namespace adit::fdm::test::limited_law_test {
namespace {

constexpr double kReference = 1e-3, kCohesion = 40e3;

Material soil(double cohesion, double friction = 0, double dilation = 0, double reference = kReference) {
  Material material{2000, 400e6, 0.3};
  material.hysteretic =
      iwan_elements(backbone(hyperbola(reference, 1), 2e-3 * reference, 10 * reference, 60));
  if (cohesion < HUGE_VAL)
    material.mohr_coulomb = MohrCoulomb({cohesion, friction, dilation, apex(cohesion, friction)});
  return material;
}

// A zone of a square metre, whose points may be strained each by its own.
class Zone {
 public:
  explicit Zone(const Material& material) : law_(make_law(material, 1, false)), stresses_(1) {
    for (auto& of_point : areas_) of_point[0] = 0.25;
  }
  // exx + eyy, and exx - eyy and gamma of each point. Books the work.
  void add(double volume, const std::array<double, 4>& difference, const std::array<double, 4>& shear) {
    const auto before = stresses();
    strains_.volume[0] = volume;
    for (std::size_t k = 0; k < 4; ++k) {
      strains_.difference[k][0] = difference[k];
      strains_.shear[k][0] = shear[k];
    }
    law_->advance({0, 1, areas_, strains_, view(stresses_, 0), &dissipated});
    const auto after = stresses();
    for (std::size_t k = 0; k < 4; ++k)
      work += 0.25 / 2 *
              ((before[k].mean + after[k].mean) * volume +
               (before[k].difference + after[k].difference) * difference[k] +
               (before[k].shear + after[k].shear) * shear[k]);
  }
  void shear(double gamma) { add(0, {}, {gamma, gamma, gamma, gamma}); }
  std::array<PointStress, 4> stresses() const {
    std::array<PointStress, 4> found{};
    for (std::size_t k = 0; k < 4; ++k)
      found[k] = {stresses_[kMeanStress][0], stresses_[kDifference + k][0], stresses_[kShearStress + k][0],
                  stresses_[kAcross][0]};
    return found;
  }
  double tau() const { return stresses()[0].shear; }
  double energy() const {
    BatchValues energies;
    law_->find_energies(0, 1, areas_, view(stresses_, 0), energies);
    return energies[0];
  }
  const ZoneLaw& law() const { return *law_; }
  double dissipated = 0, work = 0;

 private:
  std::unique_ptr<ZoneLaw> law_;
  StressFields stresses_;
  PointValues areas_{};
  StrainBatch strains_{};
};

// Within the strength it is the hysteretic law, to the bit.
TEST(LimitedLaw, IsTheHystereticLawWithinItsStrength) {
  Zone alone(soil(HUGE_VAL)), limited(soil(1e9, 0.5));
  for (int i = 0; i < 2000; ++i) {
    const double gamma = 1e-5 * std::sin(0.01 * i) * (1 + 0.3 * std::cos(0.37 * i));
    for (Zone* zone : {&alone, &limited})
      zone->add(0.1 * gamma, {gamma, 0, -gamma, 0}, {gamma, gamma, gamma, 0});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(alone.stresses()[k].shear, limited.stresses()[k].shear);
    EXPECT_EQ(alone.stresses()[k].difference, limited.stresses()[k].difference);
  }
  EXPECT_EQ(alone.dissipated, limited.dissipated);
}

// In simple shear without friction the stress follows the curve to the cohesion and stays there; what the
// curve does not need is plastic; it unloads with the modulus at small strains, to the cohesion on the other
// side.
TEST(LimitedLaw, YieldsAtItsStrengthAndUnloadsElastically) {
  const Material material = soil(kCohesion);
  const double modulus = material.elasticity().shear, most = modulus * kReference;  // of the curve
  ASSERT_LT(kCohesion, 0.5 * most);
  Zone zone(material), alone(soil(HUGE_VAL));
  const double step = 1e-6, end = 4e-3;
  double reached = 0;
  for (double gamma = step; gamma < end; gamma += step) {
    zone.shear(step);
    alone.shear(step);
    if (alone.tau() < kCohesion) {
      EXPECT_EQ(zone.tau(), alone.tau());
      reached = gamma;
    } else {
      EXPECT_NEAR(zone.tau(), kCohesion, 1e-9 * kCohesion);
    }
  }
  EXPECT_NEAR(zone.law().plastic_shear_strain(0, 0), end - reached, 5e-3 * (end - reached));
  EXPECT_NE(zone.law().yields(0, 0) & kShearNow, 0u);
  zone.shear(-step);  // less than the first element bears
  EXPECT_NEAR(zone.tau(), kCohesion - modulus * step, 1e-6 * modulus * step);
  EXPECT_EQ(zone.law().yields(0, 0), kShearPast);
  for (int i = 0; i < 4000; ++i) zone.shear(-step);
  EXPECT_NEAR(zone.tau(), -kCohesion, 1e-9 * kCohesion);
}

// With a curve that is straight up to the strength, it is Mohr-Coulomb: stress within 1e-3 of
// the largest, dissipation within 1 %.
TEST(LimitedLaw, IsMohrCoulombWhereTheCurveIsStraight) {
  Material straight = soil(kCohesion, 0.5, 0.2, 50), plain = straight;
  plain.hysteretic.reset();
  Zone one(straight), other(plain);
  for (int i = 0; i < 3000; ++i) {
    const double gamma = 1e-5 * std::sin(0.01 * i), volume = -2e-7;
    for (Zone* zone : {&one, &other}) zone->add(volume, {gamma, 0, gamma, gamma}, {gamma, gamma, -gamma, 0});
  }
  const double size = std::abs(other.stresses()[0].mean);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(one.stresses()[k].shear, other.stresses()[k].shear, 1e-3 * size);
    EXPECT_NEAR(one.stresses()[k].mean, other.stresses()[k].mean, 1e-3 * size);
  }
  EXPECT_NEAR(one.dissipated, other.dissipated, 0.01 * other.dissipated);
}

// On any path, with friction, dilation, tension and a weak plane: what is put in is stored or dissipated, to
// rounding; dissipation never falls; no stress lies outside the strength.
TEST(LimitedLaw, AccountsForItsEnergyWithinItsStrength) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  for (const bool plane : {false, true}) {
    Material material = soil(kCohesion, 0.6, 0.3);
    if (plane) material.weak_plane = WeakPlane(0.7, {20e3, 0.4, 0.1, 10e3});
    Zone zone(material);
    double largest = 0, before = 0;
    for (int i = 0; i < 5000; ++i) {
      const double size = 2e-6 * (1 + std::sin(0.002 * i));
      std::array<double, 4> difference{}, shear{};
      const double d = std::sin(0.01 * i), s = std::cos(0.013 * i);
      for (std::size_t k = 0; k < 4; ++k) {
        difference[k] = size * (d + 0.3 * normal(engine));
        shear[k] = size * (s + 0.3 * normal(engine));
      }
      zone.add(0.5 * size * std::sin(0.007 * i), difference, shear);
      largest = std::max(largest, std::abs(zone.work) + zone.dissipated);
      ASSERT_NEAR(zone.energy() + zone.dissipated, zone.work, 1e-9 * largest) << i;
      ASSERT_GE(zone.dissipated, before - 1e-12 * largest);
      before = zone.dissipated;
    }
    EXPECT_GT(zone.law().plastic_shear_strain(0, 0), 1e-4);
  }
}

}  // namespace
}  // namespace adit::fdm::test::limited_law_test
