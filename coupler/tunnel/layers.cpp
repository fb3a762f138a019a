#include "coupler/tunnel/layers.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "coupler/tunnel/joints.hpp"
#include "coupler/tunnel/parts.hpp"
#include "protocol/errors.hpp"
#include "protocol/materials/read_concrete.hpp"
#include "protocol/sections/read_section.hpp"

namespace adit::coupler {
namespace {

using protocol::require;
using protocol::UserError;

// Of the section's concrete: its stiffness, with the weight that linings have if nothing else is stated, and
// for particles how it breaks.
scene::Material material_of(const scene::ReinforcedSection& section, bool breaks, const std::string& path) {
  const auto [young_modulus, compressive, tensile, factor] =
      protocol::read_concrete(section.concrete(), protocol::values_of(section.values()), path + ".concrete");
  scene::Material material;
  material.set_young_modulus(young_modulus);
  const scene::Lining lining;
  material.set_poisson_ratio(lining.poisson_ratio());
  material.set_density(lining.density());
  if (!breaks) return material;
  scene::Fracture& fracture = *material.mutable_fracture();
  fracture.set_tensile_strength(tensile);
  fracture.set_compressive_strength(compressive);
  fracture.set_fracture_energy(protocol::fracture_energy(compressive));
  return material;
}

// The lining itself, or one of its layers.
template <class Stated>
LiningLayer read_layer(const Stated& stated, bool breaks, const std::string& path, std::string name,
                       std::uint32_t stage) {
  LiningLayer layer{path, std::move(name), 0, {}, nullptr, nullptr, stage};
  if (stated.has_interface()) layer.interface = &stated.interface();
  if (!stated.has_section()) {
    require(stated.has_thickness() && stated.has_material(), path,
            fmt::format("has no {}; give `thickness` and `material`, or a `section`",
                        stated.has_thickness() ? "material" : "thickness"));
    layer.thickness = stated.thickness();
    layer.material = stated.material();
    return layer;
  }
  for (const auto& [given, key] :
       {std::pair{stated.has_thickness(), ".thickness"}, std::pair{stated.has_material(), ".material"}})
    require(!given, path + key, "is given beside `section`, which states it; leave one out");
  layer.section = &stated.section();
  layer.thickness = stated.section().thickness();
  layer.material = material_of(stated.section(), breaks, path + ".section");
  return layer;
}

std::vector<LiningLayer> read_layers(const scene::LinedTunnel& tunnel, const std::string& path) {
  const scene::TunnelLining& lining = tunnel.lining();
  const std::string here = path + ".lining";
  std::uint32_t stage = stage_of_lining(tunnel);
  if (lining.layers().empty())
    return {read_layer(lining, of_cells(tunnel) && !lining.section().elastic(), here, tunnel.name(), stage)};
  for (const auto& [given, key] :
       {std::pair{lining.has_thickness(), ".thickness"}, std::pair{lining.has_material(), ".material"},
        std::pair{lining.has_section(), ".section"}, std::pair{lining.has_interface(), ".interface"}})
    require(!given, here + key, "is given beside `layers`, each of which states its own; leave one out");
  std::vector<LiningLayer> layers;
  for (int i = 0; i < lining.layers_size(); ++i) {
    const scene::TunnelLayer& layer = lining.layers(i);
    if (layer.has_stage()) stage = layer.stage();
    layers.push_back(read_layer(layer, false, fmt::format("{}.layers[{}]", here, i),
                                fmt::format("{}_{}", tunnel.name(), layer.name()), stage));
    if (stage > 0) ++stage;
  }
  return layers;
}

// Keys that speak of one model of linings alone.
struct OwnKey {
  bool given;
  const char *key, *instead;
};

template <class Keys>
void refuse(const Keys& keys, const std::string& path, const char* model) {
  for (const auto& [given, key, instead] : keys)
    require(!given, path + key,
            fmt::format("is given, but the lining is of {}; leave it out{}", model, instead));
}

void require_of_particles(const scene::LinedTunnel& tunnel, const std::string& path) {
  const scene::TunnelLining& lining = tunnel.lining();
  require(tunnel.has_particles(), path,
          "has a lining of particles, but no `particles`; state them, or give `lining.as: beam`");
  refuse(
      std::initializer_list<OwnKey>{
          {tunnel.has_zones(), ".zones", ""},
          {lining.has_interface(), ".lining.interface", ", or give `friction` or `to_ground`"},
          {lining.layers_size() > 0, ".lining.layers", ", or give `as: beam` or `as: zones`"},
          {lining.has_contact(), ".lining.contact", ", or give `as: beam`"},
          {lining.has_second_ring(), ".lining.second_ring", ", or give `as: beam`"}},
      path, "particles");
  if (!lining.has_section()) return;
  const std::string at = path + ".lining.section";
  require(of_cells(tunnel), at,
          "states how concrete breaks, which a lattice of discs does not follow; give `particles.size` for "
          "cells, or `thickness`, `material` and `bonds`");
  sections::read_section(lining.section(), 1, at);
  require(!lining.has_bonds(), path + ".lining.bonds",
          "is given beside `section`, whose concrete states how it breaks; leave one out");
  require(!lining.section().concrete().has_fibres(), at + ".concrete.fibres",
          "is given, but the lining is of particles, which break as plain concrete; give `as: beam`");
  require(
      !lining.section().concrete().has_tension_stiffening(), at + ".concrete.tension_stiffening",
      "is given, but the lining is of particles, where it follows from the bond of the bars; leave it out");
}

void require_in_grid(const scene::LinedTunnel& tunnel, const std::string& path, const char* model) {
  const scene::TunnelLining& lining = tunnel.lining();
  refuse(
      std::initializer_list<OwnKey>{
          {tunnel.has_particles(), ".particles", ", or give `lining.as: particles`"},
          {lining.has_bonds(), ".lining.bonds", ", or give `as: particles`"},
          {lining.has_keys(), ".lining.keys", ", or give `as: particles`"},
          {lining.has_neighbours(), ".lining.neighbours", ", or give `as: particles`"},
          {lining.has_friction(), ".lining.friction", ", or give an `interface`"},
          {lining.has_to_ground(), ".lining.to_ground", "; without `interface` it is tied to the ground"}},
      path, model);
}

void require_of_beams(const scene::LinedTunnel& tunnel, const std::vector<LiningLayer>& layers,
                      const std::string& path) {
  require_in_grid(tunnel, path, "beams");
  for (const LiningLayer& layer : layers) {
    const scene::Material& material = layer.material;
    require(!material.has_mohr_coulomb() && !material.has_hysteretic() && !material.has_weak_plane() &&
                !material.has_fracture(),
            layer.path + ".material",
            "has a law beyond elasticity, but the lining is of beams; give a `section` of reinforced "
            "concrete, or the elastic constants alone");
  }
  require_joints_possible(tunnel, path);
  require_second_ring_possible(tunnel.lining(), path);
  require(layers.size() == 1 || joint_angles(tunnel.lining()).empty(), path + ".lining.layers",
          "are given beside joints of segments, which belong to a lining of one layer; leave one out");
}

void require_of_zones(const scene::LinedTunnel& tunnel, const std::vector<LiningLayer>& layers,
                      const std::string& path) {
  require_in_grid(tunnel, path, "zones");
  require(joint_angles(tunnel.lining()).empty() && !tunnel.lining().has_second_ring(), path + ".lining",
          "has joints of segments, which zones do not have; give `as: beam` or `as: particles`");
  std::uint32_t before = tunnel.stage();
  for (const LiningLayer& layer : layers) {
    require(layer.stage >= before, layer.path + ".stage",
            fmt::format("is {}, but what lies outside the layer comes in stage {}; give at least that",
                        layer.stage, before));
    before = layer.stage;
    require(layer.stage == 0 || layer.interface == nullptr, layer.path + ".interface",
            fmt::format(
                "is given, but zones that come into being in stage {} are tied to what lies outside them; "
                "leave it out, or give `as: beam`",
                layer.stage));
  }
}

}  // namespace

bool resists(const scene::ReinforcedSection* section) {
  return section != nullptr && (section->has_steel() || section->concrete().has_fibres());
}

std::vector<LiningLayer> layers_of(const scene::LinedTunnel& tunnel, const std::string& path) {
  if (tunnel.lining().as() == scene::TunnelLining::PARTICLES) require_of_particles(tunnel, path);
  std::vector<LiningLayer> layers = read_layers(tunnel, path);
  if (tunnel.lining().as() == scene::TunnelLining::BEAM) require_of_beams(tunnel, layers, path);
  if (tunnel.lining().as() == scene::TunnelLining::ZONES) require_of_zones(tunnel, layers, path);
  return layers;
}

}  // namespace adit::coupler
