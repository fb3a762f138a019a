// Groups of particles: what each is made of and how its particles meet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/model/placement/placement.hpp"
#include "dem_server/model/placement/scene_checks.hpp"

namespace adit::dem {

inline const std::string kOwnGroup = "particles";  // of those that no group of the scene selects
inline const std::string kLining = "lining";       // of a ring within ground

// Refers to the scene.
struct Group {
  std::string name;
  MaterialAt material;
  const scene::Bonds* bonds;  // null: its particles only touch
  std::string bonds_path;
  const scene::ParticleContacts* contacts;
  std::string contacts_path;
  Plane plane;
  bool cells;  // its particles are cells, which facets join

  // Stiffness of its bonds; where the scene gives none, that of the hexagonal lattice of its material.
  BondStiffness stiffness() const;
  LinearContact contact() const;
};

// The model's own group, then those of the scene in their order; then the lining of a ring within ground,
// where the scene names no group for it.
std::vector<Group> read_groups(const scene::Scene& scene);

// A contact law: stiffnesses that it leaves out are the given ones.
LinearContact read_contact(const scene::ParticleContacts& contacts,
                           const std::function<BondStiffness()>& otherwise);

// The stage with which a group begins, by its number among read_groups().
std::uint32_t begin_of_group(const scene::Particles& particles, std::uint32_t group);

// The group of each disc in a stage of excavation.
std::vector<std::uint32_t> assign_groups(const scene::Particles& particles, const Placement& placement,
                                         std::uint32_t stage);

// Where the name is known; else UserError at `path`.
std::uint32_t group_named(const std::string& name, const std::vector<Group>& groups, const std::string& path);

// Half a bond of each in series: that of two equal ones is theirs.
double in_series(double a, double b);
BondStiffness in_series(const BondStiffness& a, const BondStiffness& b);
// The contact of discs of two groups: stiffnesses in series, the smaller friction and dampings.
LinearContact between(const LinearContact& a, const LinearContact& b);

}  // namespace adit::dem
