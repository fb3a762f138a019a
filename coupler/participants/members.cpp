#include "coupler/participants/members.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

const scene::Region* region_of(const scene::Scene& scene, const Member& member) {
  for (const scene::Region& region : scene.regions())
    if (region.name() == member.name) return &region;
  return nullptr;
}

bool has_own_material(const scene::Scene& scene, const Member& member) {
  return member.role == Role::kContinuum ? continuum_of(scene, member).has_material()
                                         : particles_of(scene, member).has_material();
}

void add(std::vector<Member>& members, Member member, const std::string& name_path) {
  for (const Member& other : members)
    if (other.name == member.name)
      throw UserError(name_path, fmt::format("is `{}`, which {} is called already; choose another name",
                                             member.name, other.path));
  members.push_back(std::move(member));
}

std::size_t find(const std::vector<Member>& members, const std::string& name, const std::string& path) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].name == name) return i;
    names.push_back(members[i].name);
  }
  throw UserError(path, fmt::format("joins `{}`, but the scene has no model of this name; it has `{}`", name,
                                    fmt::join(names, "`, `")));
}

void require_all_joined(const std::vector<Member>& members, const std::vector<Join>& joins,
                        const scene::Scene& scene) {
  std::vector<bool> joined(members.size(), false);
  joined[0] = true;
  for (std::size_t round = 0; round < joins.size(); ++round)
    for (const Join& join : joins)
      if (joined[join.outer] || joined[join.inner]) joined[join.outer] = joined[join.inner] = true;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (!joined[i])
      throw UserError(scene.has_interface() ? "interfaces" : "interface",
                      fmt::format("is missing between `{}` and `{}`; state the overlap that joins them",
                                  members[0].name, members[i].name));
}

}  // namespace

const scene::Continuum& continuum_of(const scene::Scene& scene, const Member& member) {
  const scene::Region* region = region_of(scene, member);
  return region ? region->continuum() : scene.continuum();
}

const char* to_string(Role role) {
  return role == Role::kContinuum ? "continuum" : "particles";
}

std::vector<Member> members(const scene::Scene& scene) {
  if (scene.has_simplified())
    throw UserError("simplified", "is computed by the program `simplified`, not by `coupler`");
  std::vector<Member> members;
  if (scene.has_continuum()) members.push_back({"continuum", Role::kContinuum, "continuum"});
  if (scene.has_particles()) members.push_back({"particles", Role::kParticles, "particles"});
  for (int i = 0; i < scene.regions_size(); ++i) {
    const scene::Region& region = scene.regions(i);
    const std::string path = fmt::format("regions[{}]", i);
    if (!region.has_continuum() && !region.has_particles())
      throw UserError(path, "has no model; give it `continuum` or `particles`");
    const bool plain = std::all_of(region.name().begin(), region.name().end(),
                                   [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
    if (region.name().empty() || !plain || region.name() == "continuum" || region.name() == "particles")
      throw UserError(path + ".name",
                      fmt::format("is `{}`; give it a name of its own from letters, digits, `_` "
                                  "and `-`, which is none of the scene's keys",
                                  region.name()));
    const Role role = region.has_continuum() ? Role::kContinuum : Role::kParticles;
    add(members, {region.name(), role, path + "." + to_string(role)}, path + ".name");
  }
  if (members.empty())
    throw UserError("continuum", "is missing, and so is `particles`; give at least one of them");
  for (const Member& member : members) {
    if (!has_own_material(scene, member) && !scene.has_material())
      throw UserError("material",
                      "is missing; write for example `material: {young_modulus: 30 GPa, poisson_ratio: 0.25, "
                      "density: 2.5 t/m^3}`");
  }
  return members;
}

std::vector<Join> joins(const scene::Scene& scene, const std::vector<Member>& members) {
  std::vector<Join> joins;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  const auto add_join = [&](const scene::Interface& interface, const std::string& path) {
    const std::size_t outer = find(members, interface.outer(), path);
    const std::size_t inner = find(members, interface.inner(), path);
    if (outer == inner)
      throw UserError(path + ".inner",
                      fmt::format("is `{}`, like `outer`; an interface joins two models", interface.inner()));
    if (!pairs.insert(std::minmax(outer, inner)).second)
      throw UserError(path, fmt::format("joins `{}` and `{}` a second time; join them once, by an overlap "
                                        "`around` the inner one",
                                        interface.outer(), interface.inner()));
    if (scene.has_statics() && interface.solve() == scene::LUMPED)
      throw UserError(path + ".solve",
                      "is `lumped`, under which models creep apart while a load lasts; choose "
                      "`consistent` or `split` for a scene with `statics`");
    joins.push_back({outer, inner, &interface, path});
  };
  if (scene.has_interface()) add_join(scene.interface(), "interface");
  for (int i = 0; i < scene.interfaces_size(); ++i)
    add_join(scene.interfaces(i), fmt::format("interfaces[{}]", i));
  require_all_joined(members, joins, scene);
  return joins;
}

const scene::Particles& particles_of(const scene::Scene& scene, const Member& member) {
  const scene::Region* region = region_of(scene, member);
  return region ? region->particles() : scene.particles();
}

scene::Scene part_of(const scene::Scene& scene, const Member& member) {
  scene::Scene part = scene;
  part.clear_extends();
  part.clear_continuum();
  part.clear_particles();
  part.clear_regions();
  part.clear_interface();
  part.clear_interfaces();
  part.clear_output();
  part.clear_questions();
  part.clear_accuracy();
  if (member.role == Role::kContinuum)
    *part.mutable_continuum() = continuum_of(scene, member);
  else
    *part.mutable_particles() = particles_of(scene, member);
  return part;
}

const google::protobuf::RepeatedPtrField<scene::History>& histories_of(const scene::Scene& scene,
                                                                       const Member& member) {
  return member.role == Role::kContinuum ? continuum_of(scene, member).histories()
                                         : particles_of(scene, member).histories();
}

}  // namespace adit::coupler
