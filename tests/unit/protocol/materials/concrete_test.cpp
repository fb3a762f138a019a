// Classes of concrete have the mean values of their standards.
#include "protocol/materials/concrete.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace adit::protocol::concrete_test {
namespace {

Concrete of(const std::string& name) {
  const auto found = concrete_of(name);
  EXPECT_TRUE(found) << name;
  return found.value_or(Concrete{});
}

// Requirement: E_cm and f_ctm of EN 1992-1-1 are those of its table 3.1, to the digits printed there.
TEST(Concrete, EurocodeHasTheValuesOfItsTable) {
  struct Row {
    const char* name;
    double mean, tensile, modulus;  // [MPa], [GPa]
  };
  for (const Row& row : {Row{"C12/15", 20, 1.6, 27}, Row{"C16/20", 24, 1.9, 29}, Row{"C20/25", 28, 2.2, 30},
                         Row{"C25/30", 33, 2.6, 31}, Row{"C30/37", 38, 2.9, 33}, Row{"C35/45", 43, 3.2, 34},
                         Row{"C40/50", 48, 3.5, 35}, Row{"C45/55", 53, 3.8, 36}, Row{"C50/60", 58, 4.1, 37},
                         Row{"C55/67", 63, 4.2, 38}, Row{"C60/75", 68, 4.4, 39}, Row{"C70/85", 78, 4.6, 41},
                         Row{"C80/95", 88, 4.8, 42}, Row{"C90/105", 98, 5.0, 44}}) {
    const Concrete concrete = of(row.name);
    EXPECT_DOUBLE_EQ(concrete.compressive_strength, 1e6 * row.mean) << row.name;
    EXPECT_NEAR(concrete.tensile_strength, 1e6 * row.tensile, 0.05e6) << row.name;
    EXPECT_NEAR(concrete.young_modulus, 1e9 * row.modulus, 0.5e9) << row.name;
  }
}

// Requirement: the tables of GB 50010 follow the formulas of its commentary on 4.1.3 to 4.1.5, to the digits
// printed there. The tensile strengths have the scatter of 1980, the means that of annex C.
TEST(Concrete, ChineseClassesFollowTheFormulasOfTheirStandard) {
  struct Row {
    int cube;                 // f_cu,k [MPa]
    double scatter, annexed;  // coefficients of variation
  };
  for (const auto& [cube, scatter, annexed] :
       {Row{15, 0.21, 0.233}, Row{20, 0.18, 0.206}, Row{25, 0.16, 0.189}, Row{30, 0.14, 0.172},
        Row{35, 0.13, 0.164}, Row{40, 0.12, 0.156}, Row{45, 0.12, 0.156}, Row{50, 0.11, 0.149},
        Row{55, 0.11, 0.149}, Row{60, 0.10, 0.141}, Row{65, 0.10, 0.141}, Row{70, 0.10, 0.141},
        Row{75, 0.10, 0.141}, Row{80, 0.10, 0.141}}) {
    const std::string name = "C" + std::to_string(cube);
    const Concrete concrete = of(name);
    const double over_mean = 1 - 1.645 * annexed;
    const double prism = 0.76 + 0.06 * std::max(0, cube - 50) / 30.0,
                 brittle = 1 - 0.13 * std::max(0, cube - 40) / 40.0;
    EXPECT_NEAR(concrete.compressive_strength * over_mean, 0.88e6 * prism * brittle * cube, 0.06e6) << name;
    EXPECT_NEAR(concrete.tensile_strength * over_mean,
                0.88e6 * 0.395 * std::pow(cube, 0.55) * std::pow(1 - 1.645 * scatter, 0.45) * brittle, 0.02e6)
        << name;
    EXPECT_NEAR(concrete.young_modulus, 1e11 / (2.2 + 34.7 / cube), 0.35e9) << name;
  }
}

// Requirement: a class of one standard is not taken for that of the other.
TEST(Concrete, OneNumberMeansTwoConcretes) {
  EXPECT_NEAR(of("C30/37").compressive_strength, 38e6, 1);
  EXPECT_NEAR(of("C30").compressive_strength, 28.0e6, 0.1e6);
}

// Requirement: the fracture energy is that of fib Model Code 2010, about 140 J/m^2 for C30/37.
TEST(Concrete, FractureEnergyGrowsWithTheStrength) {
  EXPECT_NEAR(of("C30/37").fracture_energy, 140.5, 0.1);
  EXPECT_NEAR(of("C90/105").fracture_energy / of("C12/15").fracture_energy, std::pow(98.0 / 20, 0.18), 1e-12);
}

TEST(Concrete, OtherNamesAreNoClasses) {
  for (const char* name : {"", "C", "C32", "C30/35", "c30", "C30/37 ", "B30"})
    EXPECT_FALSE(concrete_of(name)) << name;
  for (const std::string& name : names_of_concrete()) EXPECT_TRUE(concrete_of(name)) << name;
}

}  // namespace
}  // namespace adit::protocol::concrete_test
