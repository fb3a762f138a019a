#include "protocol/materials/read_steel.hpp"

#include <fmt/format.h>

#include "protocol/materials/class_named.hpp"

namespace adit::protocol {

SteelValues steel_values(const Steel& of, Values values) {
  const double yield = values == Values::kMean ? of.mean_yield : of.design_yield;
  const double rise = (of.hardening - 1) * yield / (of.ultimate_strain - yield / of.young_modulus);
  return {of.young_modulus, yield, rise / of.young_modulus, of.design_strain};
}

SteelValues read_steel(const scene::SectionSteel& steel, Values values, const std::string& path) {
  const bool any = steel.has_young_modulus() || steel.has_hardening() || steel.has_ultimate_strain();
  require(steel.has_class_() ? !any && !steel.has_yield_strength() : steel.has_yield_strength(), path,
          "needs its strength once: give either `class`, or `yield_strength` with what else differs from its "
          "default");
  SteelValues read =
      steel.has_class_()
          ? steel_values(class_named(steel.class_(), steel_of, names_of_steel(),
                                     "EN 1992-1-1 (`B500B`) or of GB 50010 (`HRB400`)", path + ".class"),
                         values)
          : SteelValues{steel.young_modulus(), steel.yield_strength(), steel.hardening(),
                        steel.ultimate_strain()};
  if (steel.law() == scene::SectionSteel::MENEGOTTO_PINTO) read.curve = SteelCurve::kMenegottoPinto;
  if (!steel.has_rupture_strain()) return read;
  read.rupture = steel.rupture_strain();
  const double yields = read.yield / read.young_modulus;
  require(read.rupture > yields, path + ".rupture_strain",
          fmt::format("is {:.4g}, but bars yield at {:.4g} only; give more", read.rupture, yields));
  return read;
}

}  // namespace adit::protocol
