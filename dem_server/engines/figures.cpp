#include "dem_server/engines/figures.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace adit::dem {
namespace {

void add(const std::string& name, const std::string& unit, const Extreme& extreme,
         const geometry::Point& place, std::vector<Figure>& figures) {
  figures.push_back({unit.empty() ? name : name + "_" + unit, extreme.value});
  figures.push_back({name + "_time_s", extreme.time});
  figures.push_back({name + "_x_m", place.x});
  figures.push_back({name + "_y_m", place.y});
}

}  // namespace

std::vector<Figure> figures_of(const Sections& sections, const Envelope& envelope) {
  std::vector<Figure> figures;
  for (const auto& [force, name, unit] : kForceNames) {
    const auto largest = envelope.largest(force), smallest = envelope.smallest(force);
    if (largest.empty()) continue;
    const auto most = std::ranges::max_element(largest, {}, &Extreme::value);
    const auto least = std::ranges::min_element(smallest, {}, &Extreme::value);
    add(std::string("sections_largest_") + name, unit, *most,
        sections.middle(static_cast<std::size_t>(most - largest.begin())), figures);
    add(std::string("sections_smallest_") + name, unit, *least,
        sections.middle(static_cast<std::size_t>(least - smallest.begin())), figures);
  }
  return figures;
}

std::vector<Figure> figures_of(const Sections& sections, const UsePeaks& peaks) {
  std::vector<Figure> figures;
  if (peaks.utilisation().empty()) return figures;
  struct Largest {
    const UsePeaks::Instant& instant;
    const Cut& cut;
  };
  const auto add_largest = [&](const char* name, std::span<const UsePeaks::Instant> of) {
    const auto most = std::ranges::max_element(of, {}, &UsePeaks::Instant::value);
    const auto number = static_cast<std::size_t>(most - of.begin());
    add(std::string("sections_largest_") + name, "", {most->value, most->time}, sections.middle(number),
        figures);
    return Largest{*most, sections.cuts()[number]};
  };
  const SectionForces bent = add_largest("utilisation", peaks.utilisation()).instant.forces;
  figures.push_back({"sections_thrust_at_largest_utilisation_N", bent.thrust});
  figures.push_back({"sections_moment_at_largest_utilisation_Nm", bent.moment});
  const SectionForces sheared = add_largest("shear_utilisation", peaks.shear()).instant.forces;
  figures.push_back({"sections_shear_at_largest_shear_utilisation_N", sheared.shear});
  figures.push_back({"sections_thrust_at_largest_shear_utilisation_N", sheared.thrust});
  const Largest ratio = add_largest("moment_ratio", peaks.moment_ratio());
  if (ratio.cut.strength)
    figures.push_back({"sections_damage_state", static_cast<double>(sections::damage_state(
                                                    *ratio.cut.strength, ratio.instant.value))});
  return figures;
}

std::vector<Figure> figures_of(std::span<const Oval> ovals, const OvalEnvelope& envelope) {
  std::vector<Figure> figures;
  if (envelope.largest().empty()) return figures;
  const auto add_oval = [&](const std::string& name, const auto& extremes, const auto& extreme) {
    const geometry::Point& centre = ovals[static_cast<std::size_t>(extreme - extremes.begin())].centre();
    add(name, "m", {extreme->value, extreme->time}, centre, figures);
    figures.push_back({name + "_direction_rad", extreme->direction});
  };
  const auto largest = envelope.largest(), smallest = envelope.smallest();
  using Extreme = OvalEnvelope::Extreme;
  add_oval("ovals_largest_diameter_change", largest, std::ranges::max_element(largest, {}, &Extreme::value));
  add_oval("ovals_smallest_diameter_change", smallest,
           std::ranges::min_element(smallest, {}, &Extreme::value));
  return figures;
}

std::vector<Figure> figures_of(const SpringBreaks& breaks) {
  std::vector<Figure> figures{{"springs_broken", static_cast<double>(breaks.count)}};
  if (breaks.count > 0)
    figures.insert(figures.end(), {{"first_broken_spring_time_s", breaks.time},
                                   {"first_broken_spring_x_m", breaks.x},
                                   {"first_broken_spring_y_m", breaks.y}});
  return figures;
}

std::vector<Figure> figures_of(const WidestCrack& widest) {
  std::vector<Figure> figures;
  if (widest.width > 0)
    add("largest_crack_width", "m", {widest.width, widest.time}, {widest.x, widest.y}, figures);
  return figures;
}

std::vector<Figure> figures_of(const BarPeaks& peaks) {
  std::vector<Figure> figures;
  const auto add_peak = [&](const std::string& name, const std::string& unit, const BarPeaks::Peak& peak) {
    add("bars_largest_" + name, unit, {peak.value, peak.time}, {peak.x, peak.y}, figures);
  };
  add_peak("stress", "Pa", peaks.stress);
  add_peak("force", "N", peaks.force);
  add_peak("strain", "", peaks.strain);
  add_peak("slip", "m", peaks.slip);
  return figures;
}

}  // namespace adit::dem
