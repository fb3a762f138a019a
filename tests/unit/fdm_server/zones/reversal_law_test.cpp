// Requirement on zones with a memory of reversals: computed together they are the law of single zones, and
// hold the energy of their memories, in small strain and in axes that turn.
#include "fdm_server/zones/laws/reversal_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace adit::fdm::test::reversal_law_test {
namespace {

constexpr Elasticity kElasticity{400e6, 150e6};

// Strains of a batch that goes on, turns back and comes to rest.
class Shaking {
 public:
  void next(int step, StrainBatch& strains) {
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      const double size = i % 8 == 0 ? 0 : 3e-5 * std::sin(0.07 * step * (1 + 0.1 * i)) * normal_(random_);
      strains.volume[i] = 0.3 * size * normal_(random_);
      for (std::size_t k = 0; k < 4; ++k) {
        strains.difference[k][i] = size * (1 + 0.2 * normal_(random_));
        strains.shear[k][i] = size * (1 + 0.2 * normal_(random_));
      }
    }
  }

 private:
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_{0, 1};
};

void compare(bool narrow_loops, bool large_strain) {
  Polyline line(backbone(hyperbola(2e-4, 1), 4e-7, 2e-3, 40));
  if (narrow_loops) line.narrow(darendeli_share(hyperbola(2e-4, 1), 10), "");
  ReversalLaw law(kElasticity, line, kBatch, large_strain);
  StressFields stresses(kBatch);
  std::vector<double> dissipated(kBatch, 0.0);
  std::vector<ZoneMemory> memories(kBatch);
  std::vector<ZoneStrain> sums(kBatch, ZoneStrain{});
  std::vector<double> lost(kBatch, 0.0), turned(kBatch, 0.0);
  const auto strains = std::make_unique<StrainBatch>();
  const auto areas = std::make_unique<PointValues>();
  for (std::uint32_t i = 0; i < kBatch; ++i)
    for (std::size_t k = 0; k < 4; ++k) (*areas)[k][i] = 0.5 + 0.01 * i + 0.1 * static_cast<double>(k);
  Shaking shaking;
  std::size_t deepest = 0;
  for (int step = 0; step < 600; ++step) {
    shaking.next(step, *strains);
    if (large_strain) {
      HalfTurns turns;
      for (std::uint32_t i = 0; i < kBatch; ++i) {
        const double angle = 1e-3 * i;
        turns.cosine[i] = std::cos(angle);
        turns.sine[i] = std::sin(angle);
        turned[i] += angle;
        for (std::size_t k = 0; k < 4; ++k) {  // the stress turns with the ground
          const double d = stresses[kDifference + k][i], s = stresses[kShearStress + k][i];
          stresses[kDifference + k][i] = turns.cosine[i] * d - turns.sine[i] * s;
          stresses[kShearStress + k][i] = turns.sine[i] * d + turns.cosine[i] * s;
        }
      }
      law.turn(0, kBatch, turns);
    }
    law.advance({0, kBatch, *areas, *strains, view(stresses, 0), dissipated.data()});
    // Asked for now and then, so that some zones left their piece since and some did not.
    BatchValues energies;
    if (step % 7 == 0) law.find_energies(0, kBatch, *areas, view(std::as_const(stresses), 0), energies);
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      const double cosine = std::cos(turned[i]), sine = std::sin(turned[i]);
      ZoneStrain strain, weights;
      double area = 0;
      for (std::size_t k = 0; k < 4; ++k) area += (*areas)[k][i];
      for (std::size_t k = 0; k < 4; ++k) {
        const double d = strains->difference[k][i], s = strains->shear[k][i];
        strain[k] = cosine * d + sine * s;
        strain[4 + k] = cosine * s - sine * d;
        weights[k] = weights[4 + k] = (*areas)[k][i] / area;
      }
      strain[8] = -2 * strains->volume[i] / 3;
      weights[8] = 0.75;
      const auto [growth, dissipation] = advance(line.view(), weights, strain, memories[i]);
      for (std::size_t k = 0; k < kZoneStrains; ++k) sums[i][k] += kElasticity.shear * growth[k];
      lost[i] += kElasticity.shear * area * dissipation;
      deepest = std::max(deepest, memories[i].outer.size());
      const double limit = 1e-12 * kElasticity.shear * line.backbone().back().stress;
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_NEAR(stresses[kDifference + k][i], cosine * sums[i][k] - sine * sums[i][4 + k], 10 * limit);
        ASSERT_NEAR(stresses[kShearStress + k][i], sine * sums[i][k] + cosine * sums[i][4 + k], 10 * limit);
      }
      const double pressure = (2 * stresses[kMeanStress][i] + stresses[kAcross][i]) / 3;
      ASSERT_NEAR(stresses[kAcross][i] - pressure, sums[i][8], limit + 1e-12 * std::abs(pressure));
      ASSERT_NEAR(dissipated[i], lost[i], 1e-12 * std::abs(lost[i]) + 1e-15 * area);
      if (step % 7 != 0) continue;
      const Held all = held(line.view(), weights, memories[i].inner, memories[i].outer);
      const double energy =
          area * (kElasticity.shear * all.energy + pressure * pressure / (2 * kElasticity.bulk));
      ASSERT_NEAR(energies[i], energy, 1e-11 * energy + 1e-12 * lost[i]);
    }
  }
  EXPECT_GT(deepest, 5u);
  EXPECT_GT(lost[1], 0);
  EXPECT_EQ(lost[0], 0);
}

TEST(ReversalLaw, ZonesTogetherAreSingleZones) {
  for (const bool narrow_loops : {false, true})
    for (const bool large_strain : {false, true}) compare(narrow_loops, large_strain);
}

}  // namespace
}  // namespace adit::fdm::test::reversal_law_test
