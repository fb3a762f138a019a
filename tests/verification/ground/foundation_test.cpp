// Requirements on foundations, in zones, in particles and where both overlap: closed forms of bars and beams
// on springs, and of a body on ground that shakes.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::foundation_test {
namespace {

scene::Scene scene_of(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return scene;
}

// The last values of the histories, in the order of the participants.
std::vector<double> end_of(const scene::Scene& scene) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= model.steps; ++n)
    stepper.step(n, {.energies = n % 100 == 0, .histories = n == model.steps});
  EXPECT_LT(stepper.ledger().max_drift(), 1e-9);
  std::vector<double> values;
  for (const coupler::Participant& participant : model.participants) {
    const auto& last = participant.prediction().histories();
    values.insert(values.end(), last.begin(), last.end());
  }
  return values;
}

// A bar of 1e9 Pa, 2 m high, along x, on springs; its critical damping makes it come to rest.
std::string bar(const std::string& y_springs) {
  return "foundations { x { stiffness: 2e6 dashpot: 1e5 } " + y_springs + " } ";
}

// Requirement: a long bar pulled at its end by F moves there by F/sqrt(EA K), K the stiffness per length.
TEST(Foundation, HoldsABarAlongItsAxis) {
  const double expected = 1e6 / std::sqrt(1e9 * 2 * 2e6 * 2);
  const auto pulled =
      end_of(scene_of("plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0 density: 2000 } "
                      "time { duration: 1 dt_factor: 0.9 } continuum { block { x_min: 0 x_max: 100 y_min: 0 "
                      "y_max: 2 zones_x: 200 "
                      "zones_y: 2 } edge_loads { where { x_max: 0 } force { x: -1e6 } } " +
                      bar("") + "histories { name: 'end' quantity: DISPLACEMENT_X at { x: 0 y: 1 } } }"));
  EXPECT_NEAR(pulled[0], -expected, 0.002 * expected);
}

// Requirement: a long beam under F at its middle deflects there by F b/(2 K), b = (K/4EI)^(1/4) (Hetenyi),
// and by shear F/(2 sqrt(K G A')) beside where it is much longer than high.
TEST(Foundation, HoldsABeamAcrossItsAxis) {
  const double inertia = 8. / 12, stiffness = 2e4 * 2, rigidity = 1e9 * inertia;
  const double b = std::pow(stiffness / (4 * rigidity), 0.25);
  const double expected = 1e4 * b / (2 * stiffness);
  const auto pushed =
      end_of(scene_of("plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0 density: 2000 } "
                      "time { duration: 8 dt_factor: 0.9 } continuum { block { x_min: 0 x_max: 200 y_min: 0 "
                      "y_max: 2 zones_x: 200 "
                      "zones_y: 2 } point_loads { where { x_min: 100 x_max: 100 } force { y: -1e4 } } "
                      "foundations { y { stiffness: 2e4 dashpot: 1e4 } } "
                      "histories { name: 'middle' quantity: DISPLACEMENT_Y at { x: 100 y: 1 } } }"));
  EXPECT_NEAR(pushed[0], -expected, 0.01 * expected);
}

constexpr double kStiffness = 8e6, kDensity = 2000, kDamping = 0.1, kOmega = 40, kVelocity = 0.2, kEnd = 0.4;

// The displacement of a body on a foundation whose ground has the velocity V sin wt: of the oscillator
// z'' + 2 d w0 z' + w0^2 z = -V w cos wt from rest, u = u_g + z.
double oscillator(double t) {
  using Complex = std::complex<double>;
  const double w0 = std::sqrt(kStiffness / kDensity), wd = w0 * std::sqrt(1 - kDamping * kDamping);
  const Complex i(0, 1);
  const Complex z = -kVelocity * kOmega / (w0 * w0 - kOmega * kOmega + 2. * i * kDamping * w0 * kOmega);
  const double a = -z.real(), b = (kDamping * w0 * a - (i * kOmega * z).real()) / wd;
  return (z * std::exp(i * kOmega * t)).real() +
         std::exp(-kDamping * w0 * t) * (a * std::cos(wd * t) + b * std::sin(wd * t)) +
         kVelocity * (1 - std::cos(kOmega * t)) / kOmega;
}

// On ground that moves alike everywhere, twice as much in x as in y.
void shake(scene::Foundation& foundation) {
  for (auto* spring : {foundation.mutable_x(), foundation.mutable_y()}) {
    spring->set_stiffness(kStiffness);
    spring->set_dashpot(2 * kDamping * std::sqrt(kStiffness * kDensity));
  }
  std::string table = "time_s,x_m,vx_m_per_s,vy_m_per_s\n";
  for (int n = 0; n <= 1000 * kEnd; ++n) {
    const double v = kVelocity * std::sin(kOmega * n * 1e-3);
    table += std::to_string(n * 1e-3) + ",0," + std::to_string(v) + "," + std::to_string(v / 2) + "\n";
  }
  foundation.mutable_ground()->set_path("ground.csv");
  foundation.mutable_ground()->set_content(table);
}

const std::string kBody =
    "plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } "
    "time { duration: 0.4 dt_factor: 0.9 } ";
const std::string kZones =
    "continuum { block { x_min: 0 x_max: 10 y_min: -1 y_max: 1 zones_x: 20 zones_y: 4 } "
    "histories { name: 'a' quantity: DISPLACEMENT_X at { x: 5 y: 0 } } "
    "histories { name: 'a' quantity: DISPLACEMENT_Y at { x: 5 y: 0 } } } ";
const std::string kParticles =
    "particles { packing { x_min: 6 x_max: 16 y_min: -1.0392304845413265 y_max: 1.0392304845413265 radius: "
    "0.2 } "
    "histories { name: 'b' quantity: DISPLACEMENT_X at { x: 13 y: 0 } } "
    "histories { name: 'b' quantity: DISPLACEMENT_Y at { x: 13 y: 0 } } } ";

void expect_oscillator(const scene::Scene& scene) {
  const auto end = end_of(scene);
  const double expected = oscillator(kEnd);
  ASSERT_GT(std::abs(expected), 2e-3);
  for (std::size_t k = 0; k < end.size(); ++k)
    EXPECT_NEAR(end[k], expected / (k % 2 == 0 ? 1 : 2), 0.003 * std::abs(expected)) << k;
}

// Requirement: every model on shaken ground moves as an oscillator of k/rho does, whole.
TEST(Foundation, ShakesZones) {
  scene::Scene scene = scene_of(kBody + kZones);
  shake(*scene.mutable_continuum()->add_foundations());
  expect_oscillator(scene);
}

TEST(Foundation, ShakesParticles) {
  scene::Scene scene = scene_of(kBody + kParticles);
  shake(*scene.mutable_particles()->add_foundations());
  expect_oscillator(scene);
}

TEST(Foundation, ShakesAnOverlapAsItsModels) {
  scene::Scene scene =
      scene_of(kBody + kZones + kParticles +
               "interface { overlap { particles_begin { x: 6 y: 0 } continuum_ends { x: 10 y: 0 } } }");
  shake(*scene.mutable_particles()->add_foundations());
  shake(*scene.mutable_continuum()->add_foundations());
  expect_oscillator(scene);
}

// Requirement: the critical step knows the springs: at just that step, models held ten times as stiffly as
// they hold themselves stay with the ground.
TEST(Foundation, EntersTheCriticalStep) {
  for (const std::string& body : {kZones, kParticles}) {
    scene::Scene scene = scene_of(kBody + body);
    scene.mutable_time()->set_dt_factor(1);
    scene::Foundation& foundation = scene.has_continuum() ? *scene.mutable_continuum()->add_foundations()
                                                          : *scene.mutable_particles()->add_foundations();
    shake(foundation);
    for (auto* spring : {foundation.mutable_x(), foundation.mutable_y()}) {
      spring->set_stiffness(kDensity * 2e8);
      spring->clear_dashpot();
    }
    const double ground = kVelocity * (1 - std::cos(kOmega * kEnd)) / kOmega;
    EXPECT_NEAR(end_of(scene)[0], ground, 1e-3 * ground) << body;
  }
}

// Requirement: a body that moves and turns as its edge does stays rigid: a bar between two edges that turn
// about one centre strains nowhere.
TEST(BodyMotion, OfTwoEdgesTurnsABarAsARigidBody) {
  scene::Scene scene = scene_of(
      "plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } "
      "time { duration: 1 dt_factor: 0.9 } continuum { block { x_min: 0 x_max: 10 y_min: -1 y_max: 1 "
      "zones_x: 20 "
      "zones_y: 4 } damping { local { alpha: 0.5 } } motions { where { x_max: 0 } } motions { where { x_min: "
      "10 } } "
      "histories { name: 'a' quantity: DISPLACEMENT_X at { x: 5 y: 0.5 } } "
      "histories { name: 'a' quantity: DISPLACEMENT_Y at { x: 5 y: 0.5 } } "
      "histories { name: 'a' quantity: STRESS_XX at { x: 5 y: 0.5 } } }");
  for (int i = 0; i < 2; ++i) {
    scene::BodyMotion& body = *scene.mutable_continuum()->mutable_motions(i)->mutable_body();
    body.mutable_centre()->set_x(2);
    body.mutable_centre()->set_y(0);
    body.set_path("edge.csv");
    body.set_content(
        "time_s,vx_m_per_s,vy_m_per_s,spin_rad_per_s\n0,0,0,0\n0.1,0.1,-0.2,0.01\n0.4,0.1,-0.2,0.01\n"
        "0.5,0,0,0\n");
  }
  const auto end = end_of(scene);
  const double seconds = 0.05 + 0.3 + 0.05;  // at full velocity
  EXPECT_NEAR(end[0], seconds * (0.1 - 0.01 * 0.5), 1e-6);
  EXPECT_NEAR(end[1], seconds * (-0.2 + 0.01 * 3), 1e-6);
  EXPECT_NEAR(end[2], 0, 1e9 * 1e-9);  // edges that do not turn would strain it by 1e-3
}

}  // namespace
}  // namespace adit::foundation_test
