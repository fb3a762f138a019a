// Requirement: what particles report in their own, shorter steps stands in the results at its time.
#include "coupler/output/recorder.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "coupler/run.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit {
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

}  // namespace
}  // namespace adit
