// Requirement: what particles report in their own, shorter steps stands in the results at its time; a crack
// is a broken bond inside one body, what breaks between two groups debonds. Kinetic energy is never negative.
// The summary's steps are those of one clock.
#include "coupler/output/recorder.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "coupler/run.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::recorder_test {
namespace {

constexpr double kLength = 4, kYoung = 1e9, kDensity = 2000, kPull = 0.004, kParticleStep = 1e-5;

// A bar whose zones are pulled at x = 0, and whose particles end at a wall that doubles the tension.
scene::Scene bar(unsigned substeps, double strength) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.3333 density: 2000 }
    time { duration: 0.012 }
    continuum {
      block { x_min: 0 x_max: 2.7 y_min: 0 y_max: 1 zones_x: 6 zones_y: 2 }
      edge_loads { where { x_max: 0 } force { x: -1e6 } time { sine { frequency: 125 end: 0.004 } } }
    }
    particles {
      packing { x_min: 1.3 x_max: 4 y_min: 0 y_max: 1 radius: 0.05 }
      motions { where { x_min: 3.92 } velocity { x: 0 y: 0 } spin: 0 }
    }
    interface { overlap { particles_begin { x: 1.3 y: 0 } continuum_ends { x: 2.7 y: 0 } } }
  )",
                                                            &scene));
  scene.mutable_time()->set_substeps(substeps);
  scene.mutable_time()->set_dt(kParticleStep);
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(strength);
  return scene;
}

// What the run leaves in this file.
std::string result_of(const scene::Scene& scene, const std::string& file) {
  const test::ScratchFolder folder;
  coupler::run(scene, test::local_participants(scene), {}, folder.path());
  std::ifstream in(folder / file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The first column of the first row.
double first_crack(unsigned substeps) {
  std::istringstream cracks(result_of(bar(substeps, 1.3e5), "cracks.csv"));
  std::string line;
  std::getline(cracks, line);
  EXPECT_EQ(line.substr(0, line.find(',')), "time_s");
  std::getline(cracks, line);
  return std::stod(line);
}

double peak_bond_force(unsigned substeps) {
  const std::string summary = result_of(bar(substeps, HUGE_VAL), "summary.json");
  return nlohmann::json::parse(summary)["peak_bond_force_time_s"];
}

const double kArrival = kLength / std::sqrt(kYoung / kDensity);

TEST(Recorder, CracksStandAtTheTimeOfTheWave) {
  const double equal = first_crack(1), shorter = first_crack(4);
  EXPECT_GT(equal, kArrival);
  EXPECT_LT(equal, kArrival + kPull / 2);
  EXPECT_NEAR(shorter, equal, 4 * kParticleStep);
}

TEST(Recorder, ThePeakBondForceStandsAtTheTimeOfTheWave) {
  for (const unsigned substeps : {1U, 4U})
    EXPECT_NEAR(peak_bond_force(substeps), kArrival + kPull / 2, kPull / 4) << substeps;
}

// The zones fall from the start, and the particles are drawn away at once: the ledger has energies below 0
// then.
TEST(Recorder, KineticEnergyIsNeverNegative) {
  for (const unsigned substeps : {1U, 2U}) {
    scene::Scene scene = bar(substeps, HUGE_VAL);
    scene.mutable_output()->set_history_interval(kParticleStep);
    scene.mutable_continuum()->add_body_loads()->mutable_acceleration()->set_y(-10);
    scene.mutable_particles()->mutable_motions(0)->mutable_velocity()->set_x(0.1);
    std::istringstream histories(result_of(scene, "histories.csv"));
    std::string line, cell;
    std::getline(histories, line);
    std::vector<bool> kinetic;
    for (std::istringstream names(line); std::getline(names, cell, ',');)
      kinetic.push_back(cell.ends_with("_kinetic_J"));
    ASSERT_EQ(std::ranges::count(kinetic, true), 2);
    bool first = true;
    for (; std::getline(histories, line); first = false) {
      std::istringstream row(line);
      for (std::size_t k = 0; std::getline(row, cell, ','); ++k) {
        if (!kinetic[k]) continue;
        EXPECT_GE(std::stod(cell), 0) << line;
        EXPECT_LE(first ? std::stod(cell) : 0, 1e-12) << line;
      }
    }
  }
}

TEST(Recorder, CriticalStepIsOfTheStepThatTheSummaryTells) {
  const auto steps = [](unsigned substeps) {
    const auto summary = nlohmann::json::parse(result_of(bar(substeps, HUGE_VAL), "summary.json"));
    EXPECT_DOUBLE_EQ(summary["dt_s"], substeps * kParticleStep);
    EXPECT_DOUBLE_EQ(summary["steps"].get<double>() * summary["dt_s"].get<double>(), 0.012);
    return summary["critical_dt_s"].get<double>();
  };
  EXPECT_DOUBLE_EQ(steps(4), 4 * steps(1));  // of the particles, which bind either run
}

TEST(Recorder, SummaryListsWhatActsOtherwiseThanStated) {
  scene::Scene scene = bar(1, HUGE_VAL);
  EXPECT_EQ(nlohmann::json::parse(result_of(scene, "summary.json"))["stated"], nlohmann::json::array());
  scene.mutable_output()->set_history_interval(2.4 * kParticleStep);
  const auto summary = nlohmann::json::parse(result_of(scene, "summary.json"));
  ASSERT_EQ(summary["stated"].size(), 1U);
  const auto& one = summary["stated"][0];
  EXPECT_EQ(one["key"], "output.history_interval");
  EXPECT_DOUBLE_EQ(one["stated"], 2.4 * kParticleStep);
  EXPECT_DOUBLE_EQ(one["acted"], 2 * kParticleStep);
  EXPECT_EQ(one["unit"], "s");
  ASSERT_EQ(summary["warnings"].size(), 1U);
}

// The bar, weak where it says: in the groups that tell the broken bonds, and how many the summary counts.
struct Broken {
  std::set<std::string> groups;
  std::uint64_t rows = 0, cracks, debonded;
  nlohmann::json first_crack, first_debonding;
};

Broken broken(const scene::Scene& scene) {
  const test::ScratchFolder folder;
  coupler::run(scene, test::local_participants(scene), {}, folder.path());
  std::ifstream summary_in(folder / "summary.json"), cracks(folder / "cracks.csv");
  const auto summary = nlohmann::json::parse(summary_in);
  Broken found{{},
               0,
               summary["crack_count"],
               summary["debonded_count"],
               summary["first_crack_time_s"],
               summary["first_debonding_time_s"]};
  std::string line;
  for (std::getline(cracks, line); std::getline(cracks, line); ++found.rows) {
    std::istringstream cells(line);
    for (int column = 0; column < 10; ++column) std::getline(cells, line, ',');
    found.groups.insert(line);
  }
  return found;
}

void expect_debonded(const scene::Scene& scene, const std::string& groups) {
  const Broken found = broken(scene);
  EXPECT_EQ(found.groups, std::set{groups});
  EXPECT_EQ(found.cracks, 0U);
  EXPECT_GT(found.debonded, 0U);
  EXPECT_EQ(found.debonded, found.rows);
  EXPECT_TRUE(found.first_crack.is_null());
  EXPECT_GT(found.first_debonding, kArrival / 2);
}

TEST(Recorder, CracksAreInsideOneBody) {
  const Broken found = broken(bar(1, 1.3e5));
  EXPECT_EQ(found.groups, std::set<std::string>{"particles"});
  EXPECT_EQ(found.cracks, found.rows);
  EXPECT_GT(found.cracks, 0U);
  EXPECT_EQ(found.debonded, 0U);
  EXPECT_TRUE(found.first_debonding.is_null());
}

TEST(Recorder, BondsBetweenTwoGroupsDebond) {
  scene::Scene scene = bar(1, HUGE_VAL);
  auto& end = *scene.mutable_particles()->add_groups();
  end.set_name("end");
  end.mutable_where()->set_x_min(3.5);
  auto& between = *scene.mutable_particles()->add_between();
  between.set_first("particles");
  between.set_second("end");
  between.mutable_bonds()->set_tensile_strength(1.3e5);
  expect_debonded(scene, "particles-end");
}

}  // namespace
}  // namespace adit::recorder_test
