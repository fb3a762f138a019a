// Reinforcing steel as scenes state it, by class or by numbers, and its law.
//
// Of a class, mean values are those of steel.hpp; design values are f_yd = f_yk/1.15 (EN
// 1992-1-1:2004, 3.2.7) and those of GB 50010. Numbers are taken as they are.
#pragma once

#include <limits>
#include <string>

#include "protocol/materials/steel.hpp"
#include "protocol/materials/steel_law.hpp"
#include "protocol/materials/values.hpp"
#include "protocol/messages/reinforced_section.pb.h"

namespace adit::protocol {

struct SteelValues {
  double young_modulus, yield;  // [Pa]
  double hardening;             // slope after yield over the modulus
  double limit_strain;          // eps_ud
  SteelCurve curve = SteelCurve::kBilinear;
  double rupture = std::numeric_limits<double>::infinity();  // tensile strain
};
SteelValues steel_values(const Steel& of, Values values);
// UserError at `path` where its strength is stated twice or not at all.
SteelValues read_steel(const scene::SectionSteel& steel, Values values, const std::string& path);

inline SteelLaw steel_law(const SteelValues& steel) {
  return {steel.young_modulus, steel.yield, steel.hardening, steel.curve, steel.rupture};
}

}  // namespace adit::protocol
