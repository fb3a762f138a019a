#include "dem_server/participant/breakable_bonds.hpp"

#include <algorithm>

namespace adit::dem {
namespace {

bool is_breakable(const Model& model, const Bond& bond) {
  switch (bond.law) {
    case Bond::Law::kContactBond: {
      const ContactBond& law = model.contact_bonds[bond.number];
      return law.tensile_strength < kUnbreakable || law.shear_strength < kUnbreakable;
    }
    case Bond::Law::kParallelBond: {
      const ParallelBond& law = model.parallel_bonds[bond.number];
      return law.tensile_strength < kUnbreakable || law.cohesion < kUnbreakable;
    }
    default:
      return false;
  }
}

}  // namespace

std::size_t breakable_bonds(const Model& model) {
  return static_cast<std::size_t>(
      std::ranges::count_if(model.bonds, [&](const Bond& bond) { return is_breakable(model, bond); }));
}

}  // namespace adit::dem
