// The section of a lining or a member, whose messages name its parts alike.
// Errors: UserError at `path`, the scene's field, where it is given twice or not at all.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "fdm_server/model/supports/reinforced_section.hpp"
#include "fdm_server/structures/beam.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

// An elastic section so wide in each metre of the plane, whose area and inertia, where given, count as often.
// `continues`: across the plane, so that it cannot strain there.
template <class Stated>
Section read_elastic_section(const Stated& stated, double width, double in_each_metre, bool continues,
                             const std::string& path) {
  using protocol::require;
  const bool both = stated.has_area() && stated.has_inertia(),
             any = stated.has_area() || stated.has_inertia();
  require(
      stated.has_thickness() ? !any : both, path,
      "needs a section: give either `thickness`, or both `area` and `inertia`, or `section` of reinforced "
      "concrete");
  require(stated.has_young_modulus(), path + ".young_modulus",
          "is missing; give it, such as `30 GPa`, or a `section` of reinforced concrete");
  const double area = both ? in_each_metre * stated.area() : width * stated.thickness();
  const double inertia =
      both ? in_each_metre * stated.inertia() : width * (std::pow(stated.thickness(), 3) / 12);
  return make_section(
      lining_material(continues, stated.young_modulus(), stated.poisson_ratio(), stated.density()), area,
      inertia, stated.shear_flexible());
}

// The reinforced one, if it has one. `core`: the share of its width inside the cover of its sides.
template <class Stated>
std::shared_ptr<const LiningSection> read_section(const Stated& stated, double width, double core,
                                                  const std::string& path) {
  if (!stated.has_section()) return nullptr;
  const auto lone = [&](bool given, const char* key) {
    protocol::require(!given, path + "." + key, "is given beside `section`, which states it; leave one out");
  };
  lone(stated.has_thickness(), "thickness");
  lone(stated.has_area(), "area");
  lone(stated.has_inertia(), "inertia");
  lone(stated.has_young_modulus(), "young_modulus");
  return read_reinforced_section(stated.section(), width, core, path + ".section");
}

// Its beams at first.
template <class Stated>
Section elastic_section(const LiningSection& section, const Stated& stated) {
  const LiningMaterial material =
      lining_material(false, section.concrete_modulus, stated.poisson_ratio(), stated.density());
  return elastic_section(*section.fibres, material.shear, material.density, stated.shear_flexible());
}

}  // namespace adit::fdm
