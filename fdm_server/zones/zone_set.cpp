#include "fdm_server/zones/zone_set.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "fdm_server/zones/batch/zone_kernels.hpp"
#include "fdm_server/zones/elastic/elastic_zones.hpp"
#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"
#include "protocol/kernels/sums.hpp"

namespace adit::fdm {
namespace {

std::unique_ptr<ZoneKernel> make_kernel(ZoneKind kind, const Grid& grid, const Ground& ground,
                                        const Material& material, std::span<const double> weights,
                                        std::span<const double> strengths, PoreWater* water) {
  if (ground.is_elastic(material) && !water)
    return std::make_unique<ElasticZones>(kind, grid, ground.plane_law(material), weights,
                                          ground.plane_stress ? 0 : material.poisson, material.fracture,
                                          strengths);
  auto kernel =
      std::make_unique<NonlinearZones>(kind, grid, material, weights, ground.large_strain, strengths);
  kernel->hold(water);
  return kernel;
}

std::vector<std::uint32_t> numbers_of(const Ground& ground, std::size_t material,
                                      const std::vector<bool>& chosen) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t z = 0; z < chosen.size(); ++z)
    if (chosen[z] && ground.of_zone[z] == material) numbers.push_back(static_cast<std::uint32_t>(z));
  return numbers;
}

Stress times(double factor, const Stress& s) {
  return {factor * s.xx, factor * s.yy, factor * s.xy};
}

// With the pressure of the water instead of the effective stress, or the other way round.
Stress plus(const Stress& s, double pressure) {
  return {s.xx + pressure, s.yy + pressure, s.xy};
}

BorneStress times(double factor, const BorneStress& b) {
  return {times(factor, b.mean), factor * b.across, factor * b.pattern_x, factor * b.pattern_y};
}

Grid some_zones(const Grid& grid, std::span<const std::uint32_t> numbers) {
  Grid some{grid.x, grid.y, {}};
  for (const auto z : numbers) {
    some.zones.push_back(grid.zones[z]);
    if (z >= grid.own_zones()) some.own_corners.push_back(grid.own_corners[z - grid.own_zones()]);
  }
  return some;
}

}  // namespace

Grid zones_of_material(const Grid& grid, const Ground& ground, std::size_t material) {
  return some_zones(grid, numbers_of(ground, material, std::vector<bool>(grid.zones.size(), true)));
}

ZoneSet::ZoneSet(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const double> weights)
    : places_(grid.zones.size()) {
  add_parts(kind, grid, ground, weights, std::vector<bool>(grid.zones.size(), true));
  collect_runs();
  collect_pieces();
}

ZoneSet::ZoneSet(ZoneKind kind, const Grid& grid, const PlaneLaw& law, std::span<const double> weights)
    : places_(grid.zones.size()) {
  std::vector<std::uint32_t> numbers(grid.zones.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  add_part({std::make_unique<ElasticZones>(kind, grid, law, weights), std::move(numbers), {}});
  collect_runs();
  collect_pieces();
}

void ZoneSet::add_parts(ZoneKind kind, const Grid& grid, const Ground& ground,
                        std::span<const double> weights, const std::vector<bool>& chosen) {
  for (std::size_t m = 0; m < ground.materials.size(); ++m) {
    std::vector<std::uint32_t> numbers = numbers_of(ground, m, chosen);
    if (numbers.empty()) continue;
    const Material& material = ground.materials[m];
    const bool scattered = ground.scattered(), strong = scattered && material.states_strength();
    std::vector<double> own_weights, stiffness, strengths;
    for (const auto z : numbers) {
      const double factor = ground.stiffness_of(z);
      own_weights.push_back(factor * weights[z]);
      if (scattered) stiffness.push_back(factor);
      if (strong) strengths.push_back(ground.strength_of(z) / factor);
    }
    const Grid own = some_zones(grid, numbers);
    std::unique_ptr<PoreWater> water;
    if (material.pores) {
      std::vector<double> whole, shares;  // weights without the stiffness; its inverse
      for (const auto z : numbers) whole.push_back(weights[z]);
      for (const double factor : stiffness) shares.push_back(1 / factor);
      water = std::make_unique<PoreWater>(own, material.pores->stiffness, whole, shares, ground.large_strain);
    }
    auto kernel = make_kernel(kind, own, ground, material, own_weights, strengths, water.get());
    add_part({std::move(kernel), std::move(numbers), std::move(stiffness), std::move(water)});
  }
}

void ZoneSet::add_part(Part part) {
  for (std::size_t z = 0; z < part.numbers.size(); ++z)
    places_[part.numbers[z]] = {static_cast<std::uint32_t>(parts_.size()), static_cast<std::uint32_t>(z)};
  parts_.push_back(std::move(part));
}

// In the order of the grid's zones.
void ZoneSet::collect_runs() {
  std::vector<std::pair<std::uint32_t, ZoneRun>> order;
  for (std::uint32_t part = 0; part < parts_.size(); ++part)
    for (auto run : parts_[part].kernel->runs()) {
      run.part = part;
      order.emplace_back(parts_[part].numbers[run.first], run);
    }
  std::ranges::sort(order, {}, &std::pair<std::uint32_t, ZoneRun>::first);
  runs_.clear();
  for (const auto& [first, run] : order) runs_.push_back(run);
}

// Without what another part has now.
void ZoneSet::collect_pieces() {
  constexpr std::uint32_t kPiece = 2048;
  pieces_.clear();
  for (std::uint32_t part = 0; part < parts_.size(); ++part) {
    const auto& numbers = parts_[part].numbers;
    protocol::for_each_range(
        static_cast<std::uint32_t>(numbers.size()),
        [&](std::uint32_t z) { return places_[numbers[z]].part == part; },
        [&](const protocol::IndexRange& range, bool here) {
          for (std::uint32_t begin = range.begin; here && begin < range.end; begin += kPiece)
            pieces_.push_back({part, {begin, std::min(begin + kPiece, range.end)}});
        });
  }
}

void ZoneSet::follow(const double* ux, const double* uy) {
  for (auto& part : parts_) part.follow(ux, uy);
}

void ZoneSet::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  while (!runs.empty()) {
    const auto part = runs.front().part;
    const auto own = std::ranges::find_if(runs, [part](const ZoneRun& run) { return run.part != part; });
    const auto count = static_cast<std::size_t>(own - runs.begin());
    parts_[part].kernel->add_forces(runs.first(count), dt, points);
    runs = runs.subspan(count);
  }
}

std::vector<bool> ZoneSet::Part::own(const std::vector<bool>& zones) const {
  std::vector<bool> flags(numbers.size());
  for (std::size_t z = 0; z < flags.size(); ++z) flags[z] = zones[numbers[z]];
  return flags;
}

void ZoneSet::add_forces_of(const std::vector<bool>& zones, double dt, const PointView& points) {
  for (auto& part : parts_) {
    std::vector<bool> others = part.own(zones);
    others.flip();
    part.kernel->add_forces(without(part.kernel->runs(), others), dt, points);
  }
}

void ZoneSet::Part::follow(const double* ux, const double* uy) {
  kernel->follow(ux, uy);
  if (water) water->follow(ux, uy);
}

void ZoneSet::Part::remove(const std::vector<bool>& gone) {
  kernel->remove(gone);
  if (water) water->remove(gone);
}

void ZoneSet::Part::complete(const protocol::IndexRange& batch, PlaneStresses& stresses) const {
  if (!stiffness.empty())
    for (auto* values : {&stresses.mean, &stresses.difference, &stresses.shear})
      for (std::uint32_t z = batch.begin; z < batch.end; ++z) (*values)[z - batch.begin] *= stiffness[z];
  if (water)
    for (std::uint32_t z = batch.begin; z < batch.end; ++z)
      stresses.mean[z - batch.begin] -= water->pressure(z);
}

void ZoneSet::set_stress(std::size_t zone, const Stress& stress) {
  parts_[places_[zone].part].kernel->set_stress(places_[zone].zone,
                                                times(1 / factor(zone), plus(stress, pore_pressure(zone))));
}

void ZoneSet::set_stress_zz(std::size_t zone, double zz) {
  parts_[places_[zone].part].kernel->set_stress_zz(places_[zone].zone,
                                                   (zz + pore_pressure(zone)) / factor(zone));
}

void ZoneSet::remove(const std::vector<bool>& gone) {
  for (auto& part : parts_) part.remove(part.own(gone));
  collect_runs();
}

// The mean stress does not act along the pattern.
BorneStress ZoneSet::borne(std::size_t zone) const {
  BorneStress borne{stress(zone), field(zone, ZoneField::kStressZz)};
  const ZoneForces pull = forces(zone);
  for (std::size_t c = 0; c < 4; ++c) {
    borne.pattern_x -= kHourglass[c] * pull.x[c];
    borne.pattern_y -= kHourglass[c] * pull.y[c];
  }
  return borne;
}

void ZoneSet::renew(ZoneKind kind, const Grid& grid, const Ground& ground,
                    std::span<const std::uint32_t> zones, const double* ux, const double* uy) {
  std::vector<BorneStress> before;
  std::vector<bool> renewed(count(), false);
  for (const auto zone : zones) {
    before.push_back(borne(zone));
    renewed[zone] = true;
  }
  for (auto& part : parts_) part.remove(part.own(renewed));
  const std::size_t first_new = parts_.size();
  add_parts(kind, grid, ground, std::vector<double>(count(), 1.0), renewed);
  for (Part& part : std::span(parts_).subspan(first_new)) part.follow(ux, uy);
  for (std::size_t i = 0; i < zones.size(); ++i)
    parts_[places_[zones[i]].part].kernel->set_borne(places_[zones[i]].zone,
                                                     times(1 / factor(zones[i]), before[i]));
  collect_runs();
  collect_pieces();
}

void ZoneSet::start_over() {
  for (auto& part : parts_) {
    part.kernel->start_over();
    if (part.water) part.water->start_over();
  }
}

void ZoneSet::set_rest(std::span<const double> pressures) {
  for (auto& part : parts_)
    if (part.water)
      for (std::size_t z = 0; z < part.numbers.size(); ++z)
        part.water->set_rest(z, pressures[part.numbers[z]]);
}

void ZoneSet::begin_time() {
  for (auto& part : parts_) {
    part.kernel->begin_time();
    if (!part.water) continue;
    std::vector<double> pressures;  // effective vertical ones
    for (const auto zone : part.numbers) pressures.push_back(-(stress(zone).yy + pore_pressure(zone)));
    part.water->seal(pressures);
  }
}

void ZoneSet::set_time(double time) {
  for (Part& part : parts_) part.kernel->set_time(time);
}

void ZoneSet::exchange(state::Archive& archive) {
  for (Part& part : parts_) {
    part.kernel->exchange(archive);
    if (part.water) part.water->exchange(archive);
  }
}

double ZoneSet::sum(protocol::Team& team, const auto& of) const {
  std::vector<double> sums(pieces_.size());
  team.run(pieces_.size(), [&](std::size_t i, std::size_t) { sums[i] = of(pieces_[i]); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double ZoneSet::strain_energy(protocol::Team& team) const {
  return sum(team, [&](const Piece& piece) {
    const Part& part = parts_[piece.part];
    return part.kernel->strain_energy(piece.zones) +
           (part.water ? part.water->strain_energy(piece.zones) : 0);
  });
}

double ZoneSet::internal_force(protocol::Team& team, std::span<const double> sizes) const {
  return sum(team, [&](const Piece& piece) {
    double sum = 0;
    see_stresses(piece, [&](std::span<const std::uint32_t> numbers, const PlaneStresses& stresses) {
      BatchValues norms;
      stress_sizes(static_cast<std::uint32_t>(numbers.size()), stresses, norms);
      sum += protocol::eight_sums(0, numbers.size(),
                                  [&](std::size_t k) { return sizes[numbers[k]] * norms[k]; });
    });
    return sum;
  });
}

double ZoneSet::dissipated() const {
  double sum = 0;
  for (const auto& part : parts_)
    sum += part.kernel->dissipated() + (part.water ? part.water->dissipated() : 0);
  return sum;
}

double ZoneSet::external_work() const {
  double sum = 0;
  for (const auto& part : parts_) sum += part.water ? part.water->external_work() : 0;
  return sum;
}

Stress ZoneSet::stress(std::size_t zone) const {
  const Stress effective = parts_[places_[zone].part].kernel->stress(places_[zone].zone);
  return plus(times(factor(zone), effective), -pore_pressure(zone));
}

double ZoneSet::pore_pressure(std::size_t zone) const {
  return parts_[places_[zone].part].pressure(places_[zone].zone);
}

std::optional<double> ZoneSet::water_pressure(std::size_t zone) const {
  if (!parts_[places_[zone].part].water) return std::nullopt;
  return pore_pressure(zone);
}

bool ZoneSet::any_water() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.water != nullptr; });
}

void ZoneSet::read_excess(protocol::Team& team, std::span<double> excess) const {
  team.run(pieces_.size(), [&](std::size_t i, std::size_t) {
    const auto& [part, zones] = pieces_[i];
    const auto& [numbers, water] = std::tie(parts_[part].numbers, parts_[part].water);
    for (std::uint32_t z = zones.begin; water && z < zones.end; ++z) excess[numbers[z]] = water->excess(z);
  });
}

void ZoneSet::set_inflow(protocol::Team& team, std::span<const double> inflow) {
  for (auto& part : parts_)
    if (part.water) part.water->begin_flow();
  team.run(pieces_.size(), [&](std::size_t i, std::size_t) {
    const auto& [part, zones] = pieces_[i];
    const auto& [numbers, water] = std::tie(parts_[part].numbers, parts_[part].water);
    for (std::uint32_t z = zones.begin; water && z < zones.end; ++z) water->set_inflow(z, inflow[numbers[z]]);
  });
}

double ZoneSet::pressure_ratio(std::size_t zone) const {
  const auto& water = parts_[places_[zone].part].water;
  return water ? water->ratio(places_[zone].zone) : 0;
}

ZoneForces ZoneSet::forces(std::size_t zone) const {
  ZoneForces forces = parts_[places_[zone].part].kernel->forces(places_[zone].zone);
  for (auto* component : {&forces.x, &forces.y})
    for (double& force : *component) force *= factor(zone);
  if (const auto& water = parts_[places_[zone].part].water) {
    const ZoneForces more = water->forces(places_[zone].zone);
    for (std::size_t c = 0; c < 4; ++c) {
      forces.x[c] += more.x[c];
      forces.y[c] += more.y[c];
    }
  }
  return forces;
}

double ZoneSet::demand(std::size_t zone) const {
  return parts_[places_[zone].part].kernel->demand(places_[zone].zone);
}

double ZoneSet::field(std::size_t zone, ZoneField field) const {
  const double value = parts_[places_[zone].part].kernel->field(places_[zone].zone, field);
  return field == ZoneField::kStressZz ? factor(zone) * value - pore_pressure(zone) : value;
}

}  // namespace adit::fdm
