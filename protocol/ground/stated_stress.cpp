#include "protocol/ground/stated_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool has_components(const scene::Stress& s) {
  return s.has_xx() || s.has_yy() || s.has_xy() || s.has_zz() || s.has_xx_per_metre() ||
         s.has_yy_per_metre() || s.has_zz_per_metre();
}

void check(const scene::Stress& stress) {
  if (stress.layers().empty()) {
    if (stress.has_surface() || stress.has_surcharge())
      throw UserError(stress.has_surface() ? "initial_stress.surface" : "initial_stress.surcharge",
                      "is given without layers; add them to initial_stress.layers, or leave it out");
    return;
  }
  if (has_components(stress))
    throw UserError("initial_stress.layers",
                    "are given beside components of the stress; give either the layers or the components");
  double above = stress.surface();
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

StatedStress::StatedStress(const scene::Stress& stress)
    : surface_(stress.layers().empty() ? kInfinity : stress.surface()) {
  check(stress);
  if (stress.layers().empty()) {
    Piece piece{-kInfinity,
                {stress.xx(), stress.xx_per_metre()},
                {stress.yy(), stress.yy_per_metre()},
                {stress.xy(), 0},
                {}};
    if (stress.has_zz() || stress.has_zz_per_metre()) piece.zz = Linear{stress.zz(), stress.zz_per_metre()};
    pieces_.push_back(piece);
    return;
  }
  double top = surface_, vertical = -stress.surcharge();
  for (const scene::GroundLayer& layer : stress.layers()) {
    const double weight = layer.density() * kStandardGravity;
    const Linear yy{vertical - weight * top, weight};
    const Linear horizontal{layer.k0() * yy.at_zero, layer.k0() * weight};
    pieces_.push_back({layer.bottom(), horizontal, yy, {}, horizontal});
    vertical = yy.at(layer.bottom());
    top = layer.bottom();
  }
}

GroundStress StatedStress::at(double y) const {
  const double height = std::min(y, surface_);
  const auto found = std::ranges::find_if(pieces_, [&](const Piece& p) { return height >= p.bottom; });
  const Piece& piece = found != pieces_.end() ? *found : pieces_.back();
  GroundStress stress{piece.xx.at(height), piece.yy.at(height), piece.xy.at(height), {}};
  if (piece.zz) stress.zz = piece.zz->at(height);
  return stress;
}

}  // namespace adit::protocol
