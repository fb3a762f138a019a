// Requirements on strengths by class: those that the codes print.
#include <gtest/gtest.h>

#include "protocol/sections/section_materials.hpp"

namespace adit::sections::test::section_materials_test {
namespace {

ConcreteValues concrete(const char* name, Values values) {
  return concrete_values(*protocol::concrete_of(name), values);
}
SteelValues steel(const char* name, Values values) {
  return steel_values(*protocol::steel_of(name), values);
}

// EN 1992-1-1, table 3.1 and 3.1.6: f_ck/1.5 and f_ctk,0.05/1.5, to the digits printed there.
TEST(SectionMaterials, DesignValuesOfEurocode) {
  EXPECT_NEAR(concrete("C30/37", Values::kDesign).compressive, 20e6, 1);
  EXPECT_NEAR(concrete("C30/37", Values::kDesign).tensile, 2.0e6 / 1.5, 0.05e6);
  EXPECT_NEAR(concrete("C30/37", Values::kMean).compressive, 38e6, 1);
  EXPECT_NEAR(concrete("C30/37", Values::kMean).peak_strain, 2.2e-3, 0.05e-3);
  for (const auto& [name, peak, ultimate, exponent] : {std::tuple{"C50/60", 2.0, 3.5, 2.0},
                                                       {"C55/67", 2.2, 3.1, 1.75},
                                                       {"C60/75", 2.3, 2.9, 1.6},
                                                       {"C70/85", 2.4, 2.7, 1.45},
                                                       {"C80/95", 2.5, 2.6, 1.4},
                                                       {"C90/105", 2.6, 2.6, 1.4}}) {
    const ParabolaRectangle diagram = concrete(name, Values::kDesign).diagram;
    EXPECT_NEAR(1e3 * diagram.peak_strain, peak, 0.051) << name;
    EXPECT_NEAR(1e3 * diagram.ultimate_strain, ultimate, 0.051) << name;
    EXPECT_NEAR(diagram.exponent, exponent, 0.026) << name;
  }
  EXPECT_NEAR(steel("B500B", Values::kDesign).yield, 434.8e6, 0.1e6);
  EXPECT_NEAR(steel("B500B", Values::kMean).yield, 550e6, 1);
  EXPECT_NEAR(steel("B500B", Values::kDesign).limit_strain, 0.045, 1e-12);
}

// GB 50010-2010, tables 4.1.4-1, 4.1.4-2 and 4.2.3-1.
TEST(SectionMaterials, DesignValuesOfGb50010) {
  for (const auto& [name, compressive, tensile] : {std::tuple{"C20", 9.6, 1.10},
                                                   {"C25", 11.9, 1.27},
                                                   {"C30", 14.3, 1.43},
                                                   {"C35", 16.7, 1.57},
                                                   {"C40", 19.1, 1.71},
                                                   {"C50", 23.1, 1.89},
                                                   {"C60", 27.5, 2.04},
                                                   {"C80", 35.9, 2.22}}) {
    EXPECT_NEAR(concrete(name, Values::kDesign).compressive, 1e6 * compressive, 0.06e6) << name;
    EXPECT_NEAR(concrete(name, Values::kDesign).tensile, 1e6 * tensile, 0.011e6) << name;
  }
  EXPECT_NEAR(concrete("C80", Values::kDesign).diagram.ultimate_strain, 0.0030, 1e-9);
  EXPECT_NEAR(concrete("C80", Values::kDesign).diagram.peak_strain, 0.00215, 1e-9);
  EXPECT_NEAR(concrete("C80", Values::kDesign).diagram.exponent, 1.5, 1e-9);
  EXPECT_NEAR(steel("HPB300", Values::kDesign).yield, 270e6, 1);
  EXPECT_NEAR(steel("HRB400", Values::kDesign).yield, 360e6, 1);
  EXPECT_NEAR(steel("HRB500", Values::kDesign).yield, 435e6, 1);
  EXPECT_NEAR(steel("HRB400", Values::kDesign).limit_strain, 0.01, 1e-12);
}

// Bars reach k f_y at eps_uk.
TEST(SectionMaterials, HardeningReachesTheTensileStrength) {
  for (const auto& [name, ratio, strain] :
       {std::tuple{"B500A", 1.05, 0.025}, {"B500B", 1.08, 0.05}, {"B500C", 1.15, 0.075}}) {
    const SteelValues of = steel(name, Values::kDesign);
    protocol::SteelState bar;
    strain_to(steel_law(of), strain, bar);
    EXPECT_NEAR(bar.stress, ratio * of.yield, 1e-3 * of.yield) << name;
  }
}

// Requirement: every class can be used, by mean and by design values: the curve of concrete rises to its
// strength.
TEST(SectionMaterials, EveryClassHasACurve) {
  for (const std::string& name : protocol::names_of_concrete())
    for (const Values values : {Values::kMean, Values::kDesign}) {
      const ConcreteLaw law = concrete_law(concrete(name.c_str(), values), 0.0025);
      EXPECT_GT(law.modulus * law.peak_strain, law.strength) << name;
    }
  EXPECT_FALSE(protocol::steel_of("B500D"));
  for (const std::string& name : protocol::names_of_steel()) EXPECT_TRUE(protocol::steel_of(name)) << name;
}

}  // namespace
}  // namespace adit::sections::test::section_materials_test
