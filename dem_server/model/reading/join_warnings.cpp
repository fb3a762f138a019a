#include "dem_server/model/reading/join_warnings.hpp"

#include <fmt/format.h>

namespace adit::dem {
namespace {

constexpr double kFewPairs = 0.05;             // of the bonds
constexpr std::size_t kContactsOfLining = 40;  // that cross it; its joints are short, and keys hold them

void warn_of_near_pairs(const Joined& joined, const Reach& reach, std::vector<std::string>& warnings) {
  if (static_cast<double>(joined.nearly) <= kFewPairs * static_cast<double>(joined.bonds)) return;
  warnings.push_back(
      fmt::format("particles have {} bonds, and {} more pairs only touch, though their gaps are at most "
                  "{:.2g} of their mean "
                  "radius; where rounding opened them, give bonds.reach: {:.2g}",
                  joined.bonds, joined.nearly, reach.near, reach.near));
}

void warn_of_teeth(const scene::Particles& particles, const Joined& joined,
                   std::vector<std::string>& warnings) {
  if (!particles.has_packing() && !particles.has_square_packing()) return;
  for (std::size_t k = 0; k < joined.crossing.size(); ++k) {
    if (!particles.joints(static_cast<int>(k)).open() || joined.crossing[k] <= kContactsOfLining) continue;
    warnings.push_back(fmt::format(
        "particles.joints[{}] is open across {} contacts of particles in rows, which interlock and part "
        "where the faces shift; a `smooth` joint slides along its plane",
        k, joined.crossing[k]));
  }
}

}  // namespace

std::vector<std::string> join_warnings(const scene::Particles& particles, const Joined& joined,
                                       const Reach& reach) {
  std::vector<std::string> warnings;
  warn_of_near_pairs(joined, reach, warnings);
  warn_of_teeth(particles, joined, warnings);
  return warnings;
}

}  // namespace adit::dem
