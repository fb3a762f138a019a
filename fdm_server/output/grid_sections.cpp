#include "fdm_server/output/grid_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fdm_server/grid/cut.hpp"
#include "fdm_server/grid/edges.hpp"
#include "fdm_server/output/zone_fit.hpp"
#include "fdm_server/supports/curve.hpp"
#include "fdm_server/supports/trace.hpp"
#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/participant/history.hpp"
#include "protocol/sections/read_section.hpp"

namespace adit::fdm {

GridSections::GridSections(const scene::Continuum& scene, const Grid& grid,
                           std::span<const std::uint32_t> zone_kinds, const DampingLaw& damping)
    : damping_(damping) {
  if (scene.sections().empty()) return;
  const Grid whole = welded(grid);  // a section runs across interfaces
  const Edges edges = number_edges(whole);
  for (int i = 0; i < scene.sections_size(); ++i) {
    const scene::GridSection& given = scene.sections(i);
    const std::string path = fmt::format("continuum.sections[{}]", i);
    const auto same = std::ranges::find(sections_, given.name(), &Section::name);
    protocol::require(
        same == sections_.end(), path + ".name",
        fmt::format("is `{}`, as that of continuum.sections[{}]; give each section a name of its own",
                    given.name(), same - sections_.begin()));
    const geometry::Point from{given.from().x(), given.from().y()}, to{given.to().x(), given.to().y()};
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    protocol::require(length > 0, path + ".to", "is the same place as `from`; give the section a length");
    Section& section = sections_.emplace_back();
    section.name = given.name();
    section.x = (to.x - from.x) / length;
    section.y = (to.y - from.y) / length;
    if (given.has_section())
      section.strength = std::make_shared<const sections::Strength>(
          sections::strength_of(sections::read_section(given.section(), 1, path + ".section")));
    // From `from`, along the section and to its left [m].
    const auto along = [&](double x, double y) {
      return section.x * (x - from.x) + section.y * (y - from.y);
    };
    const auto left = [&](double x, double y) { return section.x * (y - from.y) - section.y * (x - from.x); };

    std::map<std::int32_t, double> places;  // of the section's points
    for (const std::uint32_t point : trace(whole, edges, *polyline({from, to}), path).points)
      places.emplace(point, along(grid.x[point], grid.y[point]));
    for (std::uint32_t zone = 0; zone < grid.own_zones(); ++zone) {
      const auto [x, y] = centroid(corners(grid, zone));
      if (along(x, y) < 0 || along(x, y) > length) continue;
      const auto on_section =
          std::ranges::count_if(whole.zones[zone], [&](auto point) { return places.contains(point); });
      protocol::require(
          on_section < 2 || zone_kinds[zone] != kNoGround, path,
          fmt::format("runs beside the zone at ({:.6g}, {:.6g}) m, which is excavated; lay it through "
                      "ground that stays",
                      x, y));
      if (zone_kinds[zone] == kNoGround) continue;  // at most it lies off an end
      for (std::size_t c = 0; c < 4; ++c)
        if (const auto place = places.find(whole.zones[zone][c]); place != places.end()) {
          section.corners.push_back({zone, c, left(x, y) < 0 ? 0.5 : -0.5, place->second - length / 2});
        }
    }
    for (const double side : {0.5, -0.5})
      protocol::require(
          std::ranges::find(section.corners, side, &Corner::share) != section.corners.end(), path,
          "has zones on one side only; lay it through the ground, such as a row of zones further in");
  }
}

std::size_t GridSections::number_of(const scene::History& history, const std::string& path) const {
  const auto found = std::ranges::find(sections_, history.section(), &Section::name);
  if (found != sections_.end()) {
    const auto number = static_cast<std::size_t>(found - sections_.begin());
    protocol::require_strength(history, found->strength != nullptr,
                               fmt::format("continuum.sections[{}]", number), path);
    return number;
  }
  std::vector<std::string> names;
  for (const Section& section : sections_) names.push_back(section.name);
  throw protocol::UserError(path + ".section", "is `" + history.section() +
                                                   "`, but no section of the continuum has this name" +
                                                   protocol::did_you_mean(history.section(), names));
}

LiningForces GridSections::undamped(const ZoneSet& zones, const Section& section) {
  LiningForces sum{};
  for (const auto& [zone, corner, share, along] : section.corners) {
    const ZoneForces forces = zones.forces(zone);
    const double x = share * forces.x[corner], y = share * forces.y[corner];
    const double pull = section.y * x - section.x * y;  // -F.n
    sum.thrust += pull;
    sum.moment += along * pull;
    sum.shear += section.x * x + section.y * y;
  }
  return sum;
}

void GridSections::follow(const ZoneSet& zones, const protocol::Step& step) {
  if (damping_.count() == 0 || step.relax) return;
  const MaxwellStep maxwell(damping_, step);
  for (Section& section : sections_) {
    const LiningForces now = undamped(zones, section);
    section.thrust.follow(maxwell, now.thrust);
    section.moment.follow(maxwell, now.moment);
    section.shear.follow(maxwell, now.shear);
  }
}

LiningForces GridSections::of(const ZoneSet& zones, std::size_t number) const {
  const Section& section = sections_[number];
  const LiningForces sum = undamped(zones, section);
  return {sum.thrust + section.thrust.added(), sum.moment + section.moment.added(),
          sum.shear + section.shear.added()};
}

sections::Use GridSections::use(const ZoneSet& zones, std::size_t number) const {
  const auto [thrust, moment, shear] = of(zones, number);
  return sections::use_of(*sections_[number].strength, {thrust, moment}, shear);
}

void GridSections::exchange(state::Archive& archive) {
  archive.members("grid_sections", std::span(sections_), &Section::thrust, &Section::moment, &Section::shear);
}

}  // namespace adit::fdm
