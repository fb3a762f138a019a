// Requirements on ground that compacts: half cycles compact it by Byrne's formula, whatever their direction
// and with noise; the pressure falls by what the compaction takes and no further; energy is accounted for
// above every law; zones do not know of each other.
#include "fdm_server/zones/laws/compacting_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace adit::fdm::test::compacting_law_test {
namespace {

using std::numbers::pi;

constexpr Compaction kLoose{1.0, 0.4};
constexpr double kAmplitude = 1e-3;
constexpr int kQuarter = 400;  // steps of a quarter cycle

Material elastic() {
  return {1900, 100e6, 0.3};
}

Material with_strength(Material material) {
  material.mohr_coulomb = MohrCoulomb({5e3, 0.55, 0.1, 0});
  return material;
}

Material hysteretic() {
  Material material = elastic();
  material.hysteretic = iwan_elements(backbone(hyperbola(6e-4, 1), 1e-6, 6e-3, 30));
  return material;
}

Material with_reversals() {
  Material material = elastic();
  material.reversals.emplace(backbone(hyperbola(6e-4, 1), 1e-6, 6e-3, 30));
  return material;
}

// Zones of a square metre, whose points may be strained each by its own; books the work.
class Zones {
 public:
  Zones(const Material& material, double pressure, std::size_t zones = 1, const Compaction& law = kLoose,
        bool large_strain = false)
      : stresses(zones),
        work(zones, 0.0),
        dissipated(zones, 0.0),
        law(make_law(material, zones, large_strain), material.elasticity(), law, zones) {
    this->law.begin_time();
    std::ranges::fill(stresses[kMeanStress], -pressure);
    std::ranges::fill(stresses[kAcross], -pressure);
    for (std::size_t k = 0; k < 4; ++k) areas[k].fill(0.1 * static_cast<double>(k + 1));
  }
  // Zones `first` … `first + count` by the strains that a function writes for each zone and its place.
  template <class Strain>
  void add(std::size_t first, std::uint32_t count, Strain&& strain) {
    StrainBatch strains{};
    for (std::uint32_t i = 0; i < count; ++i) strain(first + i, i, strains);
    book(first, count, strains);
    law.advance({first, count, areas, strains, view(stresses, first), &dissipated[first]});
    book(first, count, strains);
  }
  // The only zone, uniformly.
  void strain(double volume, double difference, double shear) {
    add(0, 1, [&](std::size_t, std::uint32_t i, StrainBatch& strains) {
      strains.volume[i] = volume;
      for (std::size_t k = 0; k < 4; ++k) {
        strains.difference[k][i] = difference;
        strains.shear[k][i] = shear;
      }
    });
  }
  double mean(std::size_t zone) const {
    return (2 * stresses[kMeanStress][zone] + stresses[kAcross][zone]) / 3;
  }
  double energy() const {
    BatchValues energies;
    law.find_energies(0, 1, areas, view(stresses, 0), energies);
    return energies[0];
  }

  PointValues areas{};
  StressFields stresses;
  std::vector<double> work, dissipated;
  CompactingLaw law;

 private:
  void book(std::size_t first, std::uint32_t count, const StrainBatch& strains) {
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        work[first + i] += areas[k][i] / 2 *
                           (stresses[kMeanStress][first + i] * strains.volume[i] +
                            stresses[kDifference + k][first + i] * strains.difference[k][i] +
                            stresses[kShearStress + k][first + i] * strains.shear[k][i]);
  }
};

// What is left after quarter cycles of a strain, which a function gives by the number of the step, in a
// direction of the plane of shear.
template <class Strain>
double compaction_after(int quarters, double direction, Strain&& strain) {
  Zones zone(elastic(), 1e9);
  double before = 0;
  for (int i = 1; i <= quarters * kQuarter; ++i) {
    const double now = strain(i), step = now - before;
    zone.strain(0, std::cos(direction) * step, std::sin(direction) * step);
    before = now;
  }
  return zone.law.compaction(0);
}

double cycle(int i) {
  return kAmplitude * std::sin(pi / 2 * i / kQuarter);
}

// Cycles compact by Byrne's formula, to rounding, the first quarter by half of it.
TEST(CompactingLaw, HalfCyclesCompactByByrnesFormula) {
  const auto [c1, c2] = kLoose;
  double byrne = kAmplitude / 4 * c1;
  for (int quarters = 1; quarters <= 21; quarters += 2) {
    EXPECT_NEAR(compaction_after(quarters, pi / 2, cycle), byrne, 1e-12 * byrne) << quarters;
    byrne += kAmplitude / 2 * c1 * std::exp(-c2 * byrne / kAmplitude);
  }
}

// Half cycles of any size compact by their size; but not those of less than a twentieth of the largest one.
TEST(CompactingLaw, HalfCyclesOfAnySizeCompactByTheirSize) {
  Zones zone(elastic(), 1e9, 1, {1.0, 0});
  const auto strain_by = [&](double strain) {
    for (int i = 0; i < 1000; ++i) zone.strain(0, 0, strain / 1000);
    return zone.law.compaction(0);
  };
  double settled = strain_by(1e-3), sense = -1;
  EXPECT_NEAR(settled, 1e-3 / 4, 1e-12);
  for (const double size : {2e-3, 0.5e-3, 0.4e-3, 1.7e-3, 0.22e-3, 0.21e-3}) {
    const double now = strain_by(sense * size);
    EXPECT_NEAR(now - settled, size / 4, 1e-12) << size;
    settled = now;
    sense = -sense;
  }
  for (int i = 0; i < 10; ++i) EXPECT_EQ(strain_by(i % 2 == 0 ? -0.09e-3 : 0.09e-3), settled) << i;
}

// What statics strain on their way to rest neither compacts nor counts as half cycles afterwards.
TEST(CompactingLaw, CountsFromTheBeginningOfTime) {
  Zones zone(elastic(), 1e9);
  CompactingLaw fresh(make_law(elastic(), 1, false), elastic().elasticity(), kLoose, 1);
  StrainBatch strains{};
  std::vector<double> dissipated(1, 0.0);
  const auto shear = [&](CompactingLaw& law, double gamma) {
    for (auto& of_point : strains.shear) of_point[0] = gamma;
    law.advance({0, 1, zone.areas, strains, view(zone.stresses, 0), dissipated.data()});
  };
  for (const double gamma : {0.1, -0.1, 0.1, -0.1}) shear(fresh, gamma);
  EXPECT_EQ(fresh.compaction(0), 0);
  fresh.begin_time();
  for (int i = 1; i <= 4 * kQuarter; ++i) {
    shear(fresh, cycle(i) - cycle(i - 1));
    shear(zone.law, cycle(i) - cycle(i - 1));
  }
  EXPECT_GT(fresh.compaction(0), 0);
  EXPECT_EQ(fresh.compaction(0), zone.law.compaction(0));
}

// The compaction of a step is as small as its strain, where a reversal begins to count, too.
TEST(CompactingLaw, NothingJumps) {
  Zones zone(elastic(), 1e9);
  double before = 0;
  for (int i = 1; i <= 21 * kQuarter; ++i) {
    const double step = cycle(i) - cycle(i - 1);
    zone.strain(0, 0, step);
    ASSERT_LE(zone.law.compaction(0) - before, 2 * kLoose.c1 / 4 * std::abs(step) * (1 + 1e-9)) << i;
    before = zone.law.compaction(0);
  }
}

// The direction of the shear in the plane does not matter.
TEST(CompactingLaw, IsIsotropic) {
  const double along = compaction_after(21, 0, cycle);
  for (double angle = 0.1; angle < 2 * pi; angle += 0.7)
    EXPECT_NEAR(compaction_after(21, angle, cycle), along, 1e-12 * along);
}

// Noise of 1 % of the amplitude in every step makes the path longer by more than a half, but changes the
// compaction by less than 2 %.
TEST(CompactingLaw, HardlyFeelsNoise) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-0.01 * kAmplitude, 0.01 * kAmplitude);
  double path = 0, noise = 0;
  const double noisy = compaction_after(21, 1, [&](int i) {
    const double before = noise;
    noise = uniform(engine);
    path += std::abs(cycle(i) + noise - cycle(i - 1) - before);
    return cycle(i) + noise;
  });
  const double smooth = compaction_after(21, 1, cycle);
  EXPECT_GT(path, 1.5 * 21 * kAmplitude);
  EXPECT_NEAR(noisy, smooth, 0.02 * smooth);
}

// At constant volume the pressure of elastic ground falls by K ev, until none is left.
TEST(CompactingLaw, TakesThePressureOfGroundThatCannotLoseVolume) {
  const double bulk = elastic().elasticity().bulk, pressure = 300e3;
  Zones zone(elastic(), pressure);
  for (int i = 1; i <= 80 * kQuarter; ++i) {
    zone.strain(0, 0, cycle(i) - cycle(i - 1));
    ASSERT_NEAR(zone.mean(0), bulk * zone.law.compaction(0) - pressure, 1e-9 * pressure);
    ASSERT_LE(zone.mean(0), 1e-9 * pressure);
  }
  EXPECT_NEAR(zone.mean(0), 0, 1e-9 * pressure);
  EXPECT_EQ(zone.stresses[kMeanStress][0], zone.stresses[kAcross][0]);
}

// On any path, above every law: what is put in is stored or dissipated, to rounding, and dissipation never
// falls.
TEST(CompactingLaw, AccountsForItsEnergy) {
  for (const Material& material :
       {elastic(), with_strength(elastic()), hysteretic(), with_strength(hysteretic()), with_reversals()}) {
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    Zones zone(material, 200e3);
    const double stored = zone.energy();
    double largest = 0, before = 0;
    for (int i = 0; i < 6000; ++i) {
      const double size = 1e-5 * (1 + std::sin(0.002 * i));
      zone.add(0, 1, [&](std::size_t, std::uint32_t at, StrainBatch& strains) {
        strains.volume[at] = 0.3 * size * std::sin(0.007 * i);
        for (std::size_t k = 0; k < 4; ++k) {
          strains.difference[k][at] = size * (std::sin(0.03 * i) + 0.3 * normal(engine));
          strains.shear[k][at] = size * (std::cos(0.02 * i) + 0.3 * normal(engine));
        }
      });
      largest = std::max(largest, std::abs(zone.work[0]) + zone.dissipated[0] + stored);
      ASSERT_NEAR(zone.energy() - stored + zone.dissipated[0], zone.work[0], 1e-9 * largest) << i;
      ASSERT_GE(zone.dissipated[0], before - 1e-12 * largest) << i;
      before = zone.dissipated[0];
    }
    EXPECT_GT(zone.law.compaction(0), 1e-4);
  }
}

// A zone has the same bits alone as among others, in batches that begin and end anywhere, and after its state
// was written and read.
TEST(CompactingLaw, ZonesDoNotKnowOfEachOther) {
  constexpr std::size_t kZones = 150;
  const Material material = with_strength(elastic());
  const auto strain_at = [](int step) {
    return [step](std::size_t zone, std::uint32_t i, StrainBatch& strains) {
      const double size = 1e-5 * (1 + 0.01 * static_cast<double>(zone));
      for (std::size_t k = 0; k < 4; ++k)
        strains.shear[k][i] = size * std::sin(0.05 * step + static_cast<double>(zone + k));
    };
  };
  Zones all(material, 100e3, kZones), pieces(material, 100e3, kZones), restored(material, 100e3, kZones);
  const auto advance = [&](Zones& zones, int step, std::uint32_t largest) {
    for (std::size_t first = 0; first < kZones;) {
      const auto count = static_cast<std::uint32_t>(
          std::min({std::size_t{largest}, kBatch - first % kBatch, kZones - first}));
      zones.add(first, count, strain_at(step));
      first += count;
    }
  };
  for (int step = 0; step < 1000; ++step) {
    advance(all, step, kBatch);
    advance(pieces, step, 1 + static_cast<std::uint32_t>(step) % 7);
    if (step < 500) continue;
    if (step == 500) {
      state::Archive written;
      all.law.exchange(written);
      state::Archive read(written.take());
      restored.law.exchange(read);
      read.require_end();
      restored.stresses = all.stresses;
      continue;
    }
    advance(restored, step, kBatch);
  }
  for (std::size_t zone = 0; zone < kZones; ++zone) {
    ASSERT_GT(all.law.compaction(zone), 0);
    ASSERT_EQ(all.law.compaction(zone), pieces.law.compaction(zone));
    ASSERT_EQ(all.law.compaction(zone), restored.law.compaction(zone));
    ASSERT_EQ(all.mean(zone), pieces.mean(zone));
    ASSERT_EQ(all.mean(zone), restored.mean(zone));
  }
}

// Ground that turns while it is sheared compacts as ground that does not: its strain turns with it.
TEST(CompactingLaw, RemembersStrainThatTurnsWithTheGround) {
  Zones still(elastic(), 1e9), turning(elastic(), 1e9, 1, kLoose, true);
  HalfTurns turns;
  turns.cosine[0] = std::cos(0.01);
  turns.sine[0] = std::sin(0.01);
  for (int i = 1; i <= 21 * kQuarter; ++i) {
    const double step = cycle(i) - cycle(i - 1), angle = 0.01 * i;
    still.strain(0, step, 0);
    turning.law.turn(0, 1, turns);
    turning.strain(0, std::cos(angle) * step, std::sin(angle) * step);
  }
  EXPECT_NEAR(turning.law.compaction(0), still.law.compaction(0), 1e-9 * still.law.compaction(0));
}

}  // namespace
}  // namespace adit::fdm::test::compacting_law_test
