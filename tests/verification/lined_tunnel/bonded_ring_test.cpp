// Requirements: thrust, moment, shear force and ovaling of a bonded lining of particles, in particles and a
// continuum that overlap, are those of the elastic annulus in elastic ground; a lining of beams in the same
// grid differs from it as theory says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "coupler/tunnel/expand.hpp"
#include "tests/verification/lined_tunnel/bonded_annulus.hpp"
#include "tests/verification/lined_tunnel/ovaling.hpp"
#include "tests/verification/particles/in_situ/in_situ.hpp"

namespace adit::test::bonded_ring_test {
namespace {

using oracle::RingForces;
using std::numbers::pi;

constexpr double kInner = 2, kThickness = 0.4, kOuter = kInner + kThickness, kRim = 6;
constexpr double kRows = 8, kDisc = kThickness / (kRows * std::numbers::sqrt3);
constexpr oracle::Solid kConcrete{35e9, 0.2}, kGround{5e8, 0.2};
constexpr double kPressure = -1e5, kShear = -5e4;  // sideways three times as much as from above
constexpr int kAround = 64;

// Forces on the edges of the round rim: the tractions there, by Simpson's rule over each edge.
std::string rim_loads(const oracle::Tractions& rim) {
  std::string text;
  const double step = 2 * pi / kAround;
  for (int k = 0; k < kAround; ++k) {
    double fx = 0, fy = 0;
    for (const auto& [at, share] :
         {std::pair{0.0, 1.0 / 6}, std::pair{0.5, 4.0 / 6}, std::pair{1.0, 1.0 / 6}}) {
      const double angle = (k + at) * step, length = share * step * kRim;
      const double radial = rim.mean + rim.radial_2 * std::cos(2 * angle);
      const double tangential = rim.tangential_2 * std::sin(2 * angle);
      fx += length * (radial * std::cos(angle) - tangential * std::sin(angle));
      fy += length * (radial * std::sin(angle) + tangential * std::cos(angle));
    }
    const double middle = (k + 0.5) * step;
    text += fmt::format(
        "edge_loads {{ where {{ circle {{ centre {{ x: {} y: {} }} radius: {} }} }} force {{ x: {} y: {} }} "
        "}} ",
        kRim * std::cos(middle), kRim * std::sin(middle), 0.55 * step * kRim, fx, fy);
  }
  return text;
}

std::string held(double x, double y, const std::string& component) {
  return fmt::format(
      "motions {{ where {{ circle {{ centre {{ x: {} y: {} }} radius: 1e-3 }} }} velocity {{ {}: 0 }} }} ", x,
      y, component);
}

// Ground from the outer side of the lining to a rim under these tractions, held against rigid motion alone.
std::string scene_with(const oracle::Tractions& rim, const std::string& in_grid, const std::string& beside) {
  return fmt::format(
             "material {{ young_modulus: {} poisson_ratio: {} density: 2000 }} time {{ duration: 1e-3 }} "
             "statics {{ unbalanced_ratio: 1e-6 count_from_stage: 0 }} "
             "continuum {{ blocks {{ ring {{ centre {{ x: 0 y: 0 }} inner_radius: {} outer_radius: {} }} "
             "along {{ zones: {} }} across {{ zones: 12 ratio: 1.08 }} }} ",
             kGround.young, kGround.poisson, kOuter, kRim, kAround) +
         held(kRim, 0, "y") + held(-kRim, 0, "y") + held(0, kRim, "x") + rim_loads(rim) + in_grid + " } " +
         beside;
}

// Thrust, moment and shear force at places evenly around the centre: their harmonics.
RingForces harmonics(const wire::Piece& piece) {
  const auto& thrust = field(piece.point_fields(), "thrust_N");
  const auto& moment = field(piece.point_fields(), "moment_Nm");
  const auto& shear = field(piece.point_fields(), "shear_N");
  RingForces sum{};
  const double share = 1.0 / thrust.size();
  for (int k = 0; k < thrust.size(); ++k) {
    const double twice = 2 * std::atan2(piece.points(2 * k + 1), piece.points(2 * k));
    sum.thrust += share * thrust[k];
    sum.moment += share * moment[k];
    sum.thrust_2 += share * 2 * std::cos(twice) * thrust[k];
    sum.moment_2 += share * 2 * std::cos(twice) * moment[k];
    sum.shear_2 += share * 2 * std::sin(twice) * shear[k];
  }
  return sum;
}

const wire::Piece& piece_named(const wire::Snapshot& snapshot, const std::string& name) {
  for (const auto& piece : snapshot.pieces())
    if (piece.name() == name) return piece;
  throw std::out_of_range(name);
}

void expect_near(const RingForces& found, const RingForces& wanted, double within = 0.03) {
  EXPECT_NEAR(found.thrust / wanted.thrust, 1, within);
  EXPECT_NEAR(found.thrust_2 / wanted.thrust_2, 1, within);
  EXPECT_NEAR(found.moment_2 / wanted.moment_2, 1, within);
  EXPECT_NEAR(found.shear_2 / wanted.shear_2, 1, within);
  EXPECT_LE(std::abs(found.moment - wanted.moment), within * std::abs(wanted.moment_2));
}

oracle::BondedAnnulus annulus() {
  return {kConcrete, kGround, kInner, kOuter, kPressure, kShear};
}

// Statics do not depend on masses; with these, waves are as fast in the lining as in the ground.
scene::Scene scene_of_particles() {
  const std::string tunnel = fmt::format(
      "tunnels {{ name: 'ring' centre {{ x: 0 y: 0 }} circle {{ radius: {} }} lining {{ thickness: {} "
      "material "
      "{{ young_modulus: {} poisson_ratio: {} density: {} }} to_ground {{ }} }} particles {{ radius: {} "
      "ground: "
      "0.6 overlap: 0.4 }} }} ",
      kInner, kThickness, kConcrete.young, kConcrete.poisson, 2000 * kConcrete.young / kGround.young, kDisc);
  const std::string text = scene_with(annulus().tractions(kRim), "", tunnel);
  return coupler::expand_tunnels(scene_of(text)).scene;
}

// The same lining and ground as cells, so many over the thickness.
scene::Scene scene_of_cells(double rows) {
  scene::Scene scene = scene_of_particles();
  scene::Particles& particles = *scene.mutable_particles();
  const scene::HexagonalPacking box = particles.packing();
  particles.clear_packing();
  scene::CellPacking& cells = *particles.mutable_cells();
  cells.set_x_min(box.x_min());
  cells.set_x_max(box.x_max());
  cells.set_y_min(box.y_min());
  cells.set_y_max(box.y_max());
  cells.set_size(kThickness / rows);
  for (scene::ParticleGroup& group : *particles.mutable_groups()) group.clear_bends_as_solid();
  return scene;
}

double history(const Settled& settled, scene::Quantity quantity) {
  const auto& histories = settled.model.scene.particles().histories();
  for (int k = 0; k < histories.size(); ++k)
    if (histories[k].quantity() == quantity) return settled.histories[1][static_cast<std::size_t>(k)];
  throw std::out_of_range("no such history");
}

void expect_ovaling(const Settled& settled, double within = 0.03) {
  const auto [along_x, along_y] = annulus().diameter_changes();
  ASSERT_GT(along_y, along_x);
  EXPECT_NEAR(history(settled, scene::LARGEST_DIAMETER_CHANGE) / along_y, 1, within);
  EXPECT_NEAR(history(settled, scene::SMALLEST_DIAMETER_CHANGE) / along_x, 1, within);
  EXPECT_NEAR(std::abs(history(settled, scene::LARGEST_DIAMETER_DIRECTION)), pi / 2, 0.01);
}

// A lining of beams on the ground's outline.
fdm::oracle::Tunnel tunnel_of_beams() {
  const auto concrete = fdm::lining_material(true, kConcrete.young, kConcrete.poisson, 1);
  return {kGround.shear_modulus(), kGround.poisson, kOuter,
          fdm::make_section(concrete, kThickness, std::pow(kThickness, 3) / 12, true)};
}

RingForces theory_of_beams() {
  const auto tunnel = tunnel_of_beams();
  const fdm::oracle::Ovaling ovaling(tunnel, kShear);
  return {thrust_under_pressure(tunnel, kPressure), 0, ovaling.thrust(), ovaling.moment(), ovaling.shear()};
}

// Under the tractions of their own theory at the rim.
RingForces forces_in_beams() {
  const auto tunnel = tunnel_of_beams();
  const fdm::oracle::Ovaling ovaling(tunnel, kShear);
  const double contact = thrust_under_pressure(tunnel, kPressure) / kOuter;
  const double mean = kPressure + (contact - kPressure) * std::pow(kOuter / kRim, 2);
  const std::string lining = fmt::format(
      "linings {{ name: 'ring' along {{ circle {{ centre {{ x: 0 y: 0 }} radius: {} }} }} thickness: {} "
      "young_modulus: {} poisson_ratio: {} }}",
      kOuter, kThickness, kConcrete.young, kConcrete.poisson);
  Settled settled(scene_with({mean, ovaling.radial_stress(kRim), ovaling.shear_stress(kRim)}, lining, ""));
  return harmonics(piece_named(settled.stepper.snapshots()[0], "linings"));
}

// Beams have no thickness: the shear stress of the ground acts on their axis, on the annulus half a thickness
// outside it. Its moment about the axis needs a further shear force, by which theory gives the annulus
// another one, and another thrust. Each lining has the forces of its own theory, and so they differ as the
// theories do.
void expect_differences_of_theories(const RingForces& bonded, const RingForces& beams) {
  const RingForces thick = annulus().forces(), thin = theory_of_beams();
  EXPECT_NEAR(bonded.thrust / beams.thrust, thick.thrust / thin.thrust, 0.03);
  EXPECT_NEAR(bonded.thrust_2 / beams.thrust_2, thick.thrust_2 / thin.thrust_2, 0.03);
  EXPECT_NEAR(bonded.moment_2 / beams.moment_2, thick.moment_2 / thin.moment_2, 0.03);
  EXPECT_NEAR(bonded.shear_2 / beams.shear_2 / (thick.shear_2 / thin.shear_2), 1, 0.03);
}

TEST(BondedRing, IsTheAnnulusAndDiffersFromBeamsAsTheoryDoes) {
  Settled settled(scene_of_particles());
  const RingForces bonded = harmonics(piece_named(settled.stepper.snapshots()[1], "sections"));
  expect_near(bonded, annulus().forces());
  expect_ovaling(settled);
  const RingForces beams = forces_in_beams();
  expect_near(beams, theory_of_beams());
  expect_differences_of_theories(bonded, beams);
}

void expect_annulus(const scene::Scene& scene) {
  Settled settled(scene);
  const RingForces found = harmonics(piece_named(settled.stepper.snapshots()[1], "sections"));
  expect_near(found, annulus().forces(), 0.02);
  expect_ovaling(settled, 0.02);
}

TEST(BondedRing, OfThreeAndFourRowsOfCellsIsTheAnnulus) {
  for (const double rows : {3, 4}) expect_annulus(scene_of_cells(rows));
}

// In ground whose cells grow to twice the size of the lining's.
TEST(BondedRing, InCoarserGroundIsTheAnnulus) {
  scene::Scene scene = scene_of_cells(2);
  scene::FinerCells& finer = *scene.mutable_particles()->mutable_cells()->add_finer();
  *finer.mutable_where() = scene.particles().groups(0).where();
  finer.set_size(kThickness / 4);
  expect_annulus(scene);
}

}  // namespace
}  // namespace adit::test::bonded_ring_test
