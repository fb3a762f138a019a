#include "dem_server/model/placement/scene_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/machine/memory.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

// What a lattice takes at least, with its snapshot, here and in a coupler beside it (docs/performance.md).
constexpr double kBytesPerParticle = 1700;
// A model tells two numbers for each particle and for each of its three bonds.
constexpr double kModelBytes = 4 * 2 * sizeof(double);

double most_particles() {
  return std::min(static_cast<double>(protocol::machine_bytes()) / kBytesPerParticle,
                  static_cast<double>(protocol::kMaxModelBytes) / kModelBytes);
}

}  // namespace

void require_room_for(double particles, double radius, const std::string& path) {
  if (particles > most_particles())
    throw UserError(path, fmt::format("{} m gives {:.3g} particles, at most {:.3g} can be computed on this "
                                      "machine; enlarge it",
                                      radius, particles, most_particles()));
}

void require_two_ends(const scene::Point& from, const scene::Point& to, const std::string& path,
                      const char* what) {
  if (!(std::hypot(to.x() - from.x(), to.y() - from.y()) >= kSmallestRadius))
    throw UserError(path + ".to", fmt::format("is the same place as `from`; give a {} two ends", what));
}

const scene::Material& material_of(const scene::Scene& scene) {
  return scene.particles().has_material() ? scene.particles().material() : scene.material();
}

MaterialAt checked_material(const scene::Scene& scene) {
  const bool own = scene.particles().has_material();
  const MaterialAt at{material_of(scene), own ? "particles.material" : "material"};
  if (!own && !scene.has_material()) throw UserError(at.path, "is missing; give it, or particles.material");
  if (own) require_usable(at, scene.particles().bonds(), scene.particles().has_cells());
  return at;
}

std::vector<std::string> laws_beyond_bonds(const scene::Material& material, const scene::Bonds& bonds,
                                           bool cells) {
  std::vector<std::string> laws;
  if (material.has_fracture() && !cells) laws.emplace_back("fracture");
  if (material.has_mohr_coulomb() && !bonds.strength_of_material()) laws.emplace_back("mohr_coulomb");
  if (material.has_weak_plane()) laws.emplace_back("weak_plane");
  if (material.has_hysteretic()) laws.emplace_back("hysteretic");
  return laws;
}

void require_usable(const MaterialAt& at, const scene::Bonds& bonds, bool cells) {
  const std::vector<std::string> laws = laws_beyond_bonds(at.material, bonds, cells);
  if (laws.empty()) return;
  if (cells)
    throw UserError(at.path + "." + laws.front(),
                    "is given, but cells break by `fracture`; leave it out, and give the strength there");
  if (laws.front() == "fracture")
    throw UserError(at.path + ".fracture",
                    "is given, but only facets between `cells` break by it; give bonds.tensile_strength and "
                    "shear_strength, or "
                    "pack `cells`");
  throw UserError(at.path,
                  "has a law beyond elasticity, which bonds do not compute; leave it out and give "
                  "particles.bonds.tensile_strength and shear_strength, or leave only mohr_coulomb and set "
                  "particles.bonds.strength_of_material");
}

Plane plane_of(const scene::Scene& scene) {
  return scene.plane() == scene::PLANE_STRESS ? Plane::kStress : Plane::kStrain;
}

BondStiffness checked_stiffness(const scene::Bonds& bonds, const std::string& path, const MaterialAt& at,
                                Plane plane) {
  BondStiffness stiffness{bonds.normal_stiffness(), bonds.shear_stiffness()};
  if (!bonds.has_normal_stiffness() || !bonds.has_shear_stiffness()) {
    const double nu = at.material.poisson_ratio(), limit = largest_poisson_ratio(plane);
    if (!(nu >= 0 && nu <= limit))
      throw UserError(
          at.path + ".poisson_ratio",
          fmt::format(
              "is {}, but bonds can be calibrated only from 0 to {:.4g} in plane {}; change it, or give "
              "{}.normal_stiffness and shear_stiffness",
              nu, limit, plane == Plane::kStress ? "stress" : "strain", path));
    const BondStiffness calibrated = calibrate(at.material.young_modulus(), nu, plane);
    if (!bonds.has_normal_stiffness()) stiffness.normal = calibrated.normal;
    // At the limit itself rounding may leave a shear stiffness just below 0.
    if (!bonds.has_shear_stiffness()) stiffness.shear = std::max(calibrated.shear, 0.0);
  }
  return stiffness;
}

}  // namespace adit::dem
