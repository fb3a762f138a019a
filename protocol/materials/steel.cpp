#include "protocol/materials/steel.hpp"

namespace adit::protocol {
namespace {

struct SteelClass {
  const char* name;
  Steel steel;
};

Steel eurocode(double hardening, double ultimate_strain) {
  constexpr double kYield = 500e6;
  return {200e9, kYield, 1.1 * kYield, kYield / 1.15, hardening, ultimate_strain, 0.9 * ultimate_strain};
}

// From MPa, and GPa of the modulus.
Steel chinese(double young_modulus, double yield, double ultimate, double design, double variation,
              double ultimate_strain) {
  return {
      1e9 * young_modulus, 1e6 * yield, 1e6 * yield / (1 - 1.645 * variation), 1e6 * design, ultimate / yield,
      ultimate_strain,     0.01};
}

const SteelClass kSteelClasses[] = {{"B500A", eurocode(1.05, 0.025)},
                                    {"B500B", eurocode(1.08, 0.05)},
                                    {"B500C", eurocode(1.15, 0.075)},
                                    {"HPB300", chinese(210, 300, 420, 270, 0.0895, 0.1)},
                                    {"HRB400", chinese(200, 400, 540, 360, 0.0743, 0.075)},
                                    {"HRB500", chinese(200, 500, 630, 435, 0.0743, 0.075)}};

}  // namespace

std::optional<Steel> steel_of(const std::string& name) {
  for (const SteelClass& one : kSteelClasses)
    if (one.name == name) return one.steel;
  return std::nullopt;
}

std::vector<std::string> names_of_steel() {
  std::vector<std::string> names;
  for (const SteelClass& one : kSteelClasses) names.emplace_back(one.name);
  return names;
}

}  // namespace adit::protocol
