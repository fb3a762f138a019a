// Requirements on Mohr-Coulomb and weak planes for batches of zones: they are the laws of single points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "fdm_server/materials/admissible.hpp"
#include "fdm_server/zones/laws/plastic_kernels.hpp"
#include "fdm_server/zones/laws/plastic_law.hpp"

namespace adit::fdm::test::plastic_law_test {
namespace {

class Random {
 public:
  double unit() { return uniform_(engine_); }
  double between(double from, double to) { return from + (to - from) * unit(); }
  // Of both signs, from tiny to large.
  double spread() { return std::copysign(std::pow(10, between(-4, 1)), unit() - 0.5); }
  bool chance(double share) { return unit() < share; }

 private:
  std::mt19937_64 engine_{17};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

// Cohesion, friction, dilation and tension, each 0 now and then, the tension the apex or none too.
Strength any_strength(Random& random) {
  const double cohesion = random.chance(0.2) ? 0 : random.unit();
  const double friction = random.chance(0.2) ? 0 : random.between(0.05, 1.2);
  const double dilation = random.chance(0.3) ? 0 : random.chance(0.3) ? friction : friction * random.unit();
  const double apex = fdm::apex(cohesion, friction);
  const double most = std::isfinite(apex) ? apex : 1;
  const double tension = random.chance(0.2) ? 0 : random.chance(0.4) ? apex : most * random.unit();
  return {cohesion, friction, dilation, tension};
}

// Some states lie on edges of the cone, on its axis, on its apex.
PointStress any_stress(Random& random, const Strength& s) {
  PointStress stress{random.spread(), random.spread(), random.spread(), random.spread()};
  if (random.chance(0.1)) stress.difference = stress.shear = 0;
  if (random.chance(0.1)) stress.across = stress.mean + std::hypot(stress.difference, stress.shear);
  if (random.chance(0.1)) stress.across = stress.mean - std::hypot(stress.difference, stress.shear);
  if (random.chance(0.05)) stress.across = stress.mean;
  if (random.chance(0.05) && std::isfinite(s.tension)) stress.mean = stress.across = s.tension;
  return stress;
}

double size(const PointStress& s) {
  return std::abs(s.mean) + std::abs(s.difference) + std::abs(s.shear) + std::abs(s.across);
}

// Three million points: the stress within 1e-12 of its size, what yields, the plastic shear strain. Few stay
// for the law of single points.
TEST(PlasticKernels, ReturnAsSinglePointsDo) {
  Random random;
  std::size_t points = 0, open = 0, named = 0, otherwise = 0, both = 0;
  const auto zones = std::make_unique<Returning>();
  for (int trial = 0; trial < 4000; ++trial) {
    const Strength strength = any_strength(random);
    Material material{2000, 1, random.between(-0.3, 0.45)};
    material.mohr_coulomb = MohrCoulomb(strength);
    if (trial % 4 == 0) {
      const Strength weaker = any_strength(random);
      material.weak_plane = WeakPlane(random.between(-1.5, 1.5), weaker);
    }
    const Elasticity elasticity = material.elasticity();
    const bool has_plane = material.weak_plane.has_value();
    const auto direction = has_plane ? material.weak_plane->direction() : PlaneDirection{};
    const YieldCone cone = material.mohr_coulomb->cone(0);
    const bool softens = trial % 3 == 0;          // then each point tells its cone
    const double factor = trial % 8 < 4 ? 1 : 4;  // of what the law says, in these zones
    const Plasticity law{elasticity, times(1 / factor, cone), softens, has_plane,
                         has_plane ? times(1 / factor, material.weak_plane->strength()) : PlaneStrength{}};
    zones->count = kBatch;
    zones->cosine.fill(direction.cosine);
    zones->sine.fill(direction.sine);
    zones->strength.fill(factor);
    for (std::size_t i = 0; i < kBatch; ++i) {
      const PointStress s = any_stress(random, strength);
      zones->mean[i] = s.mean;
      zones->across[i] = s.across;
      for (std::size_t k = 0; k < 4; ++k) {
        const double turn = k == 0 ? 0 : random.between(-3, 3), scale = k == 3 ? random.spread() : 1;
        zones->difference[k][i] = scale * (std::cos(turn) * s.difference - std::sin(turn) * s.shear);
        zones->shear[k][i] = scale * (std::sin(turn) * s.difference + std::cos(turn) * s.shear);
        const double fields[] = {cone.sin_friction, cone.sin_dilation, cone.twice_c_cos, cone.tension};
        for (std::size_t field = 0; field < kConeFields; ++field) zones->cones[field][k][i] = fields[field];
      }
    }
    for (const auto regions : {Regions::kShearPlane, Regions::kCutOffPoint, Regions::kAll}) {
      return_points(law, regions, *zones);
      for (std::size_t point = 0; point < 4 * kBatch; ++point) {
        const std::size_t k = point % 4, i = point / 4;
        ++points;
        if (zones->yields[k][i] == kOpen) {
          if (regions == Regions::kAll) ++(has_plane ? both : open);
          continue;
        }
        const PointStress from = zones->predicted(k, i);
        const auto [stress, sheared, yields] =
            admissible(material, elasticity, 0, solid_stress(from), direction);
        const PointStress to = point_stress(stress);
        const PointStress apart{zones->to_mean[k][i] - to.mean, zones->to_difference[k][i] - to.difference,
                                zones->to_shear[k][i] - to.shear, zones->to_across[k][i] - to.across};
        const double scale = size(from) + cone.twice_c_cos;
        ASSERT_LE(size(apart), 1e-12 * scale) << trial << ' ' << i << ' ' << static_cast<int>(regions);
        ASSERT_NEAR(zones->sheared[k][i], sheared, 1e-12 * scale / elasticity.shear) << trial << ' ' << i;
        // At the apex of the cone itself, of the axis that is all without strength, and where both strengths
        // meet, several names are right.
        const bool pointed = strength.tension == apex(strength.cohesion, strength.friction_angle);
        if (has_plane || pointed || strength.cohesion + strength.friction_angle == 0) continue;
        ++named;
        otherwise += zones->yields[k][i] != yields;
      }
    }
  }
  EXPECT_EQ(points, 3072000u);
  EXPECT_EQ(open, 0u);
  EXPECT_EQ(otherwise, 0u);
  EXPECT_GT(named, 500000u);
  EXPECT_LT(both, 50000u);  // where ground and plane flow together
}

}  // namespace
}  // namespace adit::fdm::test::plastic_law_test
