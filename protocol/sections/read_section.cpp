#include "protocol/sections/read_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/sections/bars_area.hpp"

namespace adit::sections {
namespace {

using protocol::require;

// Minor, moderate, extensive, complete (Argyroudis & Pitilakis 2012, Soil Dyn. Earthq. Eng. 35).
const std::vector<double> kDamageStates{1, 1.5, 2.5, 3.5};

ConcreteValues read_concrete(const scene::ReinforcedSection& section, const std::string& path) {
  const auto& concrete = section.concrete();
  if (const auto known = protocol::class_of(concrete, path))
    return concrete_values(*known, protocol::values_of(section.values()));
  const ConcreteValues values =
      concrete_values(concrete.young_modulus(), concrete.compressive_strength(), concrete.tensile_strength());
  const double least = values.compressive / (1.05 * values.peak_strain);
  require(values.young_modulus > least, path + ".young_modulus",
          fmt::format("is {:.4g} Pa, too small for a compressive strength of {:.4g} Pa: the curve of EN "
                      "1992-1-1, eq. 3.14, reaches it only above {:.4g} Pa; give more, or less strength",
                      values.young_modulus, values.compressive, least));
  return values;
}

void require_one_kind_of_values(const scene::ReinforcedSection& section, const std::string& path) {
  const bool class_of_concrete = section.concrete().has_class_();
  if (section.has_steel())
    require(
        class_of_concrete == section.steel().has_class_(), path,
        fmt::format("gives its {} by class and its {} by numbers, which may be other values than the mean or "
                    "design values of the class; give both by class, or both by numbers",
                    class_of_concrete ? "concrete" : "steel", class_of_concrete ? "steel" : "concrete"));
  require(
      !section.has_values() || class_of_concrete, path + ".values",
      "chooses among the values of classes, but the materials are given by numbers, which are used as they "
      "are; leave it out, or give classes");
}

// `outwards`: -1 for the inner face, 1 for the outer one.
BarLayer read_bars(const scene::SectionBars& bars, const scene::ReinforcedSection& section, double outwards,
                   const std::string& path) {
  const double diameter = bars.diameter(), area = bars_area(bars, path), spacing = bar_area(diameter) / area;
  require(spacing >= 2 * diameter, bars.has_area() ? path + ".area" : path + ".spacing",
          fmt::format(
              "puts bars of {:.4g} m at {:.4g} m, closer than their diameter to one another (EN 1992-1-1, "
              "8.2); give fewer or thinner bars",
              diameter, spacing));
  require(section.has_cover(), path, "has bars, but the section has no `cover`; give it");
  const double depth = section.cover() + diameter / 2;
  require(
      section.cover() + diameter <= section.thickness(), path,
      fmt::format("lies outside the section: bars of {:.4g} m under a cover of {:.4g} m need more than its "
                  "thickness of {:.4g} m; give less cover",
                  diameter, section.cover(), section.thickness()));
  return {outwards * (section.thickness() / 2 - depth), area, diameter};
}

SectionShape read_shape(const scene::ReinforcedSection& section, const std::string& path) {
  SectionShape shape{section.thickness(), 1, {}};
  if (section.has_inner()) shape.bars.push_back(read_bars(section.inner(), section, -1, path + ".inner"));
  if (section.has_outer()) shape.bars.push_back(read_bars(section.outer(), section, 1, path + ".outer"));
  require(shape.bars.empty() == !section.has_steel(), path + ".steel",
          shape.bars.empty() ? "is given, but there are no bars; give `inner`, `outer` or both"
                             : "is missing, but there are bars; give its `class`");
  require(
      shape.bars.size() < 2 ||
          2 * section.cover() + shape.bars[0].diameter + shape.bars[1].diameter <= section.thickness(),
      path + ".cover",
      fmt::format("is {:.4g} m, with which the bars of both faces meet in the middle of {:.4g} m; give less",
                  section.cover(), section.thickness()));
  require(!shape.bars.empty() || section.concrete().has_fibres(), path,
          "has neither bars nor fibres, and plain concrete resists no moment without thrust; give `inner`, "
          "`outer` or `concrete.fibres`, or a lining of `thickness` and `young_modulus`");
  return shape;
}

ResidualTension read_fibres(const scene::ReinforcedSection& section) {
  if (!section.concrete().has_fibres()) return {};
  const auto& fibres = section.concrete().fibres();
  const ResidualStrengths of{fibres.residual_strength_1(), fibres.residual_strength_3()};
  return fibres.model() == scene::SectionFibres::RIGID_PLASTIC ? rigid_plastic_model(of, section.thickness())
                                                               : linear_model(of, section.thickness());
}

double stirrups_of(const scene::ReinforcedSection& section) {
  if (!section.has_stirrups()) return 0;
  const auto& of = section.stirrups();
  return bar_area(of.diameter()) / (of.spacing() * of.spacing_across());
}

}  // namespace

StatedSection read_section(const scene::ReinforcedSection& section, double width, const std::string& path) {
  SectionShape shape = read_shape(section, path);
  shape.width = width;
  for (BarLayer& bars : shape.bars) bars.area *= width;
  require_one_kind_of_values(section, path);
  const ConcreteValues concrete = read_concrete(section, path + ".concrete");
  require(section.has_steel() || !section.has_stirrups(), path + ".stirrups",
          "stand in a section without bars along it, which cannot hold them; give `inner` and `outer`");
  const SteelValues steel =
      section.has_steel()
          ? protocol::read_steel(section.steel(), protocol::values_of(section.values()), path + ".steel")
          : SteelValues{200e9, 500e6, 0, 0.045};
  const double stirrups = stirrups_of(section);
  StatedSection read{shape, concrete, steel, read_fibres(section), width * stirrups, {}, kDamageStates};
  if (section.damage_states_size() > 0)
    read.damage_states.assign(section.damage_states().begin(), section.damage_states().end());
  if (section.stirrups().has_confinement())
    read.confined = Confinement{stirrups, section.stirrups().confinement()};
  return read;
}

Strength strength_of(const StatedSection& of) {
  return {of.shape, Capacity(of.shape, capacity_materials(of.concrete, of.steel, of.residual)),
          shear_materials(of.concrete, of.steel, of.stirrups), of.damage_states};
}

}  // namespace adit::sections
