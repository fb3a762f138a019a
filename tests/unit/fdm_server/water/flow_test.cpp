// Requirements on the flow of water through the pores.
#include "fdm_server/water/flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "fdm_server/grid/edges.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::flow_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMobility = 2e-8, kStiffness = 5e9;  // [m^2/(Pa s)], [Pa]
constexpr double kDiffusivity = kMobility * kStiffness;

using Place = std::array<double, 2>;
using Field = std::function<double(const Place&)>;

std::vector<double> on_zones(const Grid& grid, const Field& field) {
  std::vector<double> values;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) values.push_back(field(centroid(corners(grid, z))));
  return values;
}

// The edges whose middles are at these places.
std::vector<PointPair> edges_at(const Grid& grid, const std::function<bool(const Place&)>& at) {
  std::vector<PointPair> found;
  for (const Edge& edge : number_edges(grid).list) {
    const auto a = static_cast<std::uint32_t>(edge.from), b = static_cast<std::uint32_t>(edge.to);
    if (at({(grid.x[a] + grid.x[b]) / 2, (grid.y[a] + grid.y[b]) / 2})) found.push_back({a, b});
  }
  return found;
}

Faces uniform_faces(const Grid& grid, const std::vector<PointPair>& open = {},
                    const std::vector<PointPair>& sealed = {}) {
  const std::vector<double> mobility(grid.zones.size(), kMobility);
  return make_faces(grid, {mobility, mobility}, open, sealed);
}

Flow uniform_flow(const Grid& grid, const std::vector<PointPair>& open = {},
                  const std::vector<PointPair>& sealed = {}) {
  return {grid, uniform_faces(grid, open, sealed), std::vector<double>(grid.zones.size(), kStiffness)};
}

// Steps as the mechanics takes them: u += M zeta.
void advance(Flow& flow, double dt, int steps, std::vector<double>& u, std::size_t threads = 1) {
  protocol::Team team(threads);
  std::vector<double> inflow(u.size(), 0.0);
  for (int n = 0; n < steps; ++n) {
    flow.step(team, dt, u, inflow);
    for (std::size_t z = 0; z < u.size(); ++z) u[z] += kStiffness * inflow[z];
  }
}

double sum_over_area(const Grid& grid, std::span<const double> values) {
  double sum = 0;
  for (std::size_t z = 0; z < values.size(); ++z) sum += area(corners(grid, z)) * values[z];
  return sum;
}

double energy(const Grid& grid, std::vector<double> u) {
  for (double& value : u) value *= value / (2 * kStiffness);
  return sum_over_area(grid, u);
}

double mean_error(const std::vector<double>& u, const std::vector<double>& exact) {
  double sum = 0;
  for (std::size_t z = 0; z < u.size(); ++z) sum += (u[z] - exact[z]) * (u[z] - exact[z]);
  return std::sqrt(sum / static_cast<double>(u.size()));
}

// A distorted grid of mobilities without any pattern, with dry zones, a sealed line and an open side.
struct Patchwork {
  Grid grid = distorted_grid({0, 75, 0, 50, 150, 100});
  std::vector<double> mobility_x, mobility_y, stiffness, u;

  Patchwork() {
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      const auto n = static_cast<double>(z);
      const double wet = z % 17 == 3 ? 0 : kMobility;
      mobility_x.push_back(wet * (1.2 + std::sin(3.7 * n)));
      mobility_y.push_back(wet * (1.2 + std::sin(5.1 * n)));
      stiffness.push_back(kStiffness * (1 + 0.5 * std::sin(n)));
      u.push_back(z % 17 == 3 ? NAN : 1e5 * std::sin(7.3 * n));
    }
  }
  Flow flow() const {
    const auto open = edges_at(grid, [](const Place& at) { return at[1] == 50; });
    const auto sealed = edges_at(grid, [](const Place& at) { return std::abs(at[0] - 20) < 0.2; });
    return {grid, make_faces(grid, {mobility_x, mobility_y}, open, sealed), stiffness};
  }
};

struct Outcome {
  std::vector<double> inflow;
  double left, dissipated;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome(const Patchwork& ground, std::size_t threads, double steps) {
  Flow flow = ground.flow();
  protocol::Team team(threads);
  Outcome result{std::vector<double>(ground.u.size(), 0.0), 0, 0};
  flow.step(team, steps * flow.critical_step(), ground.u, result.inflow);
  result.left = flow.left();
  result.dissipated = flow.dissipated();
  return result;
}

constexpr double kExplicit = 1, kImplicit = 30;  // critical steps

// No water comes or goes but through open sides, whatever the shapes and mobilities.
TEST(Flow, ConservesWater) {
  const Patchwork ground;
  for (const double steps : {kExplicit, kImplicit}) {
    const Outcome result = outcome(ground, 1, steps);
    std::vector<double> magnitudes = result.inflow;
    for (double& value : magnitudes) value = std::abs(value);
    const double moved = sum_over_area(ground.grid, magnitudes);
    EXPECT_GT(std::abs(result.left), 1e-5 * moved);
    EXPECT_NEAR(sum_over_area(ground.grid, result.inflow) + result.left, 0, 1e-14 * moved);
  }
}

// Inflow, outflow and energy do not differ by a bit, whatever the number of threads.
TEST(Flow, IsTheSameForAnyNumberOfThreads) {
  const Patchwork ground;
  for (const double steps : {kExplicit, kImplicit}) {
    const Outcome one = outcome(ground, 1, steps);
    EXPECT_GT(one.dissipated, 0);
    for (const std::size_t threads : {2u, 3u}) EXPECT_EQ(outcome(ground, threads, steps), one) << threads;
  }
}

// Pressure that is linear in each of two grounds, with the same flow across their common side, moves water
// through each zone and leaves none there, though zones are distorted and mobilities differ by direction.
// Inside: a gradient of zones at the rim knows that nothing flows through it.
TEST(Flow, OfLinearPressureIsExact) {
  Grid grid = distorted_grid({0, 6, 0, 5, 12, 10});
  for (std::size_t i = 6; i < grid.x.size(); i += 13) grid.x[i] = 3;
  const auto right = [](const Place& at) { return at[0] > 3; };
  const auto mobility_x = on_zones(grid, [&](const Place& at) { return (right(at) ? 5 : 1) * kMobility; });
  const auto mobility_y = on_zones(grid, [&](const Place& at) { return (right(at) ? 2 : 4) * kMobility; });
  const auto u = on_zones(
      grid, [&](const Place& at) { return 1e5 * (1 - 3 * at[1] + (at[0] - 3) * (right(at) ? 1 : 5)); });
  Flow flow(grid, make_faces(grid, {mobility_x, mobility_y}, {}, {}),
            std::vector<double>(grid.zones.size(), kStiffness));
  protocol::Team team;
  std::vector<double> inflow(u.size());
  const double dt = flow.critical_step();
  flow.step(team, dt, u, inflow);
  const double through = dt * 5 * kMobility * 1e5 / 0.5;  // over a side, per area
  for (std::size_t z = 0; z < u.size(); ++z) {
    const std::size_t i = z % 12, j = z / 12;
    if (i > 1 && i < 10 && j > 1 && j < 8) {
      EXPECT_NEAR(inflow[z], 0, 1e-13 * through) << z;
    }
  }
}

// Terzaghi 1925: consolidation of a layer drained at its top, u = 1 at first.
double terzaghi(double depth, double thickness, double time) {
  double u = 0;
  for (int m = 0; m < 60; ++m) {
    const double wave = (2 * m + 1) * kPi / 2;
    u += 2 / wave * std::sin(wave * depth / thickness) *
         std::exp(-wave * wave * kDiffusivity * time / (thickness * thickness));
  }
  return u;
}

constexpr double kThickness = 10, kTime = 0.2;  // [m], time factor c t/H^2

double terzaghi_error(std::uint32_t zones, double wanted_step) {
  const Grid grid = make_grid({0, 1, 0, kThickness, 1, zones});
  Flow flow = uniform_flow(grid, edges_at(grid, [](const Place& at) { return at[1] == kThickness; }));
  const double time = kTime * kThickness * kThickness / kDiffusivity;
  const int steps =
      static_cast<int>(std::ceil(time / (wanted_step > 0 ? wanted_step : flow.critical_step())));
  std::vector<double> u(zones, 1.0);
  advance(flow, time / steps, steps, u);
  return mean_error(
      u, on_zones(grid, [&](const Place& at) { return terzaghi(kThickness - at[1], kThickness, time); }));
}

// The error falls as the square of the zones' size with explicit steps, which shorten with it likewise.
TEST(Flow, ConsolidatesALayer) {
  const double coarse = terzaghi_error(10, 0), middle = terzaghi_error(20, 0), fine = terzaghi_error(40, 0);
  EXPECT_LT(fine, 2e-4);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.1);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.1);
}

// Implicit steps come to the same, with an error of the first order of the step.
TEST(Flow, ConsolidatesALayerInLongSteps) {
  const double long_step = kThickness * kThickness / kDiffusivity / 100;
  const double coarse = terzaghi_error(80, long_step), fine = terzaghi_error(80, long_step / 2);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.1);
}

// Error of the mode cos(pi x/a) cos(pi y/b) in a tight box whose mobility along x is four times that along y,
// when it has halved.
double box_error(std::uint32_t zones) {
  constexpr double kA = 3, kB = 2, kMobilityX = 4 * kMobility;
  const Grid grid = distorted_grid({0, kA, 0, kB, 3 * zones, 2 * zones});
  const std::vector<double> mobility_x(grid.zones.size(), kMobilityX),
      mobility_y(grid.zones.size(), kMobility);
  Flow flow(grid, make_faces(grid, {mobility_x, mobility_y}, {}, {}),
            std::vector<double>(grid.zones.size(), kStiffness));
  const double rate = kStiffness * kPi * kPi * (kMobilityX / (kA * kA) + kMobility / (kB * kB));
  const double time = std::log(2) / rate;
  const auto mode = [&](double factor) {
    return on_zones(grid, [=](const Place& at) {
      return factor * std::cos(kPi * at[0] / kA) * std::cos(kPi * at[1] / kB);
    });
  };
  const int steps = static_cast<int>(std::ceil(time / flow.critical_step()));
  std::vector<double> u = mode(1);
  advance(flow, time / steps, steps, u);
  return mean_error(u, mode(0.5));
}

// Flow that is easier along x than along y is of the second order, on zones whose shapes do not
// become better, so that the order scatters.
TEST(Flow, ByDirectionIsOfTheSecondOrder) {
  const double coarse = box_error(4), middle = box_error(8), fine = box_error(16);
  EXPECT_LT(fine, 1e-3);
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.8);
}

// A full ring whose radial lines turn by `twist` from the inner to the outer radius.
constexpr double kInner = 1, kOuter = 3;
Grid ring(std::uint32_t across, double twist) {
  const std::uint32_t around = 6 * across;
  Grid grid;
  for (std::uint32_t i = 0; i <= across; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const double s = static_cast<double>(i) / across, r = kInner + s * (kOuter - kInner);
      const double angle = 2 * kPi * j / around + twist * s;
      grid.x.push_back(r * std::cos(angle));
      grid.y.push_back(r * std::sin(angle));
    }
  for (std::uint32_t i = 0; i < across; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const auto at = [&](std::uint32_t row, std::uint32_t k) {
        return static_cast<std::int32_t>(row * around + k % around);
      };
      grid.zones.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return grid;
}

// Error of the slowest mode of radial flow to an open tunnel, in a ring that is tight outside, when it has
// halved: u = J0(b r) Y0(b r_i) - Y0(b r) J0(b r_i), which decays by exp(-c b^2 t).
double ring_error(std::uint32_t across, double twist) {
  const auto slope = [](double b) {
    return std::cyl_bessel_j(1, b * kOuter) * std::cyl_neumann(0, b * kInner) -
           std::cyl_neumann(1, b * kOuter) * std::cyl_bessel_j(0, b * kInner);
  };
  double low = 0.4, high = 1;  // of b
  for (int n = 0; n < 60; ++n) (slope((low + high) / 2) * slope(low) > 0 ? low : high) = (low + high) / 2;
  const Grid grid = ring(across, twist);
  Flow flow =
      uniform_flow(grid, edges_at(grid, [](const Place& at) { return std::hypot(at[0], at[1]) < 1.0001; }));
  const double time = std::log(2) / (kDiffusivity * low * low);
  const auto mode = [&](double factor) {
    return on_zones(grid, [=](const Place& at) {
      const double r = std::hypot(at[0], at[1]);
      return factor * (std::cyl_bessel_j(0, low * r) * std::cyl_neumann(0, low * kInner) -
                       std::cyl_neumann(0, low * r) * std::cyl_bessel_j(0, low * kInner));
    });
  };
  const int steps = static_cast<int>(std::ceil(time / flow.critical_step()));
  std::vector<double> u = mode(1);
  advance(flow, time / steps, steps, u);
  return mean_error(u, mode(0.5));
}

// Radial flow is of the second order, on radial lines and on lines that lie askew by up to 45 degrees.
TEST(Flow, ToATunnelIsOfTheSecondOrder) {
  for (const double twist : {0.0, 0.7}) {
    const double coarse = ring_error(6, twist), middle = ring_error(12, twist), fine = ring_error(24, twist);
    EXPECT_GT(std::log2(coarse / middle), 1.9) << twist;
    EXPECT_GT(std::log2(middle / fine), 1.9) << twist;
  }
}

// Nothing passes a sealed line: both parts come to rest at their own means. Without it they share one.
TEST(Flow, StopsAtASealedLine) {
  const Grid grid = distorted_grid({0, 6, 0, 5, 12, 10});
  const auto line = edges_at(grid, [](const Place& at) { return std::abs(at[0] - 3) < 0.12; });
  for (const bool sealed : {false, true}) {
    std::vector<double> u(grid.zones.size()), left(u.size(), 0.0), ones(u.size(), 1.0);
    std::vector<bool> is_left(u.size());
    for (std::size_t z = 0; z < u.size(); ++z) {
      is_left[z] = z % 12 < 6;
      u[z] = (is_left[z] ? 3e5 : 1e5) + 1e5 * std::sin(7.3 * static_cast<double>(z));
    }
    const auto mean = [&](bool of_left) {
      std::vector<double> weighted(u.size()), share(u.size());
      for (std::size_t z = 0; z < u.size(); ++z) {
        share[z] = is_left[z] == of_left || !sealed;
        weighted[z] = share[z] * u[z];
      }
      return sum_over_area(grid, weighted) / sum_over_area(grid, share);
    };
    const double of_left = mean(true), of_right = mean(false);
    Flow flow = uniform_flow(grid, {}, sealed ? line : std::vector<PointPair>{});
    advance(flow, 1000 * flow.critical_step(), 60, u);
    for (std::size_t z = 0; z < u.size(); ++z) EXPECT_NEAR(u[z], is_left[z] ? of_left : of_right, 1e-5) << z;
  }
}

// A step of a hundred critical ones leaves no pressure outside the range of those before, nor a ripple.
TEST(Flow, OfLongStepsIsMonotone) {
  const Grid grid = make_grid({0, 1, 0, 10, 1, 50});
  Flow flow = uniform_flow(grid, edges_at(grid, [](const Place& at) { return at[1] == 10; }));
  std::vector<double> u = on_zones(grid, [](const Place& at) { return at[1] < 5 ? 1e5 : 0; });
  for (int n = 0; n < 5; ++n) {
    advance(flow, 100 * flow.critical_step(), 1, u);
    EXPECT_LE(u.front(), 1e5);
    EXPECT_GE(u.back(), 0);
    for (std::size_t z = 1; z < u.size(); ++z) EXPECT_LE(u[z], u[z - 1]) << n << " " << z;
  }
}

// Steps may change their length: what comes next is what a flow does that begins there.
TEST(Flow, OfStepsThatChangeForgetsNone) {
  const Patchwork ground;
  Flow flow = ground.flow();
  protocol::Team team;
  std::vector<double> inflow(ground.u.size(), 0.0);
  for (const double steps : {kImplicit, kExplicit, 2 * kImplicit, kImplicit}) {
    flow.step(team, steps * flow.critical_step(), ground.u, inflow);
    EXPECT_EQ(inflow, outcome(ground, 1, steps).inflow) << steps;
  }
}

// Energy falls in each step on distorted zones, too, however long it is; what falls is what was dissipated.
TEST(Flow, DissipatesTheEnergyThatIsLost) {
  const Grid grid = distorted_grid({0, 6, 0, 5, 12, 10});
  for (const double steps : {1.0, 2.0, 100.0, 1e4}) {
    Flow flow = uniform_flow(grid, edges_at(grid, [](const Place& at) { return at[1] == 5; }));
    std::vector<double> u(grid.zones.size());
    for (std::size_t z = 0; z < u.size(); ++z) u[z] = 1e5 * std::sin(7.3 * static_cast<double>(z));
    const double start = energy(grid, u);
    for (int n = 0; n < 5; ++n) {
      const double before = energy(grid, u), dissipated = flow.dissipated();
      advance(flow, steps * flow.critical_step(), 1, u);
      EXPECT_GT(flow.dissipated(), dissipated) << steps << " " << n;
      EXPECT_NEAR(before - energy(grid, u), flow.dissipated() - dissipated, 1e-14 * start);
    }
  }
}

// A uniform gradient g dissipates the power k g^2 in each square metre: between the centres of a bar's zones.
TEST(Flow, DissipatesThePowerOfDarcy) {
  const Grid grid = make_grid({0, 10, 0, 2, 20, 1});
  Flow flow = uniform_flow(grid);
  constexpr double kGradient = 2e4;
  std::vector<double> u = on_zones(grid, [](const Place& at) { return kGradient * at[0]; });
  const double dt = 1e-9 * flow.critical_step();
  advance(flow, dt, 1, u);
  EXPECT_NEAR(flow.dissipated() / dt / (kMobility * kGradient * kGradient * 9.5 * 2), 1, 1e-8);
}

// -du/dt of the whole grid.
Eigen::MatrixXd assembled_flow(const Grid& grid, Flow& flow) {
  protocol::Team team;
  const auto n = static_cast<Eigen::Index>(grid.zones.size());
  Eigen::MatrixXd result(n, n);
  const double dt = flow.critical_step();
  for (Eigen::Index column = 0; column < n; ++column) {
    std::vector<double> u(grid.zones.size(), 0.0), inflow(u.size());
    u[static_cast<std::size_t>(column)] = 1;
    flow.step(team, dt, u, inflow);
    for (Eigen::Index row = 0; row < n; ++row)
      result(row, column) = -kStiffness / dt * inflow[static_cast<std::size_t>(row)];
  }
  return result;
}

// The critical step is on the safe side of the exact limit, and near it; no pattern grows in such steps.
TEST(Flow, CriticalStepIsABound) {
  for (const auto& grid :
       {make_grid({0, 5, 0, 2, 10, 4}), distorted_grid({0, 5, 0, 2, 10, 4}), ring(3, 0.7)}) {
    Flow flow =
        uniform_flow(grid, edges_at(grid, [](const Place& at) { return std::hypot(at[0], at[1]) < 1; }));
    const Eigen::VectorXcd values = assembled_flow(grid, flow).eigenvalues();
    const double bound = flow.critical_step(), exact = 1 / values.cwiseAbs().maxCoeff();
    EXPECT_GE(bound, 0.5 * exact);
    EXPECT_LE((1.0 - bound * values.array()).abs().maxCoeff(), 1 + 1e-12);
  }
}

// The free field's columns, whose zones have one point below and one above, flow as a strip of the ground
// does.
TEST(Flow, InAColumnIsThatOfAStrip) {
  constexpr std::uint32_t kZones = 8;
  const Grid strip = make_grid({0, 1, 0, 4, 1, kZones});
  Grid column;
  for (std::uint32_t k = 0; k <= kZones; ++k) {
    column.x.push_back(0);
    column.y.push_back(0.5 * k);
  }
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(kZones); ++k) {
    column.zones.push_back({k, k, k + 1, k + 1});
    column.own_corners.push_back({{0, 1, 1, 0}, {0.5 * k, 0.5 * k, 0.5 * (k + 1), 0.5 * (k + 1)}});
  }
  Flow in_strip = uniform_flow(strip, edges_at(strip, [](const Place& at) { return at[1] == 4; }));
  Flow in_column = uniform_flow(column, {{kZones, kZones}});
  EXPECT_EQ(in_column.critical_step(), in_strip.critical_step());
  std::vector<double> a = on_zones(strip, [](const Place&at) { return 1e5 * std::exp(at[1]); }), b = a;
  advance(in_strip, in_strip.critical_step(), 10, a);
  advance(in_column, in_column.critical_step(), 10, b);
  EXPECT_GT(in_strip.left(), 0);
  EXPECT_EQ(in_column.left(), in_strip.left());
  EXPECT_EQ(a, b);
}

// A ground without passages has no limit, and its step does nothing.
TEST(Flow, OfTightGroundIsNone) {
  const Grid grid = make_grid({0, 2, 0, 1, 2, 1});
  const std::vector<double> none(2, 0.0);
  Flow flow(grid, make_faces(grid, {none, none}, {}, {}), none);
  EXPECT_TRUE(std::isinf(flow.critical_step()));
  std::vector<double> u = {1e5, 0};
  advance(flow, 1, 1, u);
  EXPECT_EQ(u, std::vector<double>({1e5, 0}));
}

}  // namespace
}  // namespace adit::fdm::test::flow_test
