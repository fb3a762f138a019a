#include "fdm_server/output/histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "fdm_server/grid/locate.hpp"
#include "fdm_server/output/mean_strain.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

bool is_stress(scene::Quantity quantity) {
  return quantity == scene::STRESS_XX || quantity == scene::STRESS_YY || quantity == scene::STRESS_XY;
}

bool is_of_water(scene::Quantity quantity) {
  return quantity == scene::PORE_PRESSURE || quantity == scene::PRESSURE_RATIO ||
         quantity == scene::EFFECTIVE_STRESS_XX || quantity == scene::EFFECTIVE_STRESS_YY;
}

bool is_of_zones(scene::Quantity quantity) {
  return is_stress(quantity) || is_of_water(quantity) || quantity == scene::STRESS_ZZ ||
         quantity == scene::STRAIN_XX || quantity == scene::STRAIN_YY || quantity == scene::SHEAR_STRAIN_XY;
}

std::span<const double> velocity(const Continuum& continuum, scene::Quantity quantity) {
  return quantity == scene::VELOCITY_Y || quantity == scene::ACCELERATION_Y ? continuum.vy() : continuum.vx();
}

// Reads values of zones by number.
template <class Value>
double sum(const ZoneShares& fit, Value&& value) {
  double sum = 0;
  for (std::size_t k = 0; k < fit.zones.size(); ++k) sum += fit.shares[k] * value(fit.zones[k]);
  return sum;
}

[[noreturn]] void refuse_place(const Grid& grid, const ZoneLocator& locator, const std::vector<bool>& hidden,
                               double x, double y, const std::string& path) {
  const auto zone = locator.locate(x, y);
  const bool excavated = zone && zone->zone < grid.own_zones();
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;  // among the points of ground that stays
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    if (hidden[z]) continue;
    for (const std::uint32_t point : grid.zones[z])
      if (const double d = std::hypot(grid.x[point] - x, grid.y[point] - y); d < distance) {
        distance = d;
        nearest = point;
      }
  }
  throw protocol::UserError(
      path, fmt::format("is ({:g}, {:g}) m, {}; the nearest grid point of ground that stays is ({:g}, {:g}) "
                        "m, put it inside the continuum",
                        x, y,
                        excavated ? "in a zone that continuum.excavations take away"
                                  : "where the continuum has no zone",
                        grid.x[nearest], grid.y[nearest]));
}

double stress(const Stress& stress, scene::Quantity quantity) {
  return quantity == scene::STRESS_XX ? stress.xx : quantity == scene::STRESS_YY ? stress.yy : stress.xy;
}

double strain(const MeanStrain& strain, scene::Quantity quantity) {
  return quantity == scene::STRAIN_XX ? strain.xx : quantity == scene::STRAIN_YY ? strain.yy : strain.xy;
}

double resultant(const LiningForces& forces, scene::Quantity quantity) {
  return quantity == scene::THRUST ? forces.thrust : quantity == scene::MOMENT ? forces.moment : forces.shear;
}

}  // namespace

Histories::Histories(const scene::Continuum& scene, const Supports& supports, const Grid& grid,
                     std::span<const std::uint32_t> zone_kinds, std::span<const Material> materials,
                     const DampingLaw& damping)
    : sections_(scene, grid, zone_kinds, damping), stress_(damping, {}) {
  if (scene.histories().empty()) return;
  const ZoneLocator locator(grid);
  std::vector<bool> hidden;
  for (const auto kind : zone_kinds) hidden.push_back(kind == kNoGround);
  for (int i = 0; i < scene.histories_size(); ++i) {
    const auto& history = scene.histories(i);
    const std::string path = fmt::format("continuum.histories[{}]", i);
    const bool motion = protocol::is_motion(history.quantity()), zones = is_of_zones(history.quantity()),
               resultant = is_of_lining(history.quantity()), interface = is_of_interface(history.quantity()),
               demand = history.quantity() == scene::DEMAND;
    if (!motion && !zones && !resultant && !interface && !demand)
      throw protocol::UserError(path + ".quantity",
                                fmt::format("is {}, which only particles have; ask particles.histories",
                                            protocol::name_of(history.quantity())));
    protocol::require_relative_motion(history, path);
    Probe& probe = probes_.emplace_back(Probe{history.quantity()});
    if (resultant && history.has_section() && history.quantity() != scene::CURVATURE &&
        !is_of_segments(history.quantity()) && !is_of_dowels(history.quantity())) {
      probe.section = sections_.number_of(history, path);
      continue;
    }
    if (!history.has_at())
      throw protocol::UserError(path + ".at", "is missing; give the place, {x: …, y: …}");
    if (resultant) {
      probe.lining = resolve_lining_probe(history, supports, grid, path);
      continue;
    }
    if (interface) {
      probe.interface = resolve_interface_probe(history, supports, grid, path);
      continue;
    }
    const auto find = [&](const scene::Point& at, const std::string& key) {
      const auto place = locator.locate(at.x(), at.y(), hidden);
      if (!place) refuse_place(grid, locator, hidden, at.x(), at.y(), path + key);
      return *place;
    };
    const auto add = [&](const Place& place, double sign) {
      for (std::size_t c = 0; c < 4; ++c)
        if (place.shape[c] != 0)
          probe.motion.push_back(
              {static_cast<std::uint32_t>(grid.zones[place.zone][c]), sign * place.shape[c]});
    };
    const Place place = find(history.at(), ".at");
    if (zones) probe.zones = fit_around(grid, zone_kinds, place.zone, history.at().x(), history.at().y());
    if (demand && !materials[zone_kinds[place.zone]].states_strength())
      throw protocol::UserError(
          path + ".quantity",
          "is demand, but the material there states no strength to compare with; give it "
          "`mohr_coulomb`, `weak_plane`, `fracture` or a class of `concrete`");
    if (demand) probe.zones = {{place.zone}, {1}};
    if (motion) add(place, 1);
    if (history.has_relative_to()) add(find(history.relative_to(), ".relative_to"), -1);
  }
  stress_ = DampedStress(damping, zones_of_stress());
}

std::vector<std::uint32_t> Histories::zones_of_stress() const {
  std::set<std::uint32_t> zones;
  for (const Probe& probe : probes_)
    if (is_stress(probe.quantity)) zones.insert(probe.zones.zones.begin(), probe.zones.zones.end());
  return {zones.begin(), zones.end()};
}

void Histories::tie(std::span<const std::uint32_t> points) {
  for (Probe& probe : probes_)
    for (const auto& [point, share] : probe.motion)
      if (std::ranges::find(points, point) != points.end()) probe.tied = true;
}

double Histories::at(std::span<const PointShare> motion, std::span<const double> field) {
  double sum = 0;
  for (const auto& [point, share] : motion) sum += share * field[point];
  return sum;
}

void Histories::remember(const Continuum& continuum) {
  for (Probe& probe : probes_)
    if (protocol::is_motion(probe.quantity))
      probe.velocity.remember(at(probe.motion, velocity(continuum, probe.quantity)));
}

void Histories::read(const Grid& grid, const Supports& supports, const Continuum& continuum,
                     const protocol::Step& step, google::protobuf::RepeatedField<double>& values) const {
  for (const Probe& probe : probes_) values.Add(value(probe, grid, supports, continuum, step));
}

double Histories::value(const Probe& probe, const Grid& grid, const Supports& supports,
                        const Continuum& continuum, const protocol::Step& step) const {
  const auto& [quantity, motion, zones, tied, velocity, lining, section, interface] = probe;
  switch (quantity) {
    case scene::DISPLACEMENT_X:
      return at(motion, continuum.ux());
    case scene::DISPLACEMENT_Y:
      return at(motion, continuum.uy());
    case scene::VELOCITY_X:
    case scene::VELOCITY_Y:
      return velocity.before();
    case scene::ACCELERATION_X:
      return velocity.acceleration(at(motion, continuum.vx()), step, tied);
    case scene::ACCELERATION_Y:
      return velocity.acceleration(at(motion, continuum.vy()), step, tied);
    case scene::STRESS_XX:
    case scene::STRESS_YY:
    case scene::STRESS_XY:
      return sum(zones, [&, quantity = quantity](std::uint32_t z) {
        return stress(stress_.of(continuum.zones(), z), quantity);
      });
    case scene::STRESS_ZZ:
      return sum(zones, [&](std::uint32_t z) { return continuum.zones().field(z, ZoneField::kStressZz); });
    case scene::PORE_PRESSURE:
      return sum(zones, [&](std::uint32_t z) { return continuum.zones().pore_pressure(z); });
    case scene::PRESSURE_RATIO:
      return sum(zones, [&](std::uint32_t z) { return continuum.zones().pressure_ratio(z); });
    case scene::EFFECTIVE_STRESS_XX:
    case scene::EFFECTIVE_STRESS_YY:
      return sum(zones, [&, quantity = quantity](std::uint32_t z) {
        const Stress total = continuum.zones().stress(z);
        return (quantity == scene::EFFECTIVE_STRESS_XX ? total.xx : total.yy) +
               continuum.zones().pore_pressure(z);
      });
    case scene::DEMAND:
      return continuum.zones().demand(zones.zones.front());
    case scene::STRAIN_XX:
    case scene::STRAIN_YY:
    case scene::SHEAR_STRAIN_XY:
      return sum(zones, [&, quantity = quantity](std::uint32_t z) {
        const MeanGradient gradient = mean_gradient(corners(grid, z));
        return strain(mean_strain(gradient, grid.zones[z], continuum.ux(), continuum.uy()), quantity);
      });
    case scene::THRUST:
    case scene::MOMENT:
    case scene::SHEAR_FORCE:
    case scene::UTILISATION:
    case scene::CURVATURE:
    case scene::SHEAR_STRENGTH:
    case scene::ROTATION:
    case scene::OUTER_OPENING:
    case scene::INNER_OPENING:
    case scene::GASKET_OPENING:
    case scene::TIGHTNESS:
    case scene::BOLT_FORCE:
    case scene::DOWEL_FORCE:
    case scene::RING_OFFSET:
      if (lining) return fdm::value(*lining, supports, continuum.structures());
      if (quantity == scene::UTILISATION) return sections_.use(continuum.zones(), section).utilisation;
      if (quantity == scene::SHEAR_STRENGTH) return sections_.use(continuum.zones(), section).shear_strength;
      return resultant(sections_.of(continuum.zones(), section), quantity);
    case scene::OPENING:
    case scene::OFFSET:
    case scene::NORMAL_STRESS:
    case scene::SHEAR_STRESS:
      return fdm::value(*interface, continuum.contacts());
    default:  // of the particles: refused before
      break;
  }
  throw std::logic_error("no probe measures this quantity");
}

}  // namespace adit::fdm
