// Requirements on bars through cells that move.
#include "dem_server/engines/general/bars/bars.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/model/weigh.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/barred_scene.hpp"
#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::bars_test {
namespace {

protocol::Team& team() {
  static protocol::Team two(2);
  return two;
}

Model barred(double tension = 2.9e6) {
  auto scene = test::barred_member();
  scene.mutable_material()->mutable_fracture()->set_tensile_strength(tension);
  return read_model(scene);
}

// That yield where cells shift by a tenth of a millimetre.
Model with_weak_dowels() {
  Model model = barred();
  for (BarNode& node : model.bars[0].nodes) node.dowel_strength = 2e3;
  return model;
}

// The bar bonds along its whole length, and its elements are about as long as cells.
TEST(Bars, AreHeldAlongTheirWholeLength) {
  const Model model = barred();
  ASSERT_EQ(model.bars.size(), 1u);
  const Bar& bar = model.bars[0];
  double length = 0;
  for (const BarNode& node : bar.nodes) length += node.length;
  EXPECT_NEAR(length, 1, 1e-12);
  EXPECT_GT(bar.nodes.size(), 20u);
  for (std::size_t k = 0; k + 1 < bar.nodes.size(); ++k) {
    EXPECT_GT(bar.nodes[k + 1].x - bar.nodes[k].x, 0.01);
    EXPECT_NEAR(bar.nodes[k].y, 0.1, 1e-12);
  }
  EXPECT_NEAR(bar.nodes[0].bond.strength, 2.5e6 * std::sqrt(38), 1);
}

// A whole circle has as much bar as it is long, wherever it begins.
TEST(Bars, CloseRings) {
  auto scene = test::barred_member();
  auto& round = *scene.mutable_particles()->mutable_bars(0)->mutable_along()->mutable_circle();
  test::set(*round.mutable_centre(), 0.5, 0.1);
  round.set_radius(0.08);
  const Bar bar = read_model(scene).bars[0];
  EXPECT_TRUE(bar.closed);
  EXPECT_EQ(bar.elements(), bar.nodes.size());
  double length = 0;
  for (const BarNode& node : bar.nodes) length += node.length;
  EXPECT_NEAR(length, 2 * std::numbers::pi * 0.08, 1e-5);
}

// A member that moves as one body, by a quarter turn, leaves its bar without force.
TEST(Bars, DoNotFeelRigidMotions) {
  Particles p = at_rest(barred());
  Bars bars(barred().bars, p);
  const double turn = std::numbers::pi / 2;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.ux[i] = std::cos(turn) * p.x[i] - std::sin(turn) * p.y[i] - p.x[i] + 3;
    p.uy[i] = std::sin(turn) * p.x[i] + std::cos(turn) * p.y[i] - p.y[i] - 1;
    p.spin[i] = turn;
  }
  bars.add_forces(1, team(), p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.fx[i], 0, 1e-3);
    EXPECT_NEAR(p.fy[i], 0, 1e-3);
    EXPECT_NEAR(p.moment[i], 0, 1e-3);
  }
}

// Whatever the cells do, the bar keeps their linear and angular momentum.
TEST(Bars, KeepMomentum) {
  const Model model = with_weak_dowels();
  Particles p = at_rest(model);
  Bars bars(model.bars, p);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> small(-1e-4, 1e-4);
  for (int n = 0; n < 20; ++n) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.ux[i] += small(random);
      p.uy[i] += small(random);
      p.spin[i] = 10 * small(random);
      p.fx[i] = p.fy[i] = p.moment[i] = 0;
    }
    bars.add_forces(1, team(), p);
    double x = 0, y = 0, moment = 0, size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      x += p.fx[i];
      y += p.fy[i];
      moment += p.moment[i] + (p.x[i] + p.ux[i]) * p.fy[i] - (p.y[i] + p.uy[i]) * p.fx[i];
      size += std::hypot(p.fx[i], p.fy[i]);
    }
    EXPECT_NEAR(x, 0, 1e-12 * size);
    EXPECT_NEAR(y, 0, 1e-12 * size);
    EXPECT_NEAR(moment, 0, 1e-12 * size);
  }
  EXPECT_GT(bars.slipped(), 0);
  EXPECT_GT(bars.dowels(), 0);
}

// The work of the bar's forces on cells that swing by small motions is what it stores and loses.
TEST(Bars, KeepTheirLedger) {
  const Model model = with_weak_dowels();
  Particles p = at_rest(model);
  Bars bars(model.bars, p);
  double work = 0, largest = 0;
  Particles before = p;
  constexpr int kSteps = 4000;
  for (int n = 1; n <= kSteps; ++n) {
    const double phase = 4 * std::numbers::pi * n / kSteps, rate = 4 * std::numbers::pi / kSteps;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double one = 1e-3 * std::sin(50 * p.x[i]), other = 3e-4 * std::cos(70 * p.x[i] + p.y[i]);
      p.vx[i] = rate * std::cos(phase) * one;
      p.vy[i] = rate * std::cos(phase) * other;
      p.spin[i] = 2 * rate * std::cos(phase) * other;
      p.ux[i] += p.vx[i];
      p.uy[i] += p.vy[i];
      p.fx[i] = p.fy[i] = p.moment[i] = 0;
    }
    bars.add_forces(1, team(), p);
    for (std::size_t i = 0; i < p.size(); ++i)
      work -= (p.vx[i] * (before.fx[i] + p.fx[i]) + p.vy[i] * (before.fy[i] + p.fy[i]) +
               p.spin[i] * (before.moment[i] + p.moment[i])) /
              2;
    before = p;
    largest = std::max(largest, bars.strain_energy() + bars.dissipated());
    // Motions turn the bar, whose work the trapezoid counts to the second order of a step.
    EXPECT_NEAR(work, bars.strain_energy() + bars.dissipated(), 1e-5 * largest + 1e-6);
  }
  EXPECT_GT(bars.yielded(), 0);
  EXPECT_GT(bars.slipped(), 0);
  EXPECT_GT(bars.dowels(), 0);
}

// A member that two halves of cells pull apart.
struct Pulled {
  test::Run run;
  explicit Pulled(std::size_t threads) : run(barred(), 0.5 * critical_step(barred()), threads) {
    Particles& p = run.solver.particles();
    for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = p.x[i] < 0.5 ? -0.5 : 0.5;
  }
};

// The member cracks, the bar is strained across the crack; every bit is the same for any number of threads.
TEST(Bars, DoNotDependOnThreads) {
  Pulled one(1), three(3);
  one.run.steps(2000);
  three.run.steps(2000);
  EXPECT_GT(one.run.solver.facets().fracture(), 0);
  EXPECT_GT(one.run.solver.bars().slipped(), 0);
  const Particles &a = one.run.solver.particles(), &b = three.run.solver.particles();
  EXPECT_EQ(a.ux, b.ux);
  EXPECT_EQ(a.uy, b.uy);
  EXPECT_EQ(a.vx, b.vx);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(one.run.solver.bars().dissipated(), three.run.solver.bars().dissipated());
}

// A state that was saved and read goes on with the same bits.
TEST(Bars, GoOnFromASavedState) {
  Pulled whole(1), resumed(1);
  whole.run.steps(1000);
  state::Archive written;
  whole.run.solver.particles().exchange(written);
  whole.run.solver.exchange(written);
  state::Archive read(written.take());
  resumed.run.solver.particles().exchange(read);
  resumed.run.solver.exchange(read);
  read.require_end();
  resumed.run.next = whole.run.next;
  whole.run.steps(500);
  resumed.run.steps(500);
  EXPECT_EQ(whole.run.solver.particles().ux, resumed.run.solver.particles().ux);
  EXPECT_EQ(whole.run.solver.particles().vy, resumed.run.solver.particles().vy);
  EXPECT_EQ(whole.run.solver.bars().dissipated(), resumed.run.solver.bars().dissipated());
  EXPECT_EQ(whole.run.solver.bars().chain(0).slip(3), resumed.run.solver.bars().chain(0).slip(3));
}

// A cracked member with a bar holds together where one without falls apart.
TEST(Bars, HoldCracksTogether) {
  Pulled barred_run(1);
  Model plain = barred();
  plain.bars.clear();
  test::Run without(plain, barred_run.run.dt);
  Particles& p = without.solver.particles();
  for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = p.x[i] < 0.5 ? -0.5 : 0.5;
  barred_run.run.steps(4000);
  without.steps(4000);
  const auto opening = [](const Particles& of) {
    double left = 0, right = 0, n_left = 0, n_right = 0;
    for (std::size_t i = 0; i < of.size(); ++i)
      (of.x[i] < 0.5 ? left : right) += of.ux[i], (of.x[i] < 0.5 ? n_left : n_right) += 1;
    return right / n_right - left / n_left;
  };
  EXPECT_LT(opening(barred_run.run.solver.particles()), 0.5 * opening(without.solver.particles()));
}

// A bar whose particle was taken away bears nothing there.
TEST(Bars, EndWhereParticlesWereTakenAway) {
  const Model model = barred();
  Particles p = at_rest(model);
  Bars bars(model.bars, p);
  const std::uint32_t gone = model.bars[0].nodes[5].disc;
  p.mass[gone] = 0;
  bars.begin_stage(0, 1, p);
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 1e-3 * p.x[i];
  bars.add_forces(0, team(), p);
  EXPECT_EQ(p.fx[gone], 0);
  EXPECT_EQ(bars.chain(0).force(4), 0);
  EXPECT_EQ(bars.chain(0).force(5), 0);
  EXPECT_GT(bars.chain(0).force(15), 0);
}

// A bar that is installed later begins free of stress as the particles lie then.
TEST(Bars, OfALaterStageBeginFreeOfStress) {
  Model model = barred();
  model.bars[0].stage = 2;
  Particles p = at_rest(model);
  Bars bars(model.bars, p);
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 1e-3 * p.x[i];
  bars.add_forces(0, team(), p);
  EXPECT_EQ(bars.strain_energy(), 0);
  bars.begin_stage(1, 2, p);
  bars.add_forces(0, team(), p);
  EXPECT_NEAR(bars.strain_energy(), 0, 1e-12);
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 1.5e-3 * p.x[i];
  bars.add_forces(0, team(), p);
  model.bars[0].stage = 0;
  Bars from_rest(model.bars, p);
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 0.5e-3 * p.x[i];
  from_rest.add_forces(0, team(), p);
  EXPECT_GT(from_rest.chain(0).stress(12), 90e6);
  EXPECT_NEAR(bars.chain(0).stress(12), from_rest.chain(0).stress(12), 1e-9 * 90e6);
}

// Histories ask for a place on a bar.
TEST(Bars, HistoriesNeedABarAtTheirPlace) {
  auto scene = test::barred_member();
  auto& history = *scene.mutable_particles()->add_histories();
  history.set_name("bar");
  history.set_quantity(scene::BAR_SLIP);
  const auto refuses = [&](const std::string& path, const std::string& message) {
    GeneralEngine engine(read_model(scene), 1);
    adit::test::expect_refusal([&] { engine.watch(scene.particles()); }, "particles.histories[0]." + path,
                               message);
  };
  refuses("at", "is missing; give the place on the bar");
  test::set(*history.mutable_at(), 0.5, 0.2);
  refuses("at", "is (0.5, 0.2) m, but the nearest bar is");
  scene.mutable_particles()->clear_bars();
  refuses("quantity", "is bar_slip, but the scene has no bar; add it to particles.bars");
}

// Bars end before the overlap, where particles have a part of their weight only.
TEST(Bars, ThatReachIntoTheOverlapAreRefused) {
  const Model model = barred();
  std::vector<double> centres(model.discs.size(), 1.0);
  const std::vector<double> midpoints(model.bonds.size(), 1.0);
  centres[model.bars[0].nodes[3].disc] = 0.5;
  adit::test::expect_refusal(
      [&] {
        weigh(model, {centres, midpoints, 0});
      },
      "particles.bars[0].along", "lies in the overlap with the continuum");
}

}  // namespace
}  // namespace adit::dem::bars_test
