// Requirement: a bar of cells that a compressive pulse runs through spalls where and when one-dimensional
// wave theory says, and its end flies off with the momentum of the pulse.
//
// The pulse rises to s over the length r, stays for P and falls over r. It comes back from the free end as
// tension (Rinehart 1951, J. Appl. Phys. 22, 555). When its front has run T since it met the end, the tension
// at x from the end is p(T - x) - p(T + x), p being the pulse behind its front. This is f_t nowhere before
//   T = P / 2 + r + r f_t / 2s,
// and then between r (1 - f_t / s) / 2 on both sides of x = (P + r) / 2. There it grows by 2s / r per length
// to s if nothing breaks. A facet that softens radiates: with u, its opening over G_f / f_t, S, that tension
// over f_t, and z = c t,
//   du / dz = (2 / l) (S - e^-u),     l = E G_f / f_t^2,
// up to its crack at u = 3. What is thrown off is half of the pulse long, and has all of its momentum, (P +
// r) s / c, less the impulse of the tension.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::spalling_test {
namespace {

constexpr double kYoung = 30e9, kDensity = 2400, kTensile = 2.5e6;  // [Pa], [kg/m^3]
constexpr double kSize = 0.01, kHeight = 0.05, kLength = 1.5;       // of the cells and the bar [m]
constexpr double kRise = 0.06, kStay = 0.4;                         // r, P [m]
constexpr double kPlace = (kStay + kRise) / 2;                      // of the crack, from the free end [m]
constexpr double kHillerborg = 3 * kSize;  // l: just stable softening, which takes little time [m]
const double kSpeed = std::sqrt(kYoung / kDensity);

// Poisson's ratio is 0, so that waves run by c at all lengths.
scene::Scene bar(double peak, std::uint64_t seed) {
  auto scene = test::empty_scene();
  auto& material = *scene.mutable_material();
  material.set_young_modulus(kYoung);
  material.set_poisson_ratio(0);
  material.set_density(kDensity);
  auto& fracture = *material.mutable_fracture();
  fracture.set_tensile_strength(kTensile);
  fracture.set_fracture_energy(kHillerborg * kTensile * kTensile / kYoung);
  fracture.set_compressive_strength(39e6);
  auto& particles = *scene.mutable_particles();
  auto& cells = *particles.mutable_cells();
  test::set_box(cells, kLength, kHeight);
  cells.set_size(kSize);
  cells.set_seed(seed);
  auto& load = *particles.add_loads();
  load.mutable_where()->set_x_max(kSize);
  load.mutable_force()->set_x(peak * kHeight);
  auto& table = *load.mutable_time()->mutable_table();
  for (const auto& [way, share] :
       {std::pair{0.0, 0.0}, {kRise, 1.0}, {kRise + kStay, 1.0}, {2 * kRise + kStay, 0.0}}) {
    table.add_time(way / kSpeed);
    table.add_value(share);
  }
  auto& end = *particles.add_histories();
  end.set_name("end");
  end.set_quantity(scene::DISPLACEMENT_X);
  test::set(*end.mutable_at(), kLength - kSize / 2, kHeight / 2);
  return scene;
}

class BarRun : public test::InProcessRun {
 public:
  BarRun(double peak, std::uint64_t seed) : test::InProcessRun(bar(peak, seed)) {}
  // The way of a wave since the start [m].
  double way() const { return kSpeed * static_cast<double>(next) * dt; }
  // The first crack until a wave has run so far.
  std::optional<wire::Crack> first_crack(double latest) {
    while (way() < latest)
      if (advance().cracks_size() > 0) return predicted.cracks(0);
    return std::nullopt;
  }
  double end_after(double latest) {
    while (way() < latest) advance();
    return predicted.histories(0);
  }
};

// From f_t at the place of the crack until it has cracked: the way of a wave [m], and the integral over it of
// the tension, with that before [N/m].
struct Softening {
  double way = 0, tension = 0;
};

Softening softening(double peak) {
  const double steps = 1e-4 * kSize, most = peak / kTensile;
  Softening found{0, kTensile * kRise / most / 4};
  for (double u = 0; u < 3; found.way += steps) {
    const double without = std::min(most, 1 + 2 * most * found.way / kRise);
    found.tension += steps * kTensile * std::exp(-u);
    u += steps * 2 / kHillerborg * (without - std::exp(-u));
  }
  return found;
}

// Facets side by side soften together, which takes somewhat longer than the one of theory.
TEST(Spalling, IsWhereAndWhenThePulseMeetsItsReflection) {
  const double peak = 2 * kTensile;
  const Softening soft = softening(peak);
  const double first = kLength + kStay / 2 + kRise + kRise * kTensile / (2 * peak) + soft.way;
  const double velocity = ((kStay + kRise) * peak - soft.tension) / (kDensity * kSpeed * kPlace);
  for (const std::uint64_t seed : {1, 2, 3}) {
    BarRun run(peak, seed);
    const auto crack = run.first_crack(2 * kLength);
    ASSERT_TRUE(crack) << seed;
    EXPECT_NEAR(kLength - crack->x(), kPlace, 2 * kSize) << seed;
    EXPECT_NEAR(run.way(), first, 3 * kSize) << seed;
    // The mean velocity of its end over periods of its vibrations is that of what flies off.
    const double way = run.way(), before = run.end_after(way);
    const double moved = run.end_after(way + 8 * kPlace) - before;
    EXPECT_NEAR(moved / (run.way() - way) * kSpeed, velocity, 0.07 * velocity) << seed;
  }
}

TEST(Spalling, NeedsAPulseOfTheTensileStrength) {
  EXPECT_FALSE(BarRun(0.9 * kTensile, 1).first_crack(2 * kLength));
}

}  // namespace
}  // namespace adit::dem::spalling_test
