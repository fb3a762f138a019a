#include "simplified/scene/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "simplified/scene/along_chainage.hpp"

namespace adit::simplified {
namespace {

using protocol::UserError;

double wave_velocity(const scene::Layer& layer, Direction direction) {
  const double nu = layer.poisson_ratio();
  // V_p^2 = V_s^2 * 2 (1 - nu) / (1 - 2 nu) of an elastic medium.
  return direction == kVertical ? layer.shear_velocity() * std::sqrt(2 * (1 - nu) / (1 - 2 * nu))
                                : layer.shear_velocity();
}

// The modulus that resists the difference between neighbouring columns over that of the columns' own waves.
double modulus_ratio(double nu, Direction direction) {
  switch (direction) {
    case kAxial:
      return column::axial_modulus_ratio(nu);
    case kVertical:
      return (1 - 2 * nu) / (2 * (1 - nu));  // (V_s/V_p)^2
    case kLateral:
      break;
  }
  return 1;
}

column::Deposit deposit(const scene::Ground& ground, double chainage, Direction direction) {
  column::Deposit deposit;
  const scene::SoilProfile profile = profile_at(ground, chainage);
  for (const scene::Layer& layer : profile.layers())
    deposit.layers.push_back({.thickness = layer.thickness(),
                              .density = layer.density(),
                              .wave_velocity = wave_velocity(layer, direction),
                              .damping = layer.damping_ratio(),
                              .modulus_ratio = modulus_ratio(layer.poisson_ratio(), direction)});
  if (ground.has_rock()) {
    // Rock is assumed to have Poisson's ratio 1/4, for which V_p = sqrt(3) V_s.
    const double factor = direction == kVertical ? std::numbers::sqrt3 : 1.0;
    deposit.rock = column::Rock{ground.rock().density(), factor * ground.rock().shear_velocity(),
                                modulus_ratio(0.25, direction)};
  }
  return deposit;
}

// G (1 - nu) / (3 - 4 nu)
double spring_modulus(const scene::Layer& layer) {
  const double nu = layer.poisson_ratio();
  const double modulus = layer.density() * layer.shear_velocity() * layer.shear_velocity();
  return modulus * (1 - nu) / (3 - 4 * nu);
}

void blend_liquefaction(scene::Layer& layer, const scene::Layer& other, const Bracket& at) {
  const auto weakness = [](const scene::Layer& of) {
    return of.has_liquefaction() ? 1 / of.liquefaction().cyclic_resistance() : 0;
  };
  const double blended = at.blend(weakness(layer), weakness(other));
  if (blended == 0) return layer.clear_liquefaction();
  const double exponent = !layer.has_liquefaction() ? other.liquefaction().exponent()
                          : !other.has_liquefaction()
                              ? layer.liquefaction().exponent()
                              : at.blend(layer.liquefaction().exponent(), other.liquefaction().exponent());
  layer.mutable_liquefaction()->set_cyclic_resistance(1 / blended);
  layer.mutable_liquefaction()->set_exponent(exponent);
}

}  // namespace

void check(const scene::Ground& ground) {
  for (int i = 1; i < ground.profiles_size(); ++i) {
    const auto &before = ground.profiles(i - 1), &profile = ground.profiles(i);
    const std::string path = fmt::format("simplified.ground.profiles[{}]", i);
    if (!(profile.chainage() > before.chainage()))
      throw UserError(path + ".chainage", fmt::format("is {:g} m, not beyond the profile before it at {:g} m",
                                                      profile.chainage(), before.chainage()));
    if (profile.layers_size() != before.layers_size())
      throw UserError(
          path + ".layers",
          fmt::format("are {}, but the profile before it has {}; layers are interpolated one by one, so give "
                      "all profiles the same number (a thin layer where one ends)",
                      profile.layers_size(), before.layers_size()));
  }
}

scene::SoilProfile profile_at(const scene::Ground& ground, double chainage) {
  const Bracket at = bracket(ground.profiles(), chainage);
  const scene::SoilProfile& after = ground.profiles(at.after);
  scene::SoilProfile profile = ground.profiles(at.before);
  profile.set_chainage(chainage);
  for (int i = 0; i < profile.layers_size(); ++i) {
    scene::Layer& layer = *profile.mutable_layers(i);
    const scene::Layer& other = after.layers(i);
    layer.set_thickness(at.blend(layer.thickness(), other.thickness()));
    layer.set_shear_velocity(at.blend(layer.shear_velocity(), other.shear_velocity()));
    layer.set_density(at.blend(layer.density(), other.density()));
    layer.set_poisson_ratio(at.blend(layer.poisson_ratio(), other.poisson_ratio()));
    layer.set_damping_ratio(at.blend(layer.damping_ratio(), other.damping_ratio()));
    blend_liquefaction(layer, other, at);
  }
  return profile;
}

std::vector<column::Column> columns(const scene::Ground& ground, double begin, double end,
                                    Direction direction) {
  const int gaps = static_cast<int>(std::ceil((end - begin) / ground.column_spacing() - 1e-9));
  std::vector<column::Column> columns;
  for (int i = 0; i <= gaps; ++i) {
    const double chainage = gaps == 0 ? begin : begin + (end - begin) * i / gaps;
    columns.push_back({chainage, deposit(ground, chainage, direction), ground.modes()});
  }
  return columns;
}

double mean_over(const scene::SoilProfile& profile, Heights heights,
                 const std::function<double(const scene::Layer&)>& value) {
  const auto [top, bottom] = heights;
  double sum = 0, begin = 0;
  for (const scene::Layer& layer : profile.layers()) {
    const bool lowest = &layer == &*profile.layers().rbegin();
    // The profile ends at the rock, and a tunnel may reach below it.
    const double end = lowest ? bottom : std::min(bottom, begin + layer.thickness());
    sum += std::max(0.0, end - std::max(begin, top)) * value(layer);
    begin += layer.thickness();
  }
  return sum / (bottom - top);
}

SoilStiffness soil_stiffness(const scene::Simplified& scene, double chainage, const scene::Section& section) {
  const scene::SoilSprings& given = scene.soil_springs();
  if (given.has_axial() && given.has_lateral() && given.has_vertical())
    return {given.axial(), given.lateral(), given.vertical()};
  if (!scene.has_ground())
    throw UserError(
        "simplified.soil_springs",
        "does not give all of `axial`, `lateral` and `vertical`, and there is no `ground` from which to "
        "derive the others; give them or the ground");
  if (!given.has_wavelength())
    throw UserError(
        "simplified.soil_springs",
        "needs `wavelength` to derive the stiffnesses that are not given; write for example `wavelength: "
        "400 m`");
  const double modulus = mean_over(profile_at(scene.ground(), chainage),
                                   heights(scene.tunnel(), chainage, section), spring_modulus);
  const double derived = 16 * std::numbers::pi * modulus * section.width() / given.wavelength();
  return {given.has_axial() ? given.axial() : derived, given.has_lateral() ? given.lateral() : derived,
          given.has_vertical() ? given.vertical() : derived};
}

}  // namespace adit::simplified
