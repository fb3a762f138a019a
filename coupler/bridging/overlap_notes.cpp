#include "coupler/bridging/overlap_notes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/bridging/presence.hpp"

namespace adit::coupler {
namespace {

std::string narrow_note(const Overlap& overlap, const Side& side) {
  if (!side.part.has_continuum()) return {};
  const Presence model(side.samples);
  double zone = 0;
  for (std::size_t i = 0; i + 1 < side.samples.size(); i += 2)
    if (const double x = side.samples[i], y = side.samples[i + 1]; overlap.contains(x, y)) {
      const double size = model.size(x, y);
      if (zone == 0 || size < zone) zone = size;
    }
  if (overlap.width() >= (1 - 1e-6) * zone) return {};
  return fmt::format(
      "{}.overlap is {:.3g} m wide, less than a zone of `{}` there ({:.3g} m); two zones or more carry "
      "waves better",
      overlap.path(), overlap.width(), side.name, zone);
}

constexpr double kAlike = 1.05 + 1e-9;

double ratio(double one, double other) {
  return std::max(one / other, other / one);
}

// Bonds reach Poisson's ratios below those of many soils; the particles of such ground have its shear
// modulus.
double contrast(const Ground& one, const Ground& other) {
  double largest = 1;
  if (one.stiffness && other.stiffness)
    largest = std::min(ratio(one.stiffness->young, other.stiffness->young),
                       ratio(one.stiffness->shear, other.stiffness->shear));
  return one.density && other.density ? std::max(largest, ratio(*one.density, *other.density)) : largest;
}

std::string told(const Ground& ground, const std::string& model) {
  std::vector<std::string> values;
  if (ground.stiffness) values.push_back(fmt::format("{:.4g} GPa", ground.stiffness->young / 1e9));
  if (ground.density) values.push_back(fmt::format("{:.4g} kg/m^3", *ground.density));
  return fmt::format("{} of `{}` ({})", fmt::join(values, " and "), model, ground.path);
}

// What the scene tells of the outer model at the particles of the overlap and of its core.
std::vector<GroundHere> told_by_scene(const Overlap& overlap, const StatedGround& outer,
                                      std::span<const double> samples) {
  std::vector<GroundHere> places;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2)
    if (const double x = samples[i], y = samples[i + 1]; overlap.inner_weight(x, y) > 0)
      places.push_back({x, y, outer.at(x, y)});
  return places;
}

std::string sentence(const Overlap& overlap, const std::string& outer, const std::string& inner,
                     const GroundHere& zones, const Ground& particles) {
  if (overlap.contains(zones.x, zones.y))
    return fmt::format(
        "{}.overlap lies at ({:.4g}, {:.4g}) m between {} and {}; lay it through ground that both model "
        "alike, outside a lining, or give both the same material there",
        overlap.path(), zones.x, zones.y, told(zones.ground, outer), told(particles, inner));
  return fmt::format(
      "{} stands at ({:.4g}, {:.4g}) m in place of {}: it states no material of its own; give it one, or a "
      "group there",
      told(particles, inner), zones.x, zones.y, told(zones.ground, outer));
}

}  // namespace

std::vector<std::string> overlap_notes(const Overlap& overlap, const Side& outer, const Side& inner) {
  std::vector<std::string> notes{narrow_note(overlap, outer), narrow_note(overlap, inner)};
  std::erase(notes, "");
  return notes;
}

std::optional<std::string> ground_warning(const Overlap& overlap, const Side& outer, const Side& inner,
                                          const std::vector<GroundHere>& outer_ground) {
  const StatedGround outside(outer.part, outer.path), inside(inner.part, inner.path);
  if (!inside.is_known()) return std::nullopt;
  const Presence outer_model(outer.samples);
  double largest = kAlike;
  std::optional<std::string> warning;
  for (const GroundHere& here :
       outside.is_known() ? told_by_scene(overlap, outside, inner.samples) : outer_ground) {
    const Ground other = inside.at(here.x, here.y);
    const double found = contrast(here.ground, other);
    if (found <= largest || overlap.inner_weight(here.x, here.y) == 0) continue;
    const bool replaced = other.assumed && outer_model.gap(here.x, here.y, 0) == 0;
    if (!overlap.contains(here.x, here.y) && !replaced) continue;
    largest = found;
    warning = sentence(overlap, outer.name, inner.name, here, other);
  }
  return warning;
}

}  // namespace adit::coupler
