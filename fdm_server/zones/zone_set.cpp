#include "fdm_server/zones/zone_set.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "fdm_server/zones/batch/zone_kernels.hpp"
#include "fdm_server/zones/elastic/elastic_zones.hpp"
#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"
#include "protocol/kernels/sums.hpp"

namespace adit::fdm {
namespace {

std::unique_ptr<ZoneKernel> make_kernel(ZoneKind kind, const Grid& grid, const Ground& ground,
                                        const Material& material, std::span<const double> weights) {
  if (ground.is_elastic(material))
    return std::make_unique<ElasticZones>(kind, grid, ground.plane_law(material), weights,
                                          ground.plane_stress ? 0 : material.poisson);
  return std::make_unique<NonlinearZones>(kind, grid, material, weights, ground.large_strain);
}

}  // namespace

Grid zones_of_material(const Grid& grid, const Ground& ground, std::size_t material) {
  Grid some{grid.x, grid.y, {}};
  const std::size_t first_own = grid.zones.size() - grid.own_corners.size();
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    if (ground.of_zone[z] != material) continue;
    some.zones.push_back(grid.zones[z]);
    if (z >= first_own) some.own_corners.push_back(grid.own_corners[z - first_own]);
  }
  return some;
}

ZoneSet::ZoneSet(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const double> weights)
    : places_(grid.zones.size()) {
  for (std::size_t m = 0; m < ground.materials.size(); ++m) {
    std::vector<double> own_weights;
    std::vector<std::uint32_t> numbers;
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      if (ground.of_zone[z] != m) continue;
      own_weights.push_back(weights[z]);
      numbers.push_back(static_cast<std::uint32_t>(z));
    }
    if (numbers.empty()) continue;
    add_part(make_kernel(kind, zones_of_material(grid, ground, m), ground, ground.materials[m], own_weights),
             std::move(numbers));
  }
  collect_runs();
}

ZoneSet::ZoneSet(ZoneKind kind, const Grid& grid, const PlaneLaw& law, std::span<const double> weights)
    : places_(grid.zones.size()) {
  std::vector<std::uint32_t> numbers(grid.zones.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  add_part(std::make_unique<ElasticZones>(kind, grid, law, weights), std::move(numbers));
  collect_runs();
}

void ZoneSet::add_part(std::unique_ptr<ZoneKernel> kernel, std::vector<std::uint32_t> numbers) {
  const auto part = static_cast<std::uint32_t>(parts_.size());
  for (std::size_t z = 0; z < numbers.size(); ++z)
    places_[numbers[z]] = {part, static_cast<std::uint32_t>(z)};
  constexpr std::uint32_t kPiece = 2048;
  const auto count = static_cast<std::uint32_t>(numbers.size());
  for (std::uint32_t begin = 0; begin < count; begin += kPiece)
    pieces_.push_back({part, {begin, std::min(begin + kPiece, count)}});
  parts_.push_back({std::move(kernel), std::move(numbers)});
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

void ZoneSet::follow(const double* ux, const double* uy) {
  for (auto& part : parts_) part.kernel->follow(ux, uy);
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

void ZoneSet::set_stress(std::size_t zone, const Stress& stress) {
  parts_[places_[zone].part].kernel->set_stress(places_[zone].zone, stress);
}

void ZoneSet::set_stress_zz(std::size_t zone, double zz) {
  parts_[places_[zone].part].kernel->set_stress_zz(places_[zone].zone, zz);
}

void ZoneSet::remove(const std::vector<bool>& gone) {
  for (auto& part : parts_) part.kernel->remove(part.own(gone));
  collect_runs();
}

void ZoneSet::start_over() {
  for (auto& part : parts_) part.kernel->start_over();
}

double ZoneSet::sum(protocol::Team& team, const auto& of) const {
  std::vector<double> sums(pieces_.size());
  team.run(pieces_.size(), [&](std::size_t i, std::size_t) { sums[i] = of(pieces_[i]); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double ZoneSet::strain_energy(protocol::Team& team) const {
  return sum(team, [&](const Piece& piece) { return parts_[piece.part].kernel->strain_energy(piece.zones); });
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
  for (const auto& part : parts_) sum += part.kernel->dissipated();
  return sum;
}

Stress ZoneSet::stress(std::size_t zone) const {
  return parts_[places_[zone].part].kernel->stress(places_[zone].zone);
}

ZoneForces ZoneSet::forces(std::size_t zone) const {
  return parts_[places_[zone].part].kernel->forces(places_[zone].zone);
}

double ZoneSet::field(std::size_t zone, ZoneField field) const {
  return parts_[places_[zone].part].kernel->field(places_[zone].zone, field);
}

}  // namespace adit::fdm
