#include "protocol/scene/fill_in_concrete.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/materials/read_concrete.hpp"
#include "protocol/scene/fields/path.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::DynamicCastToGenerated;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// What the class states of a material; not its compressive strength where that follows from a cohesion.
scene::Material as_material(const Concrete& concrete, bool breaks, bool has_cohesion) {
  scene::Material material;
  material.set_young_modulus(concrete.young_modulus);
  material.set_poisson_ratio(Concrete::kPoissonRatio);
  material.set_density(Concrete::kDensity);
  if (!breaks) return material;
  material.mutable_fracture()->set_tensile_strength(concrete.tensile_strength);
  material.mutable_fracture()->set_fracture_energy(concrete.fracture_energy);
  if (!has_cohesion) material.mutable_fracture()->set_compressive_strength(concrete.compressive_strength);
  return material;
}

void fill_in(scene::Material& material, const std::string& path, bool breaks) {
  if (!material.has_concrete()) return;
  const std::string here = member_path(path, "concrete");
  scene::Material filled =
      as_material(concrete_named(material.concrete(), here), breaks, material.fracture().has_cohesion());
  material.clear_concrete();
  filled.MergeFrom(material);
  if (filled.SerializeAsString() == material.SerializeAsString())
    throw UserError(here,
                    "states nothing, because the material states all of its numbers itself; leave it out, or "
                    "leave out the keys that it shall stand for");
  material = std::move(filled);
}

bool of_cells(const scene::LinedTunnel& tunnel) {
  return tunnel.particles().has_size();
}

// `breaks`: whether cells take the materials within, or zones, which tell how much of its strength they use.
void fill_in_all(Message& message, const std::string& path, bool breaks) {
  if (auto* material = DynamicCastToGenerated<scene::Material>(&message))
    return fill_in(*material, path, breaks);
  if (const auto* particles = DynamicCastToGenerated<scene::Particles>(&message))
    breaks = particles->has_cells();
  else if (const auto* tunnel = DynamicCastToGenerated<scene::LinedTunnel>(&message))
    breaks = of_cells(*tunnel) || tunnel->lining().as() == scene::TunnelLining::ZONES;
  else if (DynamicCastToGenerated<scene::Continuum>(&message))
    breaks = true;
  const auto& get = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  get.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const std::string here = member_path(path, field->name());
    if (!field->is_repeated())
      fill_in_all(*get.MutableMessage(&message, field), here, breaks);
    else
      for (int i = 0; i < get.FieldSize(message, field); ++i)
        fill_in_all(*get.MutableRepeatedMessage(&message, field, i),
                    element_path(here, static_cast<std::size_t>(i)), breaks);
  }
}

bool has_particles(const scene::Scene& scene) {
  return scene.has_particles() ||
         std::ranges::any_of(scene.regions(), [](const auto& one) { return one.has_particles(); }) ||
         std::ranges::any_of(scene.tunnels(), [](const auto& one) { return one.has_particles(); });
}

bool has_cells(const scene::Scene& scene) {
  return scene.particles().has_cells() ||
         std::ranges::any_of(scene.regions(), [](const auto& one) { return one.particles().has_cells(); }) ||
         std::ranges::any_of(scene.tunnels(), of_cells);
}

}  // namespace

void fill_in_concrete(scene::Scene& scene) {
  fill_in_all(scene, "", has_cells(scene) || !has_particles(scene));
}

}  // namespace adit::protocol
