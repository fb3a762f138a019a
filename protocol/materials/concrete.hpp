// Mean values of the classes of concrete.
//
// `C30/37` is a class of EN 1992-1-1:2004, table 3.1 (f_ck of cylinders and of cubes [MPa]), with f_ck in
// MPa:
//   f_cm = f_ck + 8,   E_cm = 22 GPa (f_cm / 10)^0.3,
//   f_ctm = 0.30 f_ck^(2/3) up to C50/60, 2.12 ln(1 + f_cm / 10) above.
// `C30` is a class of GB 50010-2010 (f_cu,k of cubes), with f_ck and f_tk of table 4.1.3 and E_c of table
// 4.1.5. Its means are those of its annex C.2.1, by the coefficients of variation delta given there:
//   f_cm = f_ck / (1 - 1.645 delta),   f_tm = f_tk / (1 - 1.645 delta).
// These are values of the structure, 0.88 times those of specimens.
// Characteristic strengths are f_ck, f_tk of those tables; of EN 1992-1-1 f_ctk,0.05 = 0.7 f_ctm.
// Of both: the fracture energy 73 N/m f_cm^0.18 (fib Model Code 2010, eq. 5.1-9), Poisson's ratio 0.2, and
// 2400 kg/m^3, without reinforcement.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace adit::protocol {

enum class Standard { kEurocode, kChinese };

struct Concrete {
  double young_modulus;                                       // [Pa]
  double compressive_strength, tensile_strength;              // f_cm, f_ctm [Pa]
  double fracture_energy;                                     // G_F [J/m^2]
  double characteristic_compressive, characteristic_tensile;  // f_ck, f_ctk [Pa]
  double cube;                                                // f_ck,cube [Pa]
  Standard standard;
  static constexpr double kPoissonRatio = 0.2, kDensity = 2400;  // [kg/m^3]
};

// Nothing where no standard has a class of this name.
std::optional<Concrete> concrete_of(const std::string& name);

// G_F [J/m^2] of a mean compressive strength [Pa].
double fracture_energy(double compressive_strength);

// Of all classes.
std::vector<std::string> names_of_concrete();

}  // namespace adit::protocol
