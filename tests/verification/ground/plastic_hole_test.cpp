// Requirement: a circular hole in Mohr-Coulomb ground under all-round stress has Salençon's (1969) plastic
// radius and stresses, within 2 %, with both kinds of zones, with and without dilation.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"

namespace adit::fdm::test::plastic_hole_test {
namespace {

using std::numbers::pi;

constexpr std::uint64_t kSteps = 14000;
constexpr double kPressure = 30e6, kCohesion = 3.45e6, kFriction = pi / 6;  // far away; of the ground

// Salençon's solution without support, hole radius 1; tension positive.
struct Salencon {
  double k = (1 + std::sin(kFriction)) / (1 - std::sin(kFriction)), q = 2 * kCohesion * std::sqrt(k);
  double apex = q / (k - 1);
  double radius = std::pow(2 / (k + 1) * (kPressure + apex) / apex, 1 / (k - 1));
  double radial(double r) const {
    if (r < radius) return apex - apex * std::pow(r, k - 1);
    const double at_radius = (2 * kPressure - q) / (k + 1);
    return -kPressure + (kPressure - at_radius) * std::pow(radius / r, 2);
  }
  double around(double r) const { return r < radius ? k * radial(r) - q : -2 * kPressure - radial(r); }
};

// A quarter of a ring of inner radius 1, whose rows grow outwards.
struct Ring {
  static constexpr std::uint32_t kAround = 12, kRows = 48;
  Grid grid;
  std::vector<double> radius;  // of each line of points
  Ring() {
    for (std::uint32_t j = 0; j <= kRows; ++j) radius.push_back(std::exp(std::log(8.0) * j / kRows));
    for (std::uint32_t i = 0; i <= kAround;
         ++i)  // zones run counter-clockwise: along the radius, then around
      for (const double r : radius) {
        const double angle = pi / 2 * i / kAround;
        grid.x.push_back(i == kAround ? 0 : r * std::cos(angle));
        grid.y.push_back(i == 0 ? 0 : r * std::sin(angle));
      }
    const auto point = [](std::uint32_t i, std::uint32_t j) {
      return static_cast<std::int32_t>(i * (kRows + 1) + j);
    };
    for (std::uint32_t i = 0; i < kAround; ++i)
      for (std::uint32_t j = 0; j < kRows; ++j)
        grid.zones.push_back({point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)});
  }
  // Forces of a unit traction outwards on the line of points j.
  Load traction(std::uint32_t j, double traction, TimeFactor factor) const {
    Load load{{}, {}, {}, std::move(factor)};
    for (std::uint32_t i = 0; i <= kAround; ++i) {
      const std::uint32_t here = i * (kRows + 1) + j, before = i > 0 ? here - kRows - 1 : here;
      const std::uint32_t after = i < kAround ? here + kRows + 1 : here;
      load.points.push_back(here);
      load.fx.push_back(traction * (grid.y[after] - grid.y[before]) / 2);
      load.fy.push_back(-traction * (grid.x[after] - grid.x[before]) / 2);
    }
    return load;
  }
};

struct Case {
  ZoneKind kind;
  double dilation;
};
class PlasticHole : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, PlasticHole,
    testing::Values(Case{ZoneKind::kAssumedStrain, 0}, Case{ZoneKind::kAssumedStrain, kFriction},
                    Case{ZoneKind::kMixedDiscretization, 0}, Case{ZoneKind::kMixedDiscretization, kFriction}),
    [](const auto& info) {
      return std::string(info.param.kind == ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                     : "MixedDiscretization") +
             (info.param.dilation > 0 ? "Dilating" : "");
    });

TEST_P(PlasticHole, HasSalenconsStressesAndRadius) {
  const auto [kind, dilation] = GetParam();
  const Salencon exact;
  const Ring ring;
  Material rock{2500, 6.78e9, 0.21};
  rock.mohr_coulomb = MohrCoulomb({kCohesion, kFriction, dilation, apex(kCohesion, kFriction)});
  const Ground ground{{rock}, std::vector<std::uint32_t>(ring.grid.zones.size(), 0)};
  const std::vector<double> weights(ring.grid.zones.size(), 1.0);
  ZoneSet zones(kind, ring.grid, ground, weights);
  for (std::size_t z = 0; z < weights.size(); ++z) {
    zones.set_stress(z, {-kPressure, -kPressure, 0});
    zones.set_stress_zz(z, -kPressure);
  }
  std::vector<std::uint32_t> on_x, on_y;
  for (std::uint32_t i = 0; i < ring.grid.x.size(); ++i) {
    if (ring.grid.y[i] == 0) on_x.push_back(i);
    if (ring.grid.x[i] == 0) on_y.push_back(i);
  }
  // the support of the wall falls slowly; outside, the traction goes from the far pressure to that of the
  // solution
  const double dt = 0.9 * critical_step(kind, ring.grid, ground), end = static_cast<double>(kSteps) * dt;
  const auto excavated = [end](double t) { return std::min(1.0, t / (0.7 * end)); };
  const double outside = exact.radial(8);
  const auto fixed = [](double) { return 1.0; };
  Continuum continuum(
      std::move(zones), lumped_masses(ring.grid, weights, rock.density),
      {ring.traction(0, kPressure, [=](double t) { return 1 - excavated(t); }),
       ring.traction(Ring::kRows, 1,
                     [=](double t) { return -kPressure + excavated(t) * (outside + kPressure); })},
      {{on_x, Axis::kY, 0.0, fixed}, {on_y, Axis::kX, 0.0, fixed}});
  for (std::uint64_t n = 0; n < kSteps; ++n) {
    continuum.step({n, dt});
    for (auto velocity : {continuum.vx(), continuum.vy()})
      for (double& v : velocity) v *= 0.99;  // at rest in the end
  }

  double radius =
      0;  // outside the plastic ring the difference of stresses falls with the square of the radius
  int elastic = 0;
  for (std::size_t z = 0; z < weights.size(); ++z) {
    const auto c = corners(ring.grid, z);
    const double x = (c.x[0] + c.x[1] + c.x[2] + c.x[3]) / 4, y = (c.y[0] + c.y[1] + c.y[2] + c.y[3]) / 4;
    const double r = std::hypot(x, y), cosine = x / r, sine = y / r;
    const auto s = continuum.zones().stress(z);
    const auto local = turned({s.xx, s.yy, 0, s.xy}, cosine, -sine);
    if (std::abs(r / exact.radius - 1) > 0.04) {
      EXPECT_NEAR(local.xx, exact.radial(r), 0.02 * kPressure) << r;
      EXPECT_NEAR(local.yy, exact.around(r), 0.02 * kPressure) << r;
      const bool yields =
          static_cast<unsigned>(continuum.zones().field(z, ZoneField::kYieldState)) & kShearPast;
      EXPECT_EQ(yields, r < exact.radius) << r;
    }
    if (r < 2.5 || r > 5) continue;
    radius += r * std::sqrt((local.xx - local.yy) / 2 /
                            (kCohesion * std::cos(kFriction) + kPressure * std::sin(kFriction)));
    ++elastic;
  }
  RecordProperty("plastic_radius_ratio", std::to_string(radius / elastic / exact.radius));
  EXPECT_NEAR(radius / elastic, exact.radius, 0.02 * exact.radius);
}

}  // namespace
}  // namespace adit::fdm::test::plastic_hole_test
