// Requirement on zones of PM4Sand: sheared uniformly they are the law of one point; before time they are
// elastic within friction; the energy they store and dissipate is the work done on them, to rounding; what
// they do depends neither on their neighbours, nor on a checkpoint, nor on the axes.
#include "fdm_server/zones/laws/pm4sand_law.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace adit::fdm::test::pm4sand_law_test {
namespace {

constexpr Elasticity kStatics{200e6, 90e6};
constexpr Pm4Sand kSand{0.55, 677, 0.4};
constexpr double kVertical = 101.3e3, kK0 = 0.5;

// Zones of a square metre each.
class Zones {
 public:
  explicit Zones(std::size_t count, const Pm4Sand& sand = kSand)
      : law_(kStatics, sand, count), stresses_(count), dissipated_(count, 0.0) {
    for (std::size_t i = 0; i < count; ++i) {
      stresses_[kMeanStress][i] = -(1 + kK0) / 2 * kVertical * (1 + 0.01 * static_cast<double>(i));
      stresses_[kAcross][i] = -kK0 * kVertical;
      for (std::size_t k = 0; k < 4; ++k) {
        areas_[k][i] = 0.2 + 0.1 * static_cast<double>(k) / 3;
        stresses_[kDifference + k][i] = (1 - kK0) / 2 * kVertical;
      }
    }
  }
  void advance(const StrainBatch& strains, std::size_t first, std::uint32_t count) {
    PointValues areas;
    StrainBatch own;
    for (std::uint32_t i = 0; i < count; ++i) {
      own.volume[i] = strains.volume[first + i];
      for (std::size_t k = 0; k < 4; ++k) {
        areas[k][i] = areas_[k][first + i];
        own.difference[k][i] = strains.difference[k][first + i];
        own.shear[k][i] = strains.shear[k][first + i];
      }
    }
    law_.advance({first, count, areas, own, view(stresses_, first), &dissipated_[first]});
  }
  void advance(const StrainBatch& strains) {
    advance(strains, 0, static_cast<std::uint32_t>(dissipated_.size()));
  }
  void without_shear_stress() {
    for (std::size_t field = kDifference; field < kStressFields; ++field)
      for (double& value : stresses_[field]) value = 0;
  }
  // Of the strains' points, half of it with the stress of now.
  double half_work(const StrainBatch& strains, std::size_t i) const {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
      sum += areas_[k][i] / 2 *
             (stresses_[kMeanStress][i] * strains.volume[i] +
              stresses_[kDifference + k][i] * strains.difference[k][i] +
              stresses_[kShearStress + k][i] * strains.shear[k][i]);
    return sum;
  }
  BatchValues energies() const {
    BatchValues energies;
    law_.find_energies(0, static_cast<std::uint32_t>(dissipated_.size()), areas_, view(stresses_, 0),
                       energies);
    return energies;
  }
  double difference_of_points(std::size_t i) const {  // the largest from the first point
    double largest = 0;
    for (std::size_t k = 1; k < 4; ++k)
      largest = std::max(largest, std::hypot(stresses_[kDifference + k][i] - stresses_[kDifference][i],
                                             stresses_[kShearStress + k][i] - stresses_[kShearStress][i]));
    return largest;
  }
  // Goes on where others are, with what they tell of their law.
  void resume(Zones& others) {
    stresses_ = others.stresses_;
    dissipated_ = others.dissipated_;
    state::Archive out;
    others.law_.exchange(out);
    state::Archive in(out.take());
    law_.exchange(in);
    in.require_end();
  }
  Pm4SandLaw& law() { return law_; }
  StressFields& stresses() { return stresses_; }
  double dissipated(std::size_t i) const { return dissipated_[i]; }
  bool operator==(const Zones& other) const {
    for (std::size_t field = 0; field < kStressFields; ++field)
      for (std::size_t i = 0; i < dissipated_.size(); ++i)
        if (stresses_[field][i] != other.stresses_[field][i]) return false;
    return dissipated_ == other.dissipated_;
  }

 private:
  Pm4SandLaw law_;
  StressFields stresses_;
  PointValues areas_{};
  std::vector<double> dissipated_;
};

// Shear to and fro, stronger from zone to zone, with noise that bends the zones.
class Shaking {
 public:
  const StrainBatch& next(int step) {
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      const double size = 1e-6 * i;
      strains_.volume[i] = 0.002 * size * normal_(random_);
      for (std::size_t k = 0; k < 4; ++k) {
        strains_.difference[k][i] = 0.1 * size * normal_(random_);
        strains_.shear[k][i] = size * (std::cos(0.02 * step) + 0.2 * normal_(random_));
      }
    }
    return strains_;
  }

 private:
  StrainBatch strains_{};
  std::mt19937_64 random_{11};
  std::normal_distribution<double> normal_;
};

StrainBatch sheared(double gamma) {
  StrainBatch strains{};
  for (auto& of_point : strains.shear) of_point.fill(gamma);
  return strains;
}

TEST(Pm4SandLaw, UniformZonesAreTheLawOfOnePoint) {
  Zones zones(1);
  zones.law().begin_time();
  Pm4SandStress stress{(1 + kK0) / 2 * kVertical, {-(1 - kK0) / 2 * kVertical, 0}};
  auto state = std::bit_cast<std::array<double, kPm4SandFields>>(begin(kSand, stress));
  for (int step = 0; step < 12000; ++step) {
    const double gamma = step % 400 < 200 ? 9e-6 : -9e-6, none = 0, mirrored = -gamma;
    zones.advance(sheared(gamma));
    Pm4SandPoints points{1, &none, &none, &mirrored, &stress.pressure, &stress.shear.t, &stress.shear.s, {}};
    for (std::size_t n = 0; n < kPm4SandFields; ++n) points.state[n] = &state[n];
    advance(kSand, points);
  }
  EXPECT_LT(stress.pressure, 0.3 * kVertical);
  const double tolerance = 1e-9 * kVertical;
  EXPECT_NEAR(zones.stresses()[kMeanStress][0], -stress.pressure, tolerance);
  EXPECT_NEAR(zones.stresses()[kAcross][0], -kK0 / ((1 + kK0) / 2) * stress.pressure, tolerance);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(zones.stresses()[kDifference + k][0], -stress.shear.t, tolerance);
    EXPECT_NEAR(zones.stresses()[kShearStress + k][0], -stress.shear.s, tolerance);
  }
}

TEST(Pm4SandLaw, StaticsAreElasticWithinFriction) {
  Zones zones(1);
  zones.advance(sheared(1e-4));
  EXPECT_DOUBLE_EQ(zones.stresses()[kShearStress][0], 1e-4 * kStatics.shear);
  zones.advance(sheared(1e-2));
  const auto& s = zones.stresses();
  EXPECT_NEAR(std::hypot(s[kDifference][0], s[kShearStress][0]),
              -std::sin(33 * M_PI / 180) * s[kMeanStress][0], 1e-6 * kVertical);
  EXPECT_GT(zones.dissipated(0), 0);
}

TEST(Pm4SandLaw, BooksAllWork) {
  Zones zones(kBatch);
  Shaking shaking;
  zones.law().begin_time();
  const BatchValues before = zones.energies();
  std::vector<double> work(kBatch, 0.0);
  for (int step = 0; step < 3000; ++step) {
    const StrainBatch& strains = shaking.next(step);
    for (std::size_t i = 0; i < kBatch; ++i) work[i] += zones.half_work(strains, i);
    zones.advance(strains);
    for (std::size_t i = 0; i < kBatch; ++i) work[i] += zones.half_work(strains, i);
  }
  const BatchValues after = zones.energies();
  for (std::size_t i = 0; i < kBatch; ++i)
    EXPECT_NEAR(work[i], after[i] - before[i] + zones.dissipated(i), 1e-9 * before[i]) << i;
  EXPECT_GT(zones.dissipated(kBatch - 1), before[kBatch - 1]);
  EXPECT_LT(-zones.stresses()[kMeanStress][kBatch - 1], 0.2 * kVertical);
}

// Elastic compaction is conservative: it gives all of its work back.
TEST(Pm4SandLaw, CompressionDissipatesNothing) {
  Zones zones(1);
  zones.without_shear_stress();
  zones.law().begin_time();
  StrainBatch strains{};
  double compressed = 0;
  for (int step = 0; step < 2000; ++step) {
    strains.volume[0] = step < 1000 ? -1e-6 : 1e-6;
    zones.advance(strains);
    if (step == 999) compressed = zones.energies()[0];
  }
  EXPECT_GT(compressed, 2 * zones.energies()[0]);
  EXPECT_LT(std::abs(zones.dissipated(0)), 1e-5 * compressed);
}

StrainBatch squeezed(double compaction) {
  StrainBatch strains{};
  strains.volume.fill(-compaction);
  for (auto& of_point : strains.difference) of_point.fill(compaction);
  return strains;
}

// A zone that has liquefied settles from the stated time on: neither its stress nor its energies change in
// that moment, it takes less stress from then on, all work is booked, and most of it dissipated.
TEST(Pm4SandLaw, ReconsolidatesFromItsTimeOn) {
  Pm4Sand settling = kSand;
  settling.reconsolidation_from = 10;
  Zones before(1), after(1, settling);
  for (Zones* zones : {&before, &after}) {
    zones->law().begin_time();
    zones->law().set_time(9.9);
    for (int step = 0; step < 60000; ++step) zones->advance(sheared(step % 4000 < 2000 ? 1e-5 : -1e-5));
  }
  EXPECT_TRUE(before == after);
  const double stored = after.energies()[0], dissipated = after.dissipated(0);
  double work = 0;
  for (Zones* zones : {&before, &after}) zones->law().set_time(10);
  EXPECT_EQ(after.energies()[0], stored);
  for (int step = 0; step < 1000; ++step) {
    const StrainBatch strains = squeezed(2e-6);
    work += after.half_work(strains, 0);
    before.advance(strains);
    after.advance(strains);
    work += after.half_work(strains, 0);
  }
  EXPECT_LT(before.stresses()[kMeanStress][0], -0.5 * kVertical);
  EXPECT_GT(after.stresses()[kMeanStress][0], -0.1 * kVertical);
  const double grown = after.energies()[0] - stored, lost = after.dissipated(0) - dissipated;
  EXPECT_NEAR(work, grown + lost, 1e-9 * work);
  EXPECT_GT(lost, 0.8 * work);
}

// What points differ is elastic where the zone is, and no more than friction bears where it has liquefied.
TEST(Pm4SandLaw, BendingIsElasticWithinFriction) {
  Zones zones(1);
  zones.without_shear_stress();
  zones.law().begin_time();
  StrainBatch bent{};
  bent.difference[0][0] = 1e-9;
  bent.difference[1][0] = -1e-9 * 0.2 / (0.2 + 0.1 / 3);
  zones.advance(bent);
  const double modulus = (zones.stresses()[kDifference][0] - zones.stresses()[kDifference + 3][0]) / 1e-9;
  EXPECT_NEAR(modulus, small_strain_elasticity(kSand, 0.75 * kVertical).shear / 2, 1e-6 * modulus);
  for (int step = 0; step < 6000; ++step) zones.advance(sheared(step % 400 < 200 ? 1e-5 : -1e-5));
  for (int step = 0; step < 2000; ++step) {
    StrainBatch both = sheared(step % 400 < 200 ? 1e-5 : -1e-5);
    both.difference[0][0] = 1e-5;
    both.difference[1][0] = -1e-5 * 0.2 / (0.2 + 0.1 / 3);
    zones.advance(both);
    const double pressure = -zones.stresses()[kMeanStress][0];
    ASSERT_LE(zones.difference_of_points(0), 2 * std::sin(33 * M_PI / 180) * pressure * (1 + 1e-9));
  }
}

// Bent by a tenth of the shear, the points of a zone that yields bear about what they would by themselves: of
// a constant stiffness no more can be asked.
TEST(Pm4SandLaw, BendsAboutAsItsPointsByThemselves) {
  constexpr int kSteps = 2000;
  const auto sense = [](int step) { return step % 200 < 50 || step % 200 >= 150 ? 1.0 : -1.0; };
  std::array<Pm4SandStress, 2> points;
  std::array<std::array<double, kPm4SandFields>, 2> states;
  for (std::size_t k = 0; k < 2; ++k) {
    points[k] = {(1 + kK0) / 2 * kVertical, {-(1 - kK0) / 2 * kVertical, 0}};
    states[k] = std::bit_cast<std::array<double, kPm4SandFields>>(begin(kSand, points[k]));
  }
  double largest_of_points = 0, largest_of_zone = 0;
  Zones zones(1);
  zones.law().begin_time();
  for (int step = 0; step < kSteps; ++step) {
    const double gamma = 8e-6 * sense(step);
    StrainBatch strains = sheared(gamma);
    for (std::size_t k = 0; k < 2; ++k) {
      const double bent = (k == 0 ? 0.1 : -0.1) * gamma, none = 0, compressive = -bent, mirrored = -gamma;
      strains.difference[k][0] = bent * 0.2 / (0.2 + 0.1 / 3 * static_cast<double>(k));
      Pm4SandPoints point{
          1, &none, &compressive, &mirrored, &points[k].pressure, &points[k].shear.t, &points[k].shear.s, {}};
      for (std::size_t n = 0; n < kPm4SandFields; ++n) point.state[n] = &states[k][n];
      advance(kSand, point);
    }
    zones.advance(strains);
    points[0].pressure = points[1].pressure = (points[0].pressure + points[1].pressure) / 2;
    largest_of_points = std::max(largest_of_points, std::abs(points[0].shear.t - points[1].shear.t) / 2);
    largest_of_zone = std::max(
        largest_of_zone, std::abs(zones.stresses()[kDifference][0] - zones.stresses()[kDifference + 3][0]));
  }
  EXPECT_NEAR(largest_of_zone, largest_of_points, 0.5 * largest_of_points);
}

TEST(Pm4SandLaw, ZonesDoNotDependOnTheirBatch) {
  Zones together(kBatch), apart(kBatch);
  Shaking shaking;
  together.law().begin_time();
  apart.law().begin_time();
  for (int step = 0; step < 500; ++step) {
    const StrainBatch& strains = shaking.next(step);
    together.advance(strains);
    apart.advance(strains, 0, 19);
    apart.advance(strains, 19, 1);
    apart.advance(strains, 20, kBatch - 20);
  }
  EXPECT_TRUE(together == apart);
}

// Before time, in it, and after the shaking.
TEST(Pm4SandLaw, GoesOnFromACheckpoint) {
  for (const int begins : {0, 150}) {
    Pm4Sand sand = kSand;
    sand.reconsolidation_from = 50;
    Zones whole(kBatch, sand);
    auto split = std::make_unique<Zones>(kBatch, sand);
    Shaking shaking;
    for (int step = 0; step < 300; ++step) {
      if (step == begins) {
        whole.law().begin_time();
        split->law().begin_time();
      }
      if (step == 100) {
        auto resumed = std::make_unique<Zones>(kBatch, sand);
        resumed->resume(*split);
        split = std::move(resumed);
      }
      whole.law().set_time(step);
      split->law().set_time(step);
      const StrainBatch& strains = shaking.next(step);
      whole.advance(strains);
      split->advance(strains);
    }
    EXPECT_TRUE(whole == *split);
  }
}

// Loading that goes on in ground that has turned by 0.3 is the same in axes that have turned with it.
TEST(Pm4SandLaw, MemoryTurnsWithTheGround) {
  Zones still(1), turned(1);
  still.law().begin_time();
  turned.law().begin_time();
  const double cosine = std::cos(0.6), sine = std::sin(0.6);
  HalfTurns turns;
  turns.cosine.fill(cosine);
  turns.sine.fill(sine);
  for (int step = 0; step < 600; ++step) {
    const double gamma = step < 100 ? 9e-6 : step < 300 ? -9e-6 : 1.9e-5;
    still.advance(sheared(gamma));
    StrainBatch strains = sheared(gamma);
    if (step == 400) turned.law().turn(0, 1, turns);
    for (std::size_t k = 0; k < 4; ++k) {
      double &t = turned.stresses()[kDifference + k][0], &s = turned.stresses()[kShearStress + k][0];
      if (step == 400) {
        const double was = t;
        t = cosine * was - sine * s;
        s = sine * was + cosine * s;
      }
      if (step >= 400) {
        strains.difference[k][0] = -sine * gamma;
        strains.shear[k][0] = cosine * gamma;
      }
    }
    turned.advance(strains);
  }
  auto &one = still.stresses(), &other = turned.stresses();
  EXPECT_NEAR(other[kMeanStress][0], one[kMeanStress][0], 1e-9 * kVertical);
  EXPECT_NEAR(other[kShearStress][0], sine * one[kDifference][0] + cosine * one[kShearStress][0],
              1e-9 * kVertical);
}

}  // namespace
}  // namespace adit::fdm::test::pm4sand_law_test
