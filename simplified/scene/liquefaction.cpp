#include "simplified/scene/liquefaction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/ground/stated_stress.hpp"
#include "simplified/column/pore_pressure.hpp"
#include "simplified/scene/ground.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {
namespace {

using protocol::kStandardGravity;
using protocol::UserError;

constexpr double kWater = 1000;  // density [kg/m^3]

// The effective vertical pressure at rest [Pa].
double effective_pressure(const scene::SoilProfile& profile, double depth, double water_depth) {
  double mass = 0, top = 0;
  for (const scene::Layer& layer : profile.layers()) {
    mass += layer.density() * std::clamp(depth - top, 0.0, layer.thickness());
    top += layer.thickness();
  }
  return kStandardGravity * (mass - kWater * std::max(0.0, depth - water_depth));
}

// The share of the section's height that lies within the sand; that of the lowest layer continues below its
// bottom.
double share_of_height(const scene::Simplified& scene, double chainage, int layer) {
  const scene::SoilProfile profile = profile_at(scene.ground(), chainage);
  const std::optional<WetSand> sand = wet_sand(scene.ground(), profile, layer);
  if (!sand) return 0;
  const Heights tunnel = heights(scene.tunnel(), chainage, section_at(scene.tunnel(), chainage));
  const double bottom =
      layer + 1 == profile.layers_size() ? tunnel.bottom : std::min(tunnel.bottom, sand->bottom);
  return std::max(0.0, bottom - std::max(tunnel.top, sand->top)) / (tunnel.bottom - tunnel.top);
}

}  // namespace

std::vector<int> liquefiable_layers(const scene::Ground& ground) {
  std::vector<int> layers;
  for (int i = 0; i < ground.profiles(0).layers_size(); ++i)
    if (std::ranges::any_of(ground.profiles(), [i](const auto& p) { return p.layers(i).has_liquefaction(); }))
      layers.push_back(i);
  return layers;
}

bool may_liquefy(const scene::Simplified& scene) {
  return scene.has_ground() && !liquefiable_layers(scene.ground()).empty();
}

void check_liquefaction(const scene::Simplified& scene) {
  if (!may_liquefy(scene)) return;
  if (!scene.ground().has_water_depth())
    throw UserError("simplified.ground.water_depth",
                    "is missing, but a layer states `liquefaction`, which needs the water table; write for "
                    "example `water_depth: 2 m`");
  if (!scene.excitation().through_ground())
    throw UserError(
        "simplified.excitation.through_ground",
        "must be true where a layer states `liquefaction`, because its pore pressure follows from the "
        "shear stress in the soil columns");
  for (int p = 0; p < scene.ground().profiles_size(); ++p)
    for (const int layer : liquefiable_layers(scene.ground()))
      if (const auto sand = wet_sand(scene.ground(), scene.ground().profiles(p), layer);
          sand && !(sand->resistance > 0))
        throw UserError(fmt::format("simplified.ground.profiles[{}].layers[{}].density", p, layer),
                        fmt::format("leaves no effective pressure at {:g} m below the water table; give the "
                                    "densities of saturated ground, which are above the {:g} kg/m^3 of water",
                                    sand->middle(), kWater));
}

std::optional<WetSand> wet_sand(const scene::Ground& ground, const scene::SoilProfile& profile, int layer) {
  if (!profile.layers(layer).has_liquefaction()) return std::nullopt;
  double top = 0;
  for (int i = 0; i < layer; ++i) top += profile.layers(i).thickness();
  const double bottom = top + profile.layers(layer).thickness();
  top = std::max(top, ground.water_depth());
  if (top >= bottom) return std::nullopt;
  const scene::Liquefaction& law = profile.layers(layer).liquefaction();
  const double pressure = effective_pressure(profile, (top + bottom) / 2, ground.water_depth());
  return WetSand{top, bottom, law.cyclic_resistance() * pressure, law.exponent()};
}

void raise_pressure(const scene::Simplified& scene, GroundField& field) {
  const std::size_t places = field.chainage.size();
  const double axial = scene.excitation().axial(), lateral = scene.excitation().lateral();
  const std::array<double, 2> factors = {axial, lateral};  // of kAxial and kLateral
  for (std::size_t k = 0; k < field.pressure.size(); ++k) {
    LayerPressure& layer = field.pressure[k];
    for (std::size_t j = 0; j < places; ++j) {
      const auto sand = wet_sand(scene.ground(), profile_at(scene.ground(), field.chainage[j]), layer.number);
      if (!sand) continue;
      column::PorePressure pressure(sand->resistance, sand->exponent);
      for (std::size_t at = j; at < layer.ratio.size(); at += places) {
        double stress = 0;
        for (const Direction d : {kAxial, kLateral})
          if (factors[d] != 0)
            stress += factors[d] / std::hypot(axial, lateral) * field.shaking[d].stress[k][at];
        pressure.follow(stress);
        layer.ratio[at] = pressure.ratio();
      }
    }
  }
}

std::vector<double> pressure_at_tunnel(const scene::Simplified& scene, const GroundField& field) {
  const std::size_t places = field.chainage.size();
  std::vector<double> mean(field.pressure.front().ratio.size());
  for (const LayerPressure& layer : field.pressure)
    for (std::size_t j = 0; j < places; ++j) {
      const double share = share_of_height(scene, field.chainage[j], layer.number);
      for (std::size_t at = j; at < mean.size(); at += places) mean[at] += share * layer.ratio[at];
    }
  return mean;
}

double uplift(const scene::Simplified& scene, double chainage, const scene::Section& section) {
  const Heights tunnel = heights(scene.tunnel(), chainage, section);
  const double density = mean_over(profile_at(scene.ground(), chainage), tunnel,
                                   [](const scene::Layer& layer) { return layer.density(); });
  return kStandardGravity * (density * section.width() * section.height() - section.mass());
}

}  // namespace adit::simplified
