// Concrete of a section as scenes state it, by class or by numbers.
//
// Of a class, mean values are those of concrete.hpp. Design values (EN 1992-1-1:2004, 3.1.6):
//   f_cd = f_ck/1.5, f_ctd = f_ctk,0.05/1.5, E_cd = E_cm/1.2 (5.8.6 (3))
// with alpha_cc = alpha_ct = 1. GB 50010-2010, 4.1.4: f_c = f_ck/1.4, f_t = f_tk/1.4.
#pragma once

#include <optional>
#include <string>

#include "protocol/materials/concrete.hpp"
#include "protocol/materials/values.hpp"
#include "protocol/messages/reinforced_section.pb.h"

namespace adit::protocol {

struct ConcreteStrengths {
  double young_modulus, compressive, tensile;  // [Pa]
  double partial_factor;                       // gamma_c by which the strengths are divided
};

ConcreteStrengths concrete_strengths(const Concrete& of, Values values);

// UserError at `path` for a class that no standard has.
Concrete concrete_named(const std::string& name, const std::string& path);
// Nothing where it is given by numbers. UserError where its strength is stated twice or not at all, and
// for a class that no standard has.
std::optional<Concrete> class_of(const scene::SectionConcrete& concrete, const std::string& path);
// Numbers are taken as they are. Errors as above.
ConcreteStrengths read_concrete(const scene::SectionConcrete& concrete, Values values,
                                const std::string& path);

}  // namespace adit::protocol
