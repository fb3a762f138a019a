// Bonded discs crack where and when theory says: beams bent at three points, a disc squeezed along its
// diameter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/model/calibration.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::cracking_test {
namespace {

struct Crack {
  double time, x, y;
  BondState mode;
};

// A scene of discs alone, step by step.
class CrackRun {
 public:
  explicit CrackRun(const scene::Scene& scene, std::size_t threads = 1)
      : model_(read_model(scene)),
        solver_(model_, threads),
        dt_(0.5 * critical_step(model_)),
        loads_(model_, solver_.particles()),
        motions_(model_, solver_.particles()) {}

  void step() {
    solver_.step({number_++, dt_}, loads_, motions_);
    for (const std::uint32_t bond : solver_.broken()) cracks_.push_back(crack(bond));
  }
  double time() const { return static_cast<double>(number_) * dt_; }
  const std::vector<Crack>& cracks() const { return cracks_; }
  const Model& model() const { return model_; }
  const Solver& solver() const { return solver_; }

  // Until the first crack, which must come before `latest` [s].
  std::optional<Crack> first_crack(double latest) {
    while (cracks_.empty() && time() < latest) step();
    return cracks_.empty() ? std::nullopt : std::optional(cracks_.front());
  }

 private:
  // In the middle between the discs at rest.
  Crack crack(std::uint32_t bond) const {
    const auto& bonds = solver_.bonds();
    const std::uint32_t i = bonds.first[bond], j = bonds.second[bond];
    const Discs& discs = model_.discs;
    return {time(), (discs.x[i] + discs.x[j]) / 2, (discs.y[i] + discs.y[j]) / 2, bonds.state[bond]};
  }

  Model model_;
  Solver solver_;
  double dt_;
  Loads loads_;
  PrescribedMotions motions_;
  std::uint64_t number_ = 0;
  std::vector<Crack> cracks_;
};

void hold_y(scene::Particles& p, double x_min, double x_max, double y_max) {
  auto& support = *p.add_motions();
  support.mutable_where()->set_x_min(x_min);
  support.mutable_where()->set_x_max(x_max);
  support.mutable_where()->set_y_max(y_max);
  support.mutable_velocity()->set_y(0);
}

// A load downwards on the discs between x_min and x_max above y_min, that grows to `largest` within
// `duration`.
void press(scene::Particles& p, double x_min, double x_max, double y_min, double largest, double duration) {
  auto& load = *p.add_loads();
  load.mutable_where()->set_x_min(x_min);
  load.mutable_where()->set_x_max(x_max);
  load.mutable_where()->set_y_min(y_min);
  load.mutable_force()->set_y(-largest);
  auto& table = *load.mutable_time()->mutable_table();
  for (const double value : {0.0, 1.0}) {
    table.add_time(value * duration);
    table.add_value(value);
  }
}

// A row of discs with cement between them, held at its ends and pressed in the middle, slowly: a cement strip
// of half width r breaks where the moment in it is sigma_t I / r, I = 2 r^3 / 3. The largest is that beside
// the middle disc, P / 2 (L / 2 - R): there the first crack opens at P = 2 sigma_t I / (r (L / 2 - R)).
TEST(ThreePointBend, RowOfCementedDiscsCracksBesideTheMiddleAtTheLoadOfTheory) {
  constexpr int kDiscs = 15;
  constexpr double kRadius = 0.5, kStrength = 1e6, kWidth = 0.8;
  auto scene = test::square_scene(kDiscs, 1);
  auto& p = *scene.mutable_particles();
  auto& cement = *p.mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(1e10);
  cement.set_shear_stiffness(4e9);
  cement.set_width(kWidth);
  cement.set_tensile_strength(kStrength);
  p.mutable_damping()->set_local(0.7);
  hold_y(p, 0, 1, 1);
  hold_y(p, kDiscs - 1, kDiscs, 1);
  const double r = kWidth * kRadius, span = kDiscs - 1, middle = 0.5 * kDiscs;
  const double theory = 2 * kStrength * (2 * r * r * r / 3) / (r * (span / 2 - kRadius));
  const double duration = 60;
  press(p, middle - 0.1, middle + 0.1, 0, 2 * theory, duration);

  const auto crack = CrackRun(scene).first_crack(duration);
  ASSERT_TRUE(crack);
  EXPECT_EQ(crack->mode, BondState::kTensileCrack);
  EXPECT_NEAR(std::abs(crack->x - middle), kRadius, 1e-9);
  EXPECT_NEAR(2 * crack->time / duration, 1, 0.005);
}

// A beam of a lattice, about 8 times as long as high.
struct Beam {
  static constexpr double kRadius = 0.05, kStrength = 1e5, kDuration = 1;
  static constexpr int kRows = 11, kColumns = 81;
  double pitch = std::numbers::sqrt3 * kRadius, height = kRows * pitch, length = kColumns * 2 * kRadius;
  double span = length - 2 * kRadius, middle = length / 2;

  // Pressed at the top in the middle until the load is `largest`.
  scene::Scene scene(double largest) const {
    auto scene = test::empty_scene();
    auto& p = *scene.mutable_particles();
    auto& packing = *p.mutable_packing();
    test::set_box(packing, length, height);
    packing.set_radius(kRadius);
    p.mutable_bonds()->set_tensile_strength(kStrength);
    p.mutable_damping()->set_local(0.7);
    hold_y(p, 0, 2 * kRadius, pitch);
    hold_y(p, length - 2 * kRadius, length, pitch);
    press(p, middle - kRadius / 2, middle + kRadius / 2, height - pitch, largest, kDuration);
    return scene;
  }
  // Load at which the bonds of the lowest row reach their strength. The stress of simple bending, less what
  // the concentrated load opposite takes off (Seewald; Timoshenko & Goodier 1970, section 40), strains the
  // row's bonds:
  //   sigma = 3 P L / (2 h^2) (1 - 0.1773 h / L) at the face, N = kn 2 R sigma / E at the row's centres.
  double load_of_theory() const {
    const BondStiffness bond = calibrate(10e9, 0.2, Plane::kStress);
    const double stress = kStrength * 10e9 / (bond.normal * 2 * kRadius) / (1 - pitch / height);
    return stress * 2 * height * height / (3 * span) / (1 - 0.1773 * height / span);
  }
};

// A plain beam: the first crack opens in the lowest row in the middle.
TEST(ThreePointBend, LatticeBeamCracksAtTheBottomInTheMiddleAtTheLoadOfTheory) {
  const Beam beam;
  const double theory = beam.load_of_theory();
  const auto crack = CrackRun(beam.scene(1.5 * theory)).first_crack(Beam::kDuration);
  ASSERT_TRUE(crack);
  EXPECT_EQ(crack->mode, BondState::kTensileCrack);
  EXPECT_LT(crack->y, beam.pitch);
  EXPECT_NEAR(crack->x, beam.middle, 1.01 * Beam::kRadius);
  EXPECT_NEAR(1.5 * crack->time / Beam::kDuration, 1, 0.025);
}

// A notch, a joint without bonds, from the bottom to a third of the height: the crack starts at its tip, at a
// lower load, and runs upwards.
TEST(ThreePointBend, NotchedBeamCracksAtTheTipOfTheNotch) {
  const Beam beam;
  auto scene = beam.scene(beam.load_of_theory());
  auto& notch = *scene.mutable_particles()->add_joints();
  const double x = beam.middle + 0.3 * Beam::kRadius, depth = 4 * beam.pitch;
  test::set(*notch.mutable_from(), x, -1);
  test::set(*notch.mutable_to(), x, depth);
  notch.set_open(true);
  CrackRun run(scene);
  const auto first = run.first_crack(Beam::kDuration);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->mode, BondState::kTensileCrack);
  EXPECT_NEAR(first->x, x, 2 * Beam::kRadius);
  EXPECT_NEAR(first->y, depth, beam.pitch);
  EXPECT_LT(first->time, 0.6 * Beam::kDuration);
  while (run.cracks().size() < 8 && run.time() < Beam::kDuration) run.step();
  ASSERT_EQ(run.cracks().size(), 8u);
  for (const Crack& crack : run.cracks()) {
    EXPECT_NEAR(crack.x, x, 6 * Beam::kRadius);
    EXPECT_GT(crack.y, depth - beam.pitch);
  }
}

// A disc of cemented grains between two platens.
scene::Scene brazilian_scene(double x, double radius) {
  auto scene = test::empty_scene();
  auto& p = *scene.mutable_particles();
  auto& packing = *p.mutable_random_packing();
  test::set_box(packing, 2 * x, 2 * x);
  packing.set_radius_min(0.5e-3);
  packing.set_radius_max(0.83e-3);
  packing.set_stress(2e7);
  auto& circle = *p.mutable_within()->mutable_circle();
  test::set(*circle.mutable_centre(), x, x);
  circle.set_radius(radius);
  auto& cement = *p.mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(4.5e13);
  cement.set_shear_stiffness(1.8e13);
  cement.set_tensile_strength(6e7);
  cement.set_cohesion(1.8e8);
  p.mutable_contacts()->set_normal_stiffness(6e10);
  p.mutable_contacts()->set_shear_stiffness(2.4e10);
  p.mutable_contacts()->set_friction(0.5);
  p.mutable_damping()->set_local(0.7);
  return scene;
}

void add_platen(scene::Particles& p, const std::string& name, double x, double y, double speed) {
  auto& wall = *p.add_walls();
  wall.set_name(name);
  test::set(*wall.mutable_from(), 0, y);
  test::set(*wall.mutable_to(), 2 * x, y);
  wall.mutable_velocity()->set_y(speed);
}

// A Brazilian disc splits along its loaded diameter: more than four in five of the cracks are tensile and lie
// within a quarter of the radius from it, from platen to platen, and the halves part.
TEST(BrazilianDisc, SplitsAlongTheLoadedDiameter) {
  constexpr double kMiddle = 0.026, kRadius = 0.025, kSpeed = 0.2;
  auto scene = brazilian_scene(kMiddle, kRadius);
  auto& p = *scene.mutable_particles();
  // on the grains of an arc of 20 degrees
  const double platen = kRadius * std::cos(std::numbers::pi / 18) + 0.66e-3;
  add_platen(p, "lower", kMiddle, kMiddle - platen, kSpeed);
  add_platen(p, "upper", kMiddle, kMiddle + platen, -kSpeed);
  CrackRun run(scene);
  const Discs& discs = run.model().discs;
  double peak = 0, load = 0;
  while (run.time() < 6e-3 && (run.cracks().size() < 10 || load > 0.1 * peak)) {
    run.step();
    load = (run.solver().walls().force(1).y - run.solver().walls().force(0).y) / 2;
    peak = std::max(peak, load);
  }
  ASSERT_LT(load, 0.1 * peak);
  std::vector<double> height;
  for (const Crack& crack : run.cracks())
    if (std::abs(crack.x - kMiddle) < 0.25 * kRadius && crack.mode == BondState::kTensileCrack)
      height.push_back((crack.y - kMiddle) / kRadius);
  EXPECT_GT(static_cast<double>(height.size()), 0.8 * static_cast<double>(run.cracks().size()));
  EXPECT_LT(std::ranges::min(height), -0.8);  // from platen to platen
  EXPECT_GT(std::ranges::max(height), 0.8);
  const Particles& particles = run.solver().particles();
  double apart = 0;  // of the right half from the left, beyond half a radius from the diameter
  for (const double side : {-1.0, 1.0}) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (side * (discs.x[i] - kMiddle) > kRadius / 2) {
        sum += side * particles.ux[i];
        ++count;
      }
    apart += sum / count;
  }
  EXPECT_GT(apart, 1e-4);
}

}  // namespace
}  // namespace adit::dem::cracking_test
