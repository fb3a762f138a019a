// Fields of factors: bilinear on their lattice, constant beyond it; wrong tables are refused at the key of
// their file.
#include "protocol/scatter/scattering.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"

namespace adit::protocol::scattering_test {
namespace {

const std::string kNames = "x_m,y_m,factor\n";

FactorField field(const std::string& rows) {
  return {"field.csv", kNames + rows};
}

TEST(FactorField, IsBilinearBetweenItsNodesAndThatOfItsEdgeBeyond) {
  const FactorField factors = field("0,10,1\n4,10,3\n0,20,5\n4,20,15\n");
  EXPECT_EQ(factors.at(0, 10), 1);
  EXPECT_EQ(factors.at(4, 20), 15);
  EXPECT_EQ(factors.at(1, 10), 1.5);
  EXPECT_EQ(factors.at(0, 15), 3);
  EXPECT_EQ(factors.at(2, 15), (1 + 3 + 5 + 15) / 4.0);
  EXPECT_EQ(factors.at(-7, 15), factors.at(0, 15));
  EXPECT_EQ(factors.at(99, 12), factors.at(4, 12));
  EXPECT_EQ(factors.at(3, -1), factors.at(3, 10));
  EXPECT_EQ(factors.at(99, 99), 15);
}

// Rows may stand in any order, lines at any distance; coordinates that differ by rounding are one line.
TEST(FactorField, FindsItsLattice) {
  const FactorField factors =
      field("0.30000000000000004,1,6\n0,0,1\n1,1,7\n# a note\n0.3,0,2\n0,1,5\n1,0,3\n");
  EXPECT_EQ(factors.at(0.65, 0), 2.5);
  EXPECT_EQ(factors.at(0.15, 1), 5.5);
  EXPECT_NEAR(factors.at(0.3, 0.5), 4, 1e-12);
}

TEST(FactorField, MayBeASingleLineOrNode) {
  const FactorField row = field("0,5,1\n2,5,2\n"), column = field("5,0,1\n5,2,2\n"),
                    node = field("1,1,0.25\n");
  EXPECT_EQ(row.at(1, -100), 1.5);
  EXPECT_EQ(column.at(100, 1.5), 1.75);
  EXPECT_EQ(node.at(3, -8), 0.25);
}

scene::Scatter scatter(scene::Scatter::Property of, const std::string& rows) {
  scene::Scatter scatter;
  scatter.set_of(of);
  scatter.set_path("field.csv");
  scatter.set_content(rows);
  return scatter;
}

// Fields of one property multiply each other, those of the other one do not count.
TEST(Scattering, IsTheProductOfItsFields) {
  ScatterFields fields;
  *fields.Add() = scatter(scene::Scatter::STIFFNESS, kNames + "0,0,2\n1,0,4\n");
  *fields.Add() = scatter(scene::Scatter::STRENGTH, kNames + "0,0,100\n");
  *fields.Add() = scatter(scene::Scatter::STIFFNESS, kNames + "0,0,0.5\n0,1,0.25\n");
  const Scattering stiffness(fields, scene::Scatter::STIFFNESS, "continuum.scatter"),
      strength(fields, scene::Scatter::STRENGTH, "continuum.scatter"),
      none(ScatterFields(), scene::Scatter::STIFFNESS, "continuum.scatter");
  EXPECT_EQ(stiffness.at(0.5, 0.5), 3 * 0.375);
  EXPECT_EQ(strength.at(0.5, 0.5), 100);
  EXPECT_FALSE(strength.empty());
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.at(1, 2), 1);
}

TEST(Scattering, RefusesWhatIsNoLatticeOfFactors) {
  const auto refuse = [](const std::string& content, const char* text) {
    ScatterFields fields;
    *fields.Add() = scatter(scene::Scatter::STRENGTH, kNames + "0,0,1\n");
    *fields.Add() = scatter(scene::Scatter::STRENGTH, content);
    test::expect_refusal([&] { Scattering(fields, scene::Scatter::STRENGTH, "particles.scatter"); },
                         "particles.scatter[1].path", text);
  };
  refuse("", "holds no row of values; give the line `x_m,y_m,factor` and at least one row below it");
  refuse(kNames, "holds no row of values");
  refuse("x,y,f\n0,0,1\n", "field.csv:1: `x,y,f` is not the line of names, `x_m,y_m,factor`; begin with it");
  refuse(kNames + "0,0\n", "field.csv:2: has 2 values, but there are 3 columns");
  refuse(kNames + "0,0,nan\n", "field.csv:2: `nan` is not a number");
  refuse(kNames + "0,0,1e999\n", "field.csv:2:");
  refuse(kNames + "0,0,1\n1,0,0\n", "field.csv: the factor at (1, 0) m is 0; give one above 0");
  refuse(kNames + "0,0,-2\n", "the factor at (0, 0) m is -2");
  refuse(kNames + "0,0,1\n1,0,1\n0,1,1\n",
         "the node at (1, 1) m has no row; give a factor for every x at every y");
  refuse(kNames + "0,0,1\n1,1,1\n", "the node at (1, 0) m has no row");
  refuse(kNames + "0,0,1\n1,0,1\n0,0,2\n", "the node at (0, 0) m stands in two rows; give each node once");
}

}  // namespace
}  // namespace adit::protocol::scattering_test
