// What water costs in the ground: zone-steps per second of one thread and of two in a block of zones within
// their strength, through which shear waves run, one JSON object a line. One block after the other, for side
// by side they would not fit into the cache in which each of them does.
//
//   water_bench [SIDE]    zones along a side, else 200
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/bench/measure.hpp"

namespace {

using namespace adit;
using namespace adit::fdm;

constexpr double kPorosity = 0.4, kWater = 2.2e9, kMobility = 1e-9;

struct Kind {
  const char* name;
  bool wet, compacts, flows;
};
constexpr std::array kKinds{
    Kind{"dry", false, false, false}, Kind{"wet", true, false, false}, Kind{"compaction", true, true, false},
    Kind{"compaction and flow", true, true, true}, Kind{"wet and flow", true, false, true}};

Material material_of(const Kind& kind) {
  Material material{2000, 60e6, 0.3};
  material.mohr_coulomb = MohrCoulomb({1e9, 0.5, 0, std::numeric_limits<double>::infinity()});
  if (kind.wet) material.pores = Pores{kWater / kPorosity, kMobility, kMobility};
  if (kind.compacts) material.compaction = compaction(0.3);
  return material;
}

class WetBlock {
 public:
  WetBlock(const Kind& kind, std::uint32_t side, std::size_t threads)
      : zones_(static_cast<double>(side) * side), threads_(threads) {
    const Grid grid = make_grid({0, 1.0 * side, 0, 1.0 * side, side, side});
    const std::vector<double> ones(grid.zones.size(), 1.0);
    const Ground ground{{material_of(kind)}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
    continuum_ = std::make_unique<Continuum>(ZoneSet(ZoneKind::kAssumedStrain, grid, ground, ones),
                                             lumped_masses(grid, ones, 2000), std::vector<Load>{},
                                             std::vector<PrescribedMotion>{}, threads);
    dt_ = 0.5 * critical_step(ZoneKind::kAssumedStrain, grid, ground);
    if (kind.flows) {
      const std::vector<double> mobility(grid.zones.size(), kMobility),
          stiffness(grid.zones.size(), kWater / kPorosity);
      continuum_->set_flow(Flow(grid, make_faces(grid, {mobility, mobility}, {}, {}), stiffness));
    }
    for (std::size_t z = 0; z < grid.zones.size(); ++z) continuum_->zones().set_stress(z, {-1e5, -1e5, 0});
    continuum_->zones().begin_time();
    continuum_->step({0, dt_});
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      continuum_->vx()[i] = 1e-2 * std::sin(0.1 * grid.y[i]);
      continuum_->vy()[i] = 1e-2 * std::cos(0.1 * grid.x[i]);
    }
  }
  // Of a zone in a step [s].
  double seconds_a_step(int steps) {
    return bench::seconds(threads_,
                          [&] {
                            for (int i = 0; i < steps; ++i) continuum_->step({next_++, dt_});
                          }) /
           steps;
  }
  double zones() const { return zones_; }

 private:
  double zones_;
  std::size_t threads_;
  std::unique_ptr<Continuum> continuum_;
  double dt_;
  std::uint64_t next_ = 1;
};

}  // namespace

int main(int argc, char** argv) {
  const auto side = static_cast<std::uint32_t>(argc > 1 ? std::atoi(argv[1]) : 200);
  for (const std::size_t threads : {1, 2}) {
    double dry = 0;  // [s]
    for (const Kind& kind : kKinds) {
      WetBlock block(kind, side, threads);
      const auto [seconds] = bench::least([&](int steps) { return block.seconds_a_step(steps); });
      if (!kind.wet) dry = seconds;
      std::printf(
          "{\"ground\": \"%s\", \"zones\": %.0f, \"threads\": %zu, \"zone_steps_per_s\": %.4g, "
          "\"over_dry\": %.3f}\n",
          kind.name, block.zones(), threads, block.zones() / seconds, seconds / dry);
      std::fflush(stdout);
    }
  }
  return 0;
}
