#include "fdm_server/zones/nonlinear/material_zones.hpp"

#include <algorithm>

#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/nonlinear/law_zones.hpp"

namespace adit::fdm {
namespace {

// The zones of one material among the same points.
Grid zones_of(const Grid& grid, const Ground& ground, std::size_t material) {
  Grid some{grid.x, grid.y, {}};
  const std::size_t first_own = grid.zones.size() - grid.own_corners.size();
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    if (ground.of_zone[z] != material) continue;
    some.zones.push_back(grid.zones[z]);
    if (z >= first_own) some.own_corners.push_back(grid.own_corners[z - first_own]);
  }
  return some;
}

bool by_fast_kernel(const Ground& ground, const Material& material) {
  return material.linear() && !ground.large_strain;
}

// The zones of one material.
std::unique_ptr<Zones> make_zones(ZoneKind kind, const Grid& grid, const Ground& ground,
                                  const Material& material, std::span<const double> weights) {
  if (by_fast_kernel(ground, material)) return make_zones(kind, grid, ground.plane_law(material), weights);
  return std::make_unique<LawZones>(kind, grid, material, weights, ground.large_strain);
}

}  // namespace

MaterialZones::MaterialZones(ZoneKind kind, const Grid& grid, const Ground& ground,
                             std::span<const double> weights)
    : places_(grid.zones.size()) {
  for (std::size_t m = 0; m < ground.materials.size(); ++m) {
    const auto part = static_cast<std::uint32_t>(parts_.size());
    std::vector<double> own_weights;
    std::vector<std::uint32_t> numbers;  // of the part's zones in the grid
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
      if (ground.of_zone[z] != m) continue;
      places_[z] = {part, static_cast<std::uint32_t>(own_weights.size())};
      own_weights.push_back(weights[z]);
      numbers.push_back(static_cast<std::uint32_t>(z));
    }
    if (own_weights.empty()) continue;
    const auto& material = ground.materials[m];
    parts_.push_back({make_zones(kind, zones_of(grid, ground, m), ground, material, own_weights),
                      ground.plane_stress ? 0 : material.poisson, by_fast_kernel(ground, material),
                      std::move(numbers)});
  }
  collect_runs();
}

// In the order of the grid's zones.
void MaterialZones::collect_runs() {
  std::vector<std::pair<std::uint32_t, ZoneRun>> order;
  for (std::uint32_t part = 0; part < parts_.size(); ++part)
    for (auto run : parts_[part].zones->runs()) {
      run.part = part;
      order.emplace_back(parts_[part].numbers[run.first], run);
    }
  std::ranges::sort(order, {}, &std::pair<std::uint32_t, ZoneRun>::first);
  runs_.clear();
  for (const auto& [first, run] : order) runs_.push_back(run);
}

void MaterialZones::remove(const std::vector<bool>& gone) {
  for (auto& part : parts_) {
    std::vector<bool> own(part.numbers.size());
    for (std::size_t z = 0; z < own.size(); ++z) own[z] = gone[part.numbers[z]];
    part.zones->remove(own);
  }
  collect_runs();
}

void MaterialZones::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  while (!runs.empty()) {
    const auto part = runs.front().part;
    const auto own = std::ranges::find_if(runs, [part](const ZoneRun& run) { return run.part != part; });
    const auto count = static_cast<std::size_t>(own - runs.begin());
    parts_[part].zones->add_forces(runs.first(count), dt, points);
    runs = runs.subspan(count);
  }
}

void MaterialZones::set_stress(std::size_t zone, const Stress& stress) {
  parts_[places_[zone].part].zones->set_stress(places_[zone].zone, stress);
}

void MaterialZones::set_stress_zz(std::size_t zone, double zz) {
  parts_[places_[zone].part].zones->set_stress_zz(places_[zone].zone, zz);
}

void MaterialZones::follow(const double* ux, const double* uy) {
  for (auto& part : parts_) part.zones->follow(ux, uy);
}

void MaterialZones::start_over() {
  for (auto& part : parts_) part.zones->start_over();
}

double MaterialZones::strain_energy() const {
  double sum = 0;
  for (const auto& part : parts_) sum += part.zones->strain_energy();
  return sum;
}

double MaterialZones::dissipated() const {
  double sum = 0;
  for (const auto& part : parts_) sum += part.zones->dissipated();
  return sum;
}

Stress MaterialZones::stress(std::size_t zone) const {
  return parts_[places_[zone].part].zones->stress(places_[zone].zone);
}

double MaterialZones::field(std::size_t zone, ZoneField field) const {
  const auto& part = parts_[places_[zone].part];
  if (!part.linear) return part.zones->field(places_[zone].zone, field);
  if (field != ZoneField::kStressZz) return 0;
  const auto [xx, yy, xy] = stress(zone);
  return part.poisson_zz * (xx + yy);
}

std::vector<double> zone_densities(const Ground& ground) {
  std::vector<double> densities;
  densities.reserve(ground.of_zone.size());
  for (const auto material : ground.of_zone) densities.push_back(ground.materials[material].density);
  return densities;
}

double critical_step(ZoneKind kind, const Grid& grid, const Ground& ground) {
  double smallest = HUGE_VAL;
  for (std::size_t m = 0; m < ground.materials.size(); ++m) {
    const auto own = zones_of(grid, ground, m);
    if (own.zones.empty()) continue;
    const auto& material = ground.materials[m];
    // of elastic zones in small strain, because the stiffness is measured on displacements of 1 m
    const auto elastic = [&](const Grid& zones) -> std::unique_ptr<Zones> {
      const std::vector<double> weights(zones.zones.size(), 1.0);
      if (by_fast_kernel(ground, material))
        return make_zones(kind, zones, ground.plane_law(material), weights);
      return std::make_unique<LawZones>(
          kind, zones, Material{material.density, material.young, material.poisson}, weights, false);
    };
    smallest = std::min(smallest, critical_step(own, material.density, elastic));
  }
  return smallest;
}

}  // namespace adit::fdm
