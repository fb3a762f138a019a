// Requirements on ground and the water that flows in it: a loaded column and a loaded disc consolidate as
// Terzaghi and de Leeuw tell, within 1 % of the first pressure and with errors of the second order; water
// that cannot leave keeps its pressure; a pattern of pressure dies out without oscillation, and waves are
// damped, as Biot tells.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "fdm_server/meshing/blocks.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::consolidation_test {
namespace {

using std::numbers::pi;

const Material kSkeleton{2000, 50e6, 0.2};
const double kShear = kSkeleton.elasticity().shear;                       // G [Pa]
const double kOedometric = kSkeleton.elasticity().bulk + 4 * kShear / 3;  // K + 4/3 G [Pa]
constexpr double kWater = 5e8;                                            // M [Pa]
const double kStorage = 1 / kWater + 1 / kOedometric;  // where the total stress stays [1/Pa]
const double kSpeed = std::sqrt((kOedometric + kWater) / kSkeleton.density);  // of P waves without flow [m/s]
constexpr double kSize = 10;     // H of the column, a of the disc [m]
constexpr double kLoad = 1e5;    // q [Pa]
constexpr double kRamp = 0.008;  // time factor c t/H^2, c = mobility/kStorage, in which the load grows

// The load grows over eight of the column's periods, by s - sin(2 pi s)/(2 pi). That leaves no vibration of
// periods that divide this time, as all of the column do, and less than a thousandth of the load of others
// as short. So inertia is not in the results, and no damping is needed. What consolidates counts time from
// the middle of the ramp.
const double kLoadingTime = 8 * 4 * kSize / kSpeed;
const double kMobility = kRamp * kSize * kSize / kLoadingTime * kStorage;  // [m^2/(Pa s)]

double ramp(double t) {
  const double s = std::min(t / kLoadingTime, 1.0);
  return s - std::sin(2 * pi * s) / (2 * pi);
}

struct Body {
  Grid grid;
  std::vector<PointPair> drained = {};
  Load load = {{}, {}, {}, ramp};
  std::vector<PrescribedMotion> rollers = {};

  void add_roller(Axis axis, double place) {
    PrescribedMotion roller{{}, axis, 0, [](double) { return 1; }};
    for (std::uint32_t i = 0; i < grid.x.size(); ++i)
      if ((axis == Axis::kX ? grid.x : grid.y)[i] == place) roller.points.push_back(i);
    rollers.push_back(std::move(roller));
  }
  void push(std::uint32_t point, double fx, double fy) {
    load.points.push_back(point);
    load.fx.push_back(fx);
    load.fy.push_back(fy);
  }
  // The sides whose middles are there are pressed upon, and open.
  void load_and_drain(const std::function<bool(double x, double y)>& there) {
    for (const Edge& edge : grid.boundary) {
      const auto a = static_cast<std::uint32_t>(edge.from), b = static_cast<std::uint32_t>(edge.to);
      const double dx = grid.x[b] - grid.x[a], dy = grid.y[b] - grid.y[a];  // the normal is (dy, -dx)
      if (!there(grid.x[a] + dx / 2, grid.y[a] + dy / 2)) continue;
      drained.push_back({a, b});
      for (const auto point : {a, b}) push(point, -kLoad * dy / 2, kLoad * dx / 2);
    }
  }
};

// Between rollers, tight, and as wide as a zone.
Body tight_column(std::uint32_t zones) {
  const double width = kSize / zones;
  Body body{make_grid({0, width, 0, kSize, 1, zones})};
  body.add_roller(Axis::kX, 0);
  body.add_roller(Axis::kX, width);
  body.add_roller(Axis::kY, 0);
  return body;
}

Body loaded_column(std::uint32_t zones) {
  Body body = tight_column(zones);
  body.load_and_drain([](double, double y) { return y == kSize; });
  return body;
}

// A quarter of a disc, pressed upon and drained at its rim: a core and two blocks around it, whose seams are
// skewed.
Body loaded_disc(std::uint32_t zones) {
  const double core = 0.5 * kSize, inside = 0.42 * kSize, outside = std::sqrt(0.5) * kSize;
  const Point middle{0, 0}, right{core, 0}, corner{inside, inside}, top{0, core};
  const Point rim_right{kSize, 0}, rim{outside, outside}, rim_top{0, kSize};
  const auto block = [zones](Side lower, Side right, Side upper, Side left) {
    return MappedBlock{"", {lower, right, upper, left}, {zones, 1, false}, {zones, 1, false}};
  };
  Body body{join({block({middle, right}, {right, corner}, {top, corner}, {middle, top}),
                  block({right, rim_right}, {rim_right, rim, middle, pi / 4}, {corner, rim}, {right, corner}),
                  block({top, corner}, {corner, rim}, {rim_top, rim, middle, -pi / 4}, {top, rim_top})})
                .grid};
  body.add_roller(Axis::kX, 0);
  body.add_roller(Axis::kY, 0);
  body.load_and_drain([](double x, double y) { return x > 0 && y > 0; });
  return body;
}

Ground wet_ground(const Grid& grid, double mobility) {
  Material material = kSkeleton;
  material.pores = Pores{kWater, mobility, mobility};
  return {{material}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
}

// A body in motion.
struct Sample {
  Grid grid;
  Continuum continuum;
  double dt;
  std::uint64_t next = 0;

  Sample(ZoneKind kind, const Body& body, double mobility = kMobility)
      : grid(body.grid),
        continuum(ZoneSet(kind, grid, wet_ground(grid, mobility), ones(grid)),
                  lumped_masses(grid, ones(grid), kSkeleton.density), {body.load}, body.rollers) {
    const std::vector<double> mobilities(grid.zones.size(), mobility), stiffness(grid.zones.size(), kWater);
    Flow flow(grid, make_faces(grid, {mobilities, mobilities}, body.drained, {}), stiffness);
    dt = std::min(0.9 * critical_step(kind, grid, wet_ground(grid, mobility)), flow.critical_step());
    continuum.set_flow(std::move(flow));
    continuum.zones().begin_time();
  }
  void step() { continuum.step({next++, dt}); }
  double time() const { return (static_cast<double>(next) - 1) * dt; }
  double time_factor() const { return kMobility / kStorage * (time() - kLoadingTime / 2) / (kSize * kSize); }
  void go_on_to(double factor) {
    while (next == 0 || time_factor() < factor) step();
  }
  double y(std::size_t zone) const { return centroid(corners(grid, zone))[1]; }
  double radius(std::size_t zone) const { return std::hypot(centroid(corners(grid, zone))[0], y(zone)); }
  double pressure(std::size_t zone) const { return continuum.zones().pore_pressure(zone); }
  double settlement() const { return -continuum.uy().back(); }

  // Of the pressure in a zone that it is to be.
  using Exact = std::function<double(std::size_t)>;
  double worst_error(const Exact& exact) const {
    double worst = 0;
    for (std::size_t z = 0; z < grid.zones.size(); ++z)
      worst = std::max(worst, std::abs(pressure(z) - exact(z)));
    return worst;
  }
  double mean_error(const Exact& exact) const {
    double sum = 0;
    for (std::size_t z = 0; z < grid.zones.size(); ++z) sum += std::pow(pressure(z) - exact(z), 2);
    return std::sqrt(sum / static_cast<double>(grid.zones.size()));
  }
};

// Halves the zones' size twice, and returns the last error.
double expect_second_order(const std::function<double(std::uint32_t)>& error, std::uint32_t zones) {
  const double coarse = error(zones), middle = error(2 * zones), fine = error(4 * zones);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.1);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.1);
  return fine;
}

class Consolidation : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Consolidation, testing::ValuesIn(kKinds));

// Of the load the water of the column bears the share B at first (Skempton 1954).
const double kColumnPressure = kLoad * kWater / (kWater + kOedometric);

// Terzaghi 1925: the sum of waves (m + 1/2) pi y/H that die out, of what each gives.
double terzaghi(double factor, const std::function<double(double)>& of_wave) {
  double sum = 0;
  for (int m = 0; m < 60; ++m) {
    const double wave = (2 * m + 1) * pi / 2;
    sum += 2 / wave * of_wave(wave) * std::exp(-wave * wave * factor);
  }
  return kColumnPressure * sum;
}

double terzaghi_pressure(double y, double factor) {
  return terzaghi(factor, [y](double wave) { return std::sin(wave * (1 - y / kSize)); });
}

// The stress -q = (K + 4/3 G) e - p is the same everywhere; the strain e follows, and its mean.
double terzaghi_settlement(double factor) {
  return (kLoad - terzaghi(factor, [](double wave) { return 1 / wave; })) * kSize / kOedometric;
}

TEST_P(Consolidation, OfAColumnIsTerzaghis) {
  Sample sample(GetParam(), loaded_column(40));
  for (const double factor : {0.05, 0.1, 0.2, 0.5}) {
    sample.go_on_to(factor);
    const double now = sample.time_factor(), settlement = terzaghi_settlement(now);
    const double error =
        sample.worst_error([&](std::size_t z) { return terzaghi_pressure(sample.y(z), now); });
    EXPECT_LT(error, 0.01 * kColumnPressure) << factor;
    EXPECT_NEAR(sample.settlement(), settlement, 0.01 * settlement) << factor;
  }
}

TEST_P(Consolidation, OfAColumnHasErrorsOfTheSecondOrder) {
  const double fine = expect_second_order(
      [](std::uint32_t zones) {
        Sample sample(GetParam(), loaded_column(zones));
        sample.go_on_to(0.2);
        return sample.mean_error(
            [&](std::size_t z) { return terzaghi_pressure(sample.y(z), sample.time_factor()); });
      },
      8);
  EXPECT_LT(fine, 0.001 * kColumnPressure);
}

// With a hundred-millionth of the mobility, by which the highest zone loses 4e-6 of its pressure. As much is
// left of vibrations, since periods of the grid do not quite divide the ramp.
TEST_P(Consolidation, WithoutFlowKeepsThePressure) {
  Sample sample(GetParam(), loaded_column(20), 1e-8 * kMobility);
  for (const double factor : {0.05, 0.1, 0.2, 0.5}) {
    sample.go_on_to(factor);
    const double settlement = kLoad * kSize / (kWater + kOedometric);
    EXPECT_LT(sample.worst_error([](std::size_t) { return kColumnPressure; }), 1e-5 * kColumnPressure)
        << factor;
    EXPECT_NEAR(sample.settlement(), settlement, 1e-5 * settlement) << factor;
  }
}

// de Leeuw 1965, the plane companion of Cryer's sphere: a disc under the radial stress -q at its rim. With E
// = K + 4/3 G equilibrium, E de/dr = dp/dr, leaves E e = p + f(t). Storage, (dp/dt)/M + de/dt = k div grad p,
// is then c div grad p = dp/dt + (df/dt)/(E S), S = 1/M + 1/E and c = k/S: diffusion with a source. The
// Laplace transform that is finite in the middle and 0 at the rim is
//   p = A (I0(z r/a) - I0(z)),   f = E S A I0(z),   z^2 = s a^2/c.
// The rim's displacement is u/a = 1/a^2 times the integral of e r dr, A/E (I1(z)/z + E/(2M) I0(z)); and its
// stress E e - p - 2 G u/a = f - 2 G u/a, which is -q/s, gives A. `s` is that of time factors:
double de_leeuw_transform(double s, double r) {
  const double z = std::sqrt(s), rim = std::cyl_bessel_i(0, z);
  return kLoad / s * (1 - std::cyl_bessel_i(0, z * r / kSize) / rim) /
         (1 + (kOedometric - kShear) / kWater -
          2 * kShear / kOedometric * std::cyl_bessel_i(1, z) / (z * rim));
}

// Stehfest's inversion (1970, Commun. ACM 13), here within 1e-4 of the load.
double de_leeuw_pressure(double r, double factor) {
  constexpr int kHalf = 7;
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  double sum = 0;
  for (int k = 1; k <= 2 * kHalf; ++k) {
    double weight = 0;
    for (int j = (k + 1) / 2; j <= std::min(k, kHalf); ++j)
      weight +=
          std::pow(j, kHalf) * factorial(2 * j) /
          (factorial(kHalf - j) * factorial(j) * factorial(j - 1) * factorial(k - j) * factorial(2 * j - k));
    sum += ((k + kHalf) % 2 == 0 ? weight : -weight) * de_leeuw_transform(k * std::log(2) / factor, r);
  }
  return std::log(2) / factor * sum;
}

const double kDiscPressure = kLoad * kWater / (kWater + kOedometric - kShear);  // before any flow

// As the rim consolidates and shrinks it presses on the middle (Mandel 1953, Cryer 1963).
TEST_P(Consolidation, OfADiscFirstRaisesThePressureInItsMiddle) {
  Sample sample(GetParam(), loaded_disc(8));
  double highest = 0, exact_highest = 0, worst = 0;
  for (int n = 2; n <= 50; ++n) {
    sample.go_on_to(0.01 * n);
    const double exact = de_leeuw_pressure(sample.radius(0), sample.time_factor());
    worst = std::max(worst, std::abs(sample.pressure(0) - exact));
    highest = std::max(highest, sample.pressure(0));
    exact_highest = std::max(exact_highest, exact);
  }
  EXPECT_GT(exact_highest, 1.15 * kDiscPressure);
  EXPECT_NEAR(highest, exact_highest, 0.01 * kDiscPressure);
  EXPECT_LT(worst, 0.01 * kDiscPressure);
}

TEST_P(Consolidation, OfADiscHasErrorsOfTheSecondOrder) {
  const double fine = expect_second_order(
      [](std::uint32_t zones) {
        Sample sample(GetParam(), loaded_disc(zones));
        sample.go_on_to(0.1);
        return sample.mean_error(
            [&](std::size_t z) { return de_leeuw_pressure(sample.radius(z), sample.time_factor()); });
      },
      4);
  EXPECT_LT(fine, 0.001 * kDiscPressure);
}

// Forces sin(k y) that stay give the water the pressure cos(k y). It falls in each step, by exp(-c k^2 t):
// Biot's slow wave is overdamped.
TEST_P(Consolidation, OfAPatternDoesNotOscillate) {
  constexpr double kWave = 4 * pi;  // k H
  Body body = tight_column(64);
  body.add_roller(Axis::kY, kSize);
  const double share = kSize / 64 * kSize / 64 / 2;  // of the area, a point's
  for (std::uint32_t i = 0; i < body.grid.x.size(); ++i)
    body.push(i, 0, -kLoad * kWave / kSize * std::sin(kWave * body.grid.y[i] / kSize) * share);
  Sample sample(GetParam(), body);
  sample.go_on_to(kRamp / 2);
  const double first = sample.pressure(0), start = sample.time_factor();
  EXPECT_GT(first, 0.3 * kColumnPressure) << "what is left when all of the load acts";
  double worst = 0;
  while (sample.time_factor() < 5 * kRamp) {
    const double before = sample.pressure(0);
    sample.step();
    const double now = sample.time_factor(), fallen = std::exp(-kWave * kWave * (now - start));
    ASSERT_TRUE(0 < sample.pressure(0) && sample.pressure(0) < before) << now;
    worst = std::max(worst, sample.worst_error([&](std::size_t z) {
      return first * fallen * std::cos(kWave * sample.y(z) / kSize) / std::cos(kWave * sample.y(0) / kSize);
    }));
  }
  EXPECT_LT(worst, 0.01 * first);
}

// u = U sin(k y) and p = P cos(k y) obey (Biot 1956, without the inertia of the flow)
//   density U'' = -(K + 4/3 G) k^2 U + k P,   P' = -M (k U' + mobility k^2 P).
class StandingWave {
 public:
  static constexpr double k = pi / kSize;
  explicit StandingWave(double mobility) {
    Eigen::Matrix3d matrix;
    matrix << 0, 1, 0, -kOedometric * k * k / kSkeleton.density, 0, k / kSkeleton.density, 0, -kWater * k,
        -kWater * mobility * k * k;
    const Eigen::EigenSolver<Eigen::Matrix3d> solver(matrix);
    rates_ = solver.eigenvalues();
    shapes_ = solver.eigenvectors();
    start_ = shapes_.inverse() * Eigen::Vector3cd(0, 1, 0);
  }
  // U, U' and P after a velocity of 1 m/s at time 0.
  Eigen::Vector3d at(double t) const {
    return (shapes_ * ((rates_ * t).array().exp() * start_.array()).matrix()).real();
  }

 private:
  Eigen::Matrix3cd shapes_;
  Eigen::Vector3cd rates_, start_;
};

// The larger of the largest errors of displacement and pressure in two periods without flow, each over its
// largest value.
double wave_error(ZoneKind kind, std::uint32_t zones, double mobility) {
  Body body = tight_column(zones);
  body.add_roller(Axis::kY, kSize);
  Sample sample(kind, body, mobility);
  const StandingWave wave(mobility);
  sample.step();
  const double velocity = wave.at(sample.dt / 2)[1];
  for (std::uint32_t i = 0; i < sample.grid.x.size(); ++i)
    sample.continuum.push(i, 0,
                          sample.continuum.masses()[i] * velocity * std::sin(wave.k * sample.grid.y[i]));
  double error_u = 0, error_p = 0, largest_u = 0, largest_p = 0;
  while (sample.time() < 4 * kSize / kSpeed) {
    sample.step();
    const double u = wave.at(sample.time())[0];
    const double p = wave.at(sample.time())[2] * std::cos(wave.k * sample.y(0));
    error_u = std::max(error_u, std::abs(sample.continuum.uy()[zones] - u));  // of the middle
    error_p = std::max(error_p, std::abs(sample.pressure(0) - p));
    largest_u = std::max(largest_u, std::abs(u));
    largest_p = std::max(largest_p, std::abs(p));
  }
  return std::max(error_u / largest_u, error_p / largest_p);
}

// Flow that is slow beside the wave, as fast, and so fast that the water hardly resists. Steps are the
// flow's, in proportion to the square of the zones' size.
TEST_P(Consolidation, DampsWavesAsBiotTells) {
  for (const double flow : {0.5, 2.0, 8.0}) {
    const double mobility = flow * kSpeed / (kWater * StandingWave::k);
    const double fine =
        expect_second_order([&](std::uint32_t zones) { return wave_error(GetParam(), zones, mobility); }, 8);
    EXPECT_LT(fine, 0.01) << flow;
  }
}

}  // namespace
}  // namespace adit::fdm::test::consolidation_test
