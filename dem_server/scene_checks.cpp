#include "dem_server/scene_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/frame.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

// A snapshot travels in one frame, at about 260 bytes a particle with its bonds.
constexpr double kBytesPerParticle = 260;
constexpr double kMostParticles = protocol::kMaxFrameBytes / kBytesPerParticle;

void require_positive(double value, const std::string& path, const std::string& unit) {
  if (!(value > 0) || !std::isfinite(value))
    throw UserError(path, fmt::format("is {} {}; give a finite number above 0", value, unit));
}

void require_extent(double min, double max, const std::string& axis) {
  if (!(max > min) || !std::isfinite(max - min))
    throw UserError(
        "particles.packing." + axis + "_max",
        fmt::format("is {} m, not above {}_min = {} m; give a box with finite sides", max, axis, min));
}

}  // namespace

const scene::Material& material_of(const scene::Scene& scene) {
  return scene.particles().has_material() ? scene.particles().material() : scene.material();
}

Packing checked_packing(const scene::Scene& scene) {
  if (!scene.has_particles())
    throw UserError("particles", "is missing; a dem_server needs a scene with particles");
  if (!scene.particles().has_packing())
    throw UserError("particles.packing", "is missing; give the box and the radius of the particles");
  const auto& wanted = scene.particles().packing();
  require_positive(wanted.radius(), "particles.packing.radius", "m");
  require_extent(wanted.x_min(), wanted.x_max(), "x");
  require_extent(wanted.y_min(), wanted.y_max(), "y");
  const Rectangle box{wanted.x_min(), wanted.x_max(), wanted.y_min(), wanted.y_max()};
  const double count = count_hexagonal(box, wanted.radius());
  if (count > kMostParticles)
    throw UserError(
        "particles.packing.radius",
        fmt::format("{} m gives {:.3g} particles, at most {:.3g} can be computed; enlarge the radius",
                    wanted.radius(), count, kMostParticles));
  const Packing packing = pack_hexagonally(box, wanted.radius());
  if (packing.links.empty())
    throw UserError(
        "particles.packing",
        fmt::format(
            "a box of {} m x {} m holds {} particle(s) of radius {} m (a row is sqrt(3) R high, a disc "
            "2 R wide) and no bond; enlarge the box or reduce the radius",
            box.x_max - box.x_min, box.y_max - box.y_min, packing.x.size(), wanted.radius()));
  return packing;
}

BondLaw checked_bond_law(const scene::Scene& scene) {
  const bool own = scene.particles().has_material();
  const auto& material = material_of(scene);
  const std::string path = own ? "particles.material" : "material";
  const auto& bonds = scene.particles().bonds();
  if (!own && !scene.has_material()) throw UserError(path, "is missing; give it, or particles.material");
  if (own && (material.has_mohr_coulomb() || material.has_hysteretic() || material.has_weak_plane()))
    throw UserError(path,
                    "has a law beyond elasticity, which bonds do not compute; leave it out and give "
                    "particles.bonds.tensile_strength and shear_strength");
  require_positive(material.density(), path + ".density", "kg/m^3");
  require_positive(material.young_modulus(), path + ".young_modulus", "Pa");
  const Plane plane = scene.plane() == scene::PLANE_STRESS ? Plane::kStress : Plane::kStrain;
  const double nu = material.poisson_ratio(), limit = largest_poisson_ratio(plane);
  const bool calibrated = !bonds.has_normal_stiffness() || !bonds.has_shear_stiffness();
  if (calibrated && !(nu >= 0 && nu <= limit))
    throw UserError(
        path + ".poisson_ratio",
        fmt::format(
            "is {}, but bonds can be calibrated only from 0 to {:.4g} in plane {}; change it, or give "
            "particles.bonds.normal_stiffness and shear_stiffness",
            nu, limit, plane == Plane::kStress ? "stress" : "strain"));

  BondLaw law{
      {bonds.normal_stiffness(), bonds.shear_stiffness()}, bonds.tensile_strength(), bonds.shear_strength()};
  if (calibrated) {
    const BondStiffness stiffness = calibrate(material.young_modulus(), nu, plane);
    if (!bonds.has_normal_stiffness()) law.stiffness.normal = stiffness.normal;
    // At the limit itself rounding may leave a shear stiffness just below 0.
    if (!bonds.has_shear_stiffness()) law.stiffness.shear = std::max(stiffness.shear, 0.0);
  }
  require_positive(law.stiffness.normal, "particles.bonds.normal_stiffness", "N/m");
  if (!(law.stiffness.shear >= 0) || !std::isfinite(law.stiffness.shear))
    throw UserError("particles.bonds.shear_stiffness",
                    fmt::format("is {} N/m; give a finite number, 0 or above", law.stiffness.shear));
  if (!(law.tensile_strength > 0))
    throw UserError("particles.bonds.tensile_strength",
                    fmt::format("is {} N; give a number above 0", law.tensile_strength));
  if (!(law.shear_strength > 0))
    throw UserError("particles.bonds.shear_strength",
                    fmt::format("is {} N; give a number above 0", law.shear_strength));
  return law;
}

}  // namespace adit::dem
