#include "protocol/materials/read_concrete.hpp"

#include "protocol/materials/class_named.hpp"

namespace adit::protocol {

ConcreteStrengths concrete_strengths(const Concrete& of, Values values) {
  if (values == Values::kMean) return {of.young_modulus, of.compressive_strength, of.tensile_strength, 1};
  const bool eurocode = of.standard == Standard::kEurocode;
  const double factor = eurocode ? 1.5 : 1.4;
  return {eurocode ? of.young_modulus / 1.2 : of.young_modulus, of.characteristic_compressive / factor,
          of.characteristic_tensile / factor, factor};
}

Concrete concrete_named(const std::string& name, const std::string& path) {
  return class_named(name, concrete_of, names_of_concrete(),
                     "EN 1992-1-1 (`C12/15` to `C90/105`) or of GB 50010 (`C15` to `C80`)", path);
}

std::optional<Concrete> class_of(const scene::SectionConcrete& concrete, const std::string& path) {
  const bool any =
      concrete.has_young_modulus() || concrete.has_compressive_strength() || concrete.has_tensile_strength();
  const bool all =
      concrete.has_young_modulus() && concrete.has_compressive_strength() && concrete.has_tensile_strength();
  require(concrete.has_class_() ? !any : all, path,
          "needs its strength once: give either `class`, or `young_modulus`, `compressive_strength` and "
          "`tensile_strength`");
  if (!concrete.has_class_()) return std::nullopt;
  return concrete_named(concrete.class_(), path + ".class");
}

ConcreteStrengths read_concrete(const scene::SectionConcrete& concrete, Values values,
                                const std::string& path) {
  if (const auto known = class_of(concrete, path)) return concrete_strengths(*known, values);
  return {concrete.young_modulus(), concrete.compressive_strength(), concrete.tensile_strength(), 1};
}

}  // namespace adit::protocol
