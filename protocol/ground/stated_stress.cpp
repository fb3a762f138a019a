#include "protocol/ground/stated_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/ground/water_at_rest.hpp"

namespace adit::protocol {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool has_components(const scene::Stress& s) {
  return s.has_xx() || s.has_yy() || s.has_xy() || s.has_zz() || s.has_xx_per_metre() ||
         s.has_yy_per_metre() || s.has_zz_per_metre();
}

void check_line(const scene::Stress& stress) {
  if (stress.surface_line().empty()) return;
  if (stress.has_surface())
    throw UserError("initial_stress.surface_line",
                    "is given beside `surface`; keep the one that is the ground's");
  for (int k = 1; k < stress.surface_line_size(); ++k)
    if (!(stress.surface_line(k - 1).x() < stress.surface_line(k).x()))
      throw UserError(
          fmt::format("initial_stress.surface_line[{}].x", k),
          fmt::format("is {:g} m, not right of the point before at {:g} m; give the points from left to "
                      "right",
                      stress.surface_line(k).x(), stress.surface_line(k - 1).x()));
}

// The y of the highest place of the ground.
double top_of(const scene::Stress& stress) {
  if (stress.surface_line().empty()) return stress.surface();
  return std::ranges::max_element(stress.surface_line(), {}, [](const scene::Point& p) { return p.y(); })
      ->y();
}

void check(const scene::Stress& stress) {
  if (stress.layers().empty()) {
    const char* of_layers = stress.has_surface()             ? "surface"
                            : stress.has_surcharge()         ? "surcharge"
                            : stress.surface_line_size() > 0 ? "surface_line"
                                                             : nullptr;
    if (of_layers != nullptr)
      throw UserError(fmt::format("initial_stress.{}", of_layers),
                      "is given without layers; add them to initial_stress.layers, or leave it out");
    return;
  }
  check_line(stress);
  if (has_components(stress))
    throw UserError("initial_stress.layers",
                    "are given beside components of the stress; give either the layers or the components");
  double above = top_of(stress);
  for (int k = 0; k < stress.layers_size(); ++k) {
    const double bottom = stress.layers(k).bottom();
    if (!(bottom < above))
      throw UserError(fmt::format("initial_stress.layers[{}].bottom", k),
                      fmt::format("is {:g} m, not below {} at {:g} m; give the layers from the surface "
                                  "downwards",
                                  bottom, k == 0 ? "the surface" : "the layer above, which ends", above));
    above = bottom;
  }
}

}  // namespace

StatedStress::StatedStress(const scene::Stress& stress, const scene::Water* water)
    : surface_(stress.layers().empty() ? kInfinity : top_of(stress)), surcharge_(stress.surcharge()) {
  check(stress);
  if (water) read_sea(*water);
  for (const scene::Point& point : stress.surface_line()) line_.emplace_back(point.x(), point.y());
  if (stress.layers().empty()) {
    Piece piece{
        -kInfinity,       0, 0, {stress.xx(), stress.xx_per_metre()}, {stress.yy(), stress.yy_per_metre()},
        {stress.xy(), 0}, {}};
    if (stress.has_zz() || stress.has_zz_per_metre()) piece.zz = Linear{stress.zz(), stress.zz_per_metre()};
    pieces_.push_back(piece);
    return;
  }
  // Where the sea differs from place to place, a level surface is a line, too.
  if (!seas_.empty() && line_.empty()) line_.emplace_back(0, surface_);
  double top = surface_, vertical = -load_on(0, surface_);
  for (const scene::GroundLayer& layer : stress.layers()) {
    const double weight = layer.density() * kStandardGravity;
    const Linear yy{vertical - weight * top, weight};
    const Linear horizontal{layer.k0() * yy.at_zero, layer.k0() * weight};
    pieces_.push_back({layer.bottom(), weight, layer.k0(), horizontal, yy, {}, horizontal});
    vertical = yy.at(layer.bottom());
    top = layer.bottom();
  }
}

void StatedStress::read_sea(const scene::Water& water) {
  water_ = water;
  for (int i = 0; i < water.places_size(); ++i) {
    const scene::WaterPlace& place = water.places(i);
    if (place.stage() == 0 && place.has_level() && !place.where().has_group())
      seas_.push_back({Places(place.where(), fmt::format("water.places[{}].where", i), 1e-9), place.level()});
  }
}

double StatedStress::load_on(double x, double y) const {
  if (!water_) return surcharge_;
  double level = water_->level();
  for (const auto& [where, of_place] : seas_)
    if (where.hold(x, y)) level = of_place;
  return surcharge_ + pressure_at_rest(*water_, level, y);
}

const StatedStress::Piece& StatedStress::piece_at(double y) const {
  const auto found = std::ranges::find_if(pieces_, [&](const Piece& p) { return y >= p.bottom; });
  return found != pieces_.end() ? *found : pieces_.back();
}

GroundStress StatedStress::below_line(double x, double y) const {
  const auto right = std::ranges::upper_bound(line_, x, {}, &std::pair<double, double>::first);
  double above = right == line_.begin() ? right->second : std::prev(right)->second;
  if (right != line_.begin() && right != line_.end()) {
    const auto [x0, y0] = *std::prev(right);
    above = std::lerp(y0, right->second, (x - x0) / (right->first - x0));
  }
  const double height = std::min(y, above);
  double vertical = -load_on(x, above), horizontal = 0;
  for (const Piece& layer : pieces_) {
    const bool last = &layer == &pieces_.back() || height >= layer.bottom;
    const double lower = last ? height : layer.bottom;
    if (lower < above) {
      vertical -= layer.weight * (above - lower);
      above = lower;
    }
    horizontal = layer.k0 * vertical;
    if (last) break;
  }
  return {horizontal, vertical, 0, horizontal};
}

GroundStress StatedStress::at(double x, double y, double pore_pressure) const {
  GroundStress stress = line_.empty() ? below_level(y) : below_line(x, y);
  if (surface_ == kInfinity || pore_pressure == 0) return stress;
  // k0 (yy + p) - p
  const double k0 = piece_at(y).k0;
  stress.xx += (k0 - 1) * pore_pressure;
  stress.zz = *stress.zz + (k0 - 1) * pore_pressure;
  return stress;
}

GroundStress StatedStress::below_level(double y) const {
  const double height = std::min(y, surface_);
  const Piece& piece = piece_at(height);
  GroundStress stress{piece.xx.at(height), piece.yy.at(height), piece.xy.at(height), {}};
  if (piece.zz) stress.zz = piece.zz->at(height);
  return stress;
}

}  // namespace adit::protocol
