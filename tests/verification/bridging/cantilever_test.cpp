// Requirement: the coupled cantilever gives the results of the whole beam of particles (section 5 of the
// paper), elastic and cracking, with aligned and with cut zones, and keeps energy
// (cases/cantilever/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "protocol/scene/reader.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::cantilever_test {
namespace {

struct Crack {
  double time, x, y;
};

struct Outcome {
  std::vector<double> times, max_force, tip;  // of every step [s], [N], [m]
  std::vector<Crack> cracks;
  double max_drift = 0, kept = 0, residual = 0;

  double force_at(double time) const {
    const auto later = std::lower_bound(times.begin(), times.end(), time - 1e-12);
    return max_force.at(later - times.begin());
  }
  double peak() const { return *std::max_element(max_force.begin(), max_force.end()); }
  double largest_tip(double until) const {
    double largest = 0;
    for (std::size_t n = 0; n < times.size() && times[n] <= until; ++n)
      largest = std::max(largest, std::abs(tip[n]));
    return largest;
  }
  std::set<std::pair<long, long>> broken_places(double until) const {  // in centimetres
    std::set<std::pair<long, long>> places;
    for (const Crack& crack : cracks)
      if (crack.time <= until) places.insert({std::lround(100 * crack.x), std::lround(100 * crack.y)});
    return places;
  }
};

Outcome compute(const std::string& scene_name) {
  const auto file = protocol::read_scene(std::string(ADIT_CASES) + "/cantilever/" + scene_name + ".yaml");
  coupler::Model model = test::local_model(file.scene);
  coupler::Stepper stepper(model);
  Outcome outcome;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = n % 10 == 0, .histories = true});
    outcome.times.push_back(static_cast<double>(n) * model.dt);
    for (const coupler::Participant& participant : model.participants) {
      const wire::Predicted& predicted = participant.prediction();
      if (predicted.histories_size() == 1) outcome.tip.push_back(predicted.histories(0));
      if (participant.member.role != coupler::Role::kParticles) continue;
      outcome.max_force.push_back(predicted.strongest(0).force());
      for (const auto& crack : predicted.cracks())
        outcome.cracks.push_back({outcome.times.back(), crack.x(), crack.y()});
    }
  }
  outcome.max_drift = stepper.ledger().max_drift();
  outcome.kept = stepper.ledger().kept();
  outcome.residual = stepper.ledger().max_constraint_residual();
  return outcome;
}

// Each scene is computed once for all tests.
const Outcome& outcome_of(const std::string& scene_name) {
  static std::map<std::string, Outcome> outcomes;
  const auto [place, is_new] = outcomes.try_emplace(scene_name);
  if (is_new) place->second = compute(scene_name);
  return place->second;
}

void expect_within(double value, double reference, double share, const std::string& what) {
  EXPECT_NEAR(value, reference, share * std::abs(reference)) << what;
}

// How far a coupled elastic run may be from the particles alone.
struct Bound {
  double late, early;  // peak, F(32 ms), tip; F(28 ms) and F(30 ms)
};

void expect_agreement(const Outcome& coupled, const Outcome& reference, Bound bound) {
  expect_within(coupled.peak(), reference.peak(), bound.late, "peak force chain");
  expect_within(coupled.force_at(0.032), reference.force_at(0.032), bound.late, "F(32 ms)");
  expect_within(coupled.largest_tip(0.05), reference.largest_tip(0.05), bound.late, "largest tip deflection");
  expect_within(coupled.force_at(0.028), reference.force_at(0.028), bound.early, "F(28 ms)");
  expect_within(coupled.force_at(0.030), reference.force_at(0.030), bound.early, "F(30 ms)");
}

// Particles alone: within 0.5 % of what an independent program of the same equations gave over 45 ms.
TEST(Cantilever, ParticlesAloneGiveTheReference) {
  const Outcome& dem = outcome_of("variants/full_dem_elastic");
  const std::map<double, double> reference = {{0.020, 3814e3},  {0.024, 6379e3},  {0.028, 7103e3},
                                              {0.030, 10628e3}, {0.032, 13033e3}, {0.040, 5467e3}};
  for (const auto& [time, force] : reference)
    expect_within(dem.force_at(time), force, 0.005, std::to_string(1e3 * time) + " ms");
  expect_within(dem.peak(), 13146e3, 0.005, "peak");
  expect_within(dem.largest_tip(0.045), 0.1779, 0.005, "tip");
  EXPECT_TRUE(dem.cracks.empty());
}

TEST(Cantilever, ConsistentCouplingAgreesWithParticlesAlone) {
  const Outcome& coupled = outcome_of("variants/coupled_elastic");
  expect_agreement(coupled, outcome_of("variants/full_dem_elastic"), {.late = 0.01, .early = 0.04});
  EXPECT_LE(coupled.max_drift, 1e-3);
  EXPECT_LE(coupled.residual, 1e-12);
}

// The overlap shifted by 0.2 m cuts zones: the forces of the aligned one, within 0.2 %.
TEST(Cantilever, AnOverlapThatCutsZonesChangesNothing) {
  const Outcome& cut = outcome_of("variants/coupled_elastic_shifted");
  const Outcome& aligned = outcome_of("variants/coupled_elastic");
  expect_within(cut.peak(), aligned.peak(), 0.002, "peak");
  expect_within(cut.force_at(0.032), aligned.force_at(0.032), 0.002, "F(32 ms)");
}

// The lumped solve loses some of the resolved waves: about 4 % of the energy, 3.5 % of the forces at most.
TEST(Cantilever, LumpedCouplingLosesALittle) {
  const Outcome& lumped = outcome_of("variants/coupled_elastic_lumped");
  expect_agreement(lumped, outcome_of("variants/full_dem_elastic"), {.late = 0.035, .early = 0.035});
  EXPECT_GT(lumped.kept, 0.94);
  EXPECT_LT(lumped.kept, 0.98);
}

// The FLAC zone at the paper's mesh is too stiff in bending: force chains grow early, the tip moves less.
TEST(Cantilever, FlacZonesAreTooStiffAtThePapersMesh) {
  const Outcome& flac = outcome_of("variants/coupled_elastic_flac");
  const Outcome& dem = outcome_of("variants/full_dem_elastic");
  EXPECT_GT(flac.force_at(0.028), 1.3 * dem.force_at(0.028));
  EXPECT_LT(flac.largest_tip(0.045), 0.97 * dem.largest_tip(0.045));
}

// Bonds of 10 MN: intact at 28 ms, then both models break at the fixed end, in the same places.
TEST(Cantilever, CracksAsTheParticlesAlone) {
  const Outcome& coupled = outcome_of("coupled");
  const Outcome& dem = outcome_of("full_dem");
  for (const Outcome* model : {&coupled, &dem}) {
    ASSERT_FALSE(model->cracks.empty());
    EXPECT_GT(model->cracks.front().time, 0.028);
    EXPECT_NEAR(model->cracks.front().x, 9.87, 0.01);
    EXPECT_LE(model->max_drift, 1e-3);
  }
  EXPECT_NEAR(coupled.cracks.front().time, dem.cracks.front().time, 0.4e-3);
  expect_within(coupled.force_at(0.032), dem.force_at(0.032), 0.02, "F(32 ms)");
  EXPECT_EQ(coupled.broken_places(0.032), dem.broken_places(0.032));
  EXPECT_EQ(coupled.broken_places(0.050), dem.broken_places(0.050));
}

}  // namespace
}  // namespace adit::cantilever_test
