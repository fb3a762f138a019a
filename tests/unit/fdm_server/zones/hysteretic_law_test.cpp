// Requirement on zones with Iwan's elements: computed together, in batches that begin and end anywhere, they
// have the stress of single points.
#include "fdm_server/zones/laws/hysteretic_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace adit::fdm::test {
namespace {

constexpr Elasticity kElasticity{400e6, 150e6};

TEST(HystereticLaw, ZonesTogetherAreSinglePoints) {
  const Hysteretic point(backbone(hyperbola(2e-4, 1), 4e-7, 2e-3, 41));
  constexpr std::uint32_t kZones = 61;
  HystereticLaw law(kElasticity, point, kZones, false);
  StressFields stresses(kZones);
  std::vector<double> dissipated(kZones, 0.0), lost(kZones, 0.0);
  std::vector<std::vector<double>> states(4 * kZones, std::vector<double>(point.values(), 0.0));
  const auto strains = std::make_unique<StrainBatch>();
  const auto areas = std::make_unique<PointValues>();
  for (auto& of_point : *areas) of_point.fill(0.5);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1);
  const double limit = 1e-12 * kElasticity.shear * point.backbone().back().stress;
  for (int step = 0; step < 1500; ++step) {
    const std::uint32_t cut = random() % (kZones + 1);  // zones of two batches
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
              point.add(kElasticity, {strains->volume[i], strains->difference[k][i], strains->shear[k][i]},
                        point.split(states[4 * zone + k]));
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
}  // namespace adit::fdm::test
