#include "dem_server/model/placement/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

constexpr int kMostGroups = 1000;

std::string group_path(int number) {
  return "particles.groups[" + std::to_string(number) + "]";
}

Group own_group(const scene::Scene& scene) {
  const auto& p = scene.particles();
  const bool bonded = p.has_bonds() || !p.has_contacts();
  return {kOwnGroup,
          checked_material(scene),
          bonded ? &p.bonds() : nullptr,
          "particles.bonds",
          &p.contacts(),
          "particles.contacts",
          plane_of(scene),
          p.has_cells()};
}

MaterialAt own_material(const scene::ParticleGroup& scene, const std::string& path, const Group& own) {
  MaterialAt at{scene.material(), path + ".material"};
  const auto* bonds = scene.has_bonds() ? &scene.bonds() : own.bonds;
  require_usable(at, bonds != nullptr ? *bonds : scene::Bonds::default_instance(), own.cells);
  return at;
}

Group read_group(const scene::ParticleGroup& scene, const std::string& path, const Group& own) {
  return {scene.name(),
          scene.has_material() ? own_material(scene, path, own) : own.material,
          scene.has_bonds() ? &scene.bonds() : own.bonds,
          scene.has_bonds() ? path + ".bonds" : own.bonds_path,
          scene.has_contacts() ? &scene.contacts() : own.contacts,
          scene.has_contacts() ? path + ".contacts" : own.contacts_path,
          own.plane,
          own.cells};
}

// Whether the ring selects the particles of this group.
bool is_lining(const scene::Particles& particles, const scene::ParticleGroup& group) {
  return particles.ring().within_ground() && group.name() == kLining;
}

std::uint32_t lining_group(const scene::Particles& particles) {
  const auto& groups = particles.groups();
  const auto given = std::ranges::find(groups, kLining, [](const auto& group) { return group.name(); });
  return static_cast<std::uint32_t>(given - groups.begin()) + 1;
}

scene::Area lining_area(const scene::SegmentRing& ring) {
  scene::Area area;
  *area.mutable_annulus()->mutable_centre() = ring.centre();
  area.mutable_annulus()->set_inner_radius(ring.inner_radius());
  area.mutable_annulus()->set_outer_radius(ring.outer_radius());
  return area;
}

}  // namespace

BondStiffness Group::stiffness() const {
  if (cells) {
    // That of a facet of a regular hexagon: E' A / h, A / h = 1 / sqrt(3).
    const double k =
        cell_elasticity(material.material.young_modulus(), material.material.poisson_ratio(), plane)
            .stiffness /
        std::numbers::sqrt3;
    return {k, k};
  }
  return checked_stiffness(bonds != nullptr ? *bonds : scene::Bonds::default_instance(),
                           bonds != nullptr ? bonds_path : contacts_path, material, plane);
}

LinearContact Group::contact() const {
  return read_contact(*contacts, [this] { return stiffness(); });
}

std::vector<Group> read_groups(const scene::Scene& scene) {
  if (const int groups = scene.particles().groups_size(); groups > kMostGroups)
    throw UserError("particles.groups",
                    fmt::format("has {} groups; at most {} can be computed, because each two have a law of "
                                "contact",
                                groups, kMostGroups));
  std::vector<Group> groups{own_group(scene)};
  std::vector<std::string> names{kOwnGroup};
  for (int k = 0; k < scene.particles().groups_size(); ++k) {
    const auto& group = scene.particles().groups(k);
    const std::string path = group_path(k);
    if (std::ranges::find(names, group.name()) != names.end())
      throw UserError(path + ".name",
                      group.name() == kOwnGroup
                          ? "is that of the particles outside all groups; choose another"
                          : fmt::format("is {}, as that of an earlier group; give each its own",
                                        protocol::quote(group.name())));
    if (is_lining(scene.particles(), group)) {
      if (group.has_where() || group.has_number())
        throw UserError(path,
                        "selects its particles, which are those of the ring; leave out `where` and `number`");
    } else if (group.has_where() == group.has_number())
      throw UserError(path, "selects its particles by one of `where` and `number`; give exactly one");
    names.push_back(group.name());
    groups.push_back(read_group(group, path, groups.front()));
  }
  if (scene.particles().ring().within_ground() && std::ranges::find(names, kLining) == names.end()) {
    groups.push_back(groups.front());
    groups.back().name = kLining;
  }
  return groups;
}

LinearContact read_contact(const scene::ParticleContacts& contacts,
                           const std::function<BondStiffness()>& otherwise) {
  BondStiffness stiffness{contacts.normal_stiffness(), contacts.shear_stiffness()};
  if (!contacts.has_normal_stiffness() || !contacts.has_shear_stiffness()) {
    const BondStiffness other = otherwise();
    if (!contacts.has_normal_stiffness()) stiffness.normal = other.normal;
    if (!contacts.has_shear_stiffness()) stiffness.shear = other.shear;
  }
  return {stiffness.normal, stiffness.shear, contacts.friction(), contacts.normal_damping(),
          contacts.shear_damping()};
}

std::uint32_t begin_of_group(const scene::Particles& particles, std::uint32_t group) {
  const int number = static_cast<int>(group) - 1;  // that of a ring's lining may stand in no list
  return number >= 0 && number < particles.groups_size() ? particles.groups(number).stage() : 0;
}

std::vector<std::uint32_t> assign_groups(const scene::Particles& particles, const Placement& placement,
                                         std::uint32_t stage) {
  std::vector<std::uint32_t> group(placement.discs.size(), 0);
  for (int k = 0; k < particles.groups_size(); ++k) {
    const auto& wanted = particles.groups(k);
    if (wanted.stage() > stage) continue;
    const std::string path = group_path(k);
    if (is_lining(particles, wanted)) continue;
    std::vector<std::uint32_t> chosen;
    if (wanted.has_where()) {
      chosen = select(wanted.where(), placement, path + ".where");
    } else {
      if (placement.number.empty())
        throw UserError(path + ".number",
                        "is given, but the particles have no column or field `group`; select them by "
                        "`where`, or add it to the file of `placed`");
      for (std::uint32_t i = 0; i < placement.number.size(); ++i)
        if (placement.number[i] == wanted.number()) chosen.push_back(i);
      if (chosen.empty())
        throw UserError(path + ".number",
                        fmt::format("is {}, which no particle has; give a number that stands in the table",
                                    wanted.number()));
    }
    for (const std::uint32_t i : chosen) group[i] = static_cast<std::uint32_t>(k) + 1;
  }
  if (particles.ring().within_ground())  // the lining holds, whatever else selects its particles
    for (const std::uint32_t i : select(lining_area(particles.ring()), placement, "particles.ring"))
      group[i] = lining_group(particles);
  return group;
}

std::uint32_t group_named(const std::string& name, const std::vector<Group>& groups,
                          const std::string& path) {
  std::vector<std::string> names;
  for (const Group& group : groups) names.push_back(group.name);
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw UserError(path, protocol::quote(name) +
                              " is no group; name one of particles.groups, or `particles` for those "
                              "outside all groups" +
                              protocol::did_you_mean(name, names));
  return static_cast<std::uint32_t>(found - names.begin());
}

double in_series(double a, double b) {
  return a + b > 0 ? 2 * a * b / (a + b) : 0;
}

BondStiffness in_series(const BondStiffness& a, const BondStiffness& b) {
  return {in_series(a.normal, b.normal), in_series(a.shear, b.shear)};
}

LinearContact between(const LinearContact& a, const LinearContact& b) {
  return {in_series(a.normal_stiffness, b.normal_stiffness), in_series(a.shear_stiffness, b.shear_stiffness),
          std::min(a.friction, b.friction), std::min(a.normal_damping, b.normal_damping),
          std::min(a.shear_damping, b.shear_damping)};
}

}  // namespace adit::dem
