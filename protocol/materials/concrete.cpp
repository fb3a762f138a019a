#include "protocol/materials/concrete.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adit::protocol {
namespace {

struct Eurocode {
  int cylinder, cube;  // f_ck, f_ck,cube [MPa]
  std::string name() const { return fmt::format("C{}/{}", cylinder, cube); }
};
constexpr Eurocode kEurocode[] = {{12, 15}, {16, 20}, {20, 25}, {25, 30}, {30, 37}, {35, 45}, {40, 50},
                                  {45, 55}, {50, 60}, {55, 67}, {60, 75}, {70, 85}, {80, 95}, {90, 105}};

struct Chinese {
  int cube;                                               // f_cu,k [MPa]
  double compressive, tensile, young_modulus, variation;  // f_ck, f_tk [MPa]; E_c [GPa]; delta
  std::string name() const { return fmt::format("C{}", cube); }
};
constexpr Chinese kChinese[] = {
    {15, 10.0, 1.27, 22.0, 0.233}, {20, 13.4, 1.54, 25.5, 0.206}, {25, 16.7, 1.78, 28.0, 0.189},
    {30, 20.1, 2.01, 30.0, 0.172}, {35, 23.4, 2.20, 31.5, 0.164}, {40, 26.8, 2.39, 32.5, 0.156},
    {45, 29.6, 2.51, 33.5, 0.156}, {50, 32.4, 2.64, 34.5, 0.149}, {55, 35.5, 2.74, 35.5, 0.149},
    {60, 38.5, 2.85, 36.0, 0.141}, {65, 41.5, 2.93, 36.5, 0.141}, {70, 44.5, 2.99, 37.0, 0.141},
    {75, 47.4, 3.05, 37.5, 0.141}, {80, 50.2, 3.11, 38.0, 0.141}};

struct Strengths {
  double compressive, tensile;  // [MPa]
};

// From MPa, and GPa of the modulus.
Concrete concrete(double young_modulus, const Strengths& mean, const Strengths& characteristic, int cube,
                  Standard standard) {
  return {1e9 * young_modulus,
          1e6 * mean.compressive,
          1e6 * mean.tensile,
          fracture_energy(1e6 * mean.compressive),
          1e6 * characteristic.compressive,
          1e6 * characteristic.tensile,
          1e6 * cube,
          standard};
}

Concrete means(const Eurocode& of) {
  const double mean = of.cylinder + 8;
  const double tensile =
      of.cylinder <= 50 ? 0.30 * std::pow(of.cylinder, 2.0 / 3) : 2.12 * std::log(1 + mean / 10);
  return concrete(22 * std::pow(mean / 10, 0.3), {mean, tensile},
                  {static_cast<double>(of.cylinder), 0.7 * tensile}, of.cube, Standard::kEurocode);
}

Concrete means(const Chinese& of) {
  const double characteristic = 1 - 1.645 * of.variation;  // over the mean
  return concrete(of.young_modulus, {of.compressive / characteristic, of.tensile / characteristic},
                  {of.compressive, of.tensile}, of.cube, Standard::kChinese);
}

template <class Visit>
void for_all_classes(Visit visit) {
  for (const Eurocode& one : kEurocode) visit(one);
  for (const Chinese& one : kChinese) visit(one);
}

}  // namespace

std::optional<Concrete> concrete_of(const std::string& name) {
  std::optional<Concrete> found;
  for_all_classes([&](const auto& one) {
    if (one.name() == name) found = means(one);
  });
  return found;
}

double fracture_energy(double compressive_strength) {
  return 73 * std::pow(compressive_strength / 1e6, 0.18);
}

std::vector<std::string> names_of_concrete() {
  std::vector<std::string> names;
  for_all_classes([&](const auto& one) { names.push_back(one.name()); });
  return names;
}

}  // namespace adit::protocol
