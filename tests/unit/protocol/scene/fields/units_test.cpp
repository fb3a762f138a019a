#include "protocol/scene/fields/units.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/scene/fields/quantity.hpp"

namespace adit::protocol::units_test {
namespace {

std::string complaint(const std::string& text, const std::string& si_unit) {
  try {
    parse_quantity(text, si_unit);
    return "accepted";
  } catch (const UserError& error) {
    return error.what();
  }
}

// A power of ten costs no rounding: the double is that of the number written out in SI units.
TEST(Quantity, DecimalUnitsGiveTheSameDoubleAsSi) {
  EXPECT_EQ(parse_quantity("30 GPa", "Pa"), 30e9);
  EXPECT_EQ(parse_quantity("2.5 t/m^3", "kg/m^3"), 2500);
  EXPECT_EQ(parse_quantity("10 ms", "s"), 0.01);
  EXPECT_EQ(parse_quantity("8.8 us", "s"), 8.8e-6);
  EXPECT_EQ(parse_quantity("8.8 µs", "s"), 8.8e-6);
  EXPECT_EQ(parse_quantity("0.3 um", "m"), 0.3e-6);
  EXPECT_EQ(parse_quantity("5 MN", "N"), 5e6);
  EXPECT_EQ(parse_quantity("50Hz", "Hz"), 50);
  EXPECT_EQ(parse_quantity("50 1/s", "Hz"), 50);
  EXPECT_EQ(parse_quantity("-9.81 m/s^2", "m/s^2"), -9.81);
  EXPECT_EQ(parse_quantity("-9.81 m s^-2", "m/s^2"), -9.81);
  EXPECT_EQ(parse_quantity("981 gal", "m/s^2"), 9.81);
  EXPECT_EQ(parse_quantity("7 kN/m", "N/m"), 7e3);
  EXPECT_EQ(parse_quantity("7 N/mm^2", "Pa"), 7e6);
  EXPECT_EQ(parse_quantity("7 N * m", "J"), 7);
  EXPECT_EQ(parse_quantity("1.5e3 kg*m/s^2", "N"), 1500);
  EXPECT_EQ(parse_quantity("3 bar", "Pa"), 3e5);
}

// Shares may be written in percent, with the double of the number written out; nothing else may.
TEST(Quantity, SharesMayBeInPercent) {
  EXPECT_EQ(parse_quantity("5 %", ""), 0.05);
  EXPECT_EQ(parse_quantity("0.1%", ""), 0.001);
  EXPECT_EQ(complaint("5 %", "rad"), "`5 %` is written with a unit; an angle such as `30 deg` is expected");
  EXPECT_EQ(complaint("5 %/%", ""),
            "`5 %/%` is written with a unit; a pure number such as `0.25` is expected");
}

// Powers and symbols as tables and headers of records have them.
TEST(Quantity, OtherSpellingsAreTheSameUnits) {
  for (const auto* text : {"-9.81 m/s2", "-9.81 m/s**2", "-9.81 m s-2", "-9.81 m/sec2", "-981 Gal",
                           "-981 gals", "-981 cm/sec/sec"})
    EXPECT_EQ(parse_quantity(text, "m/s^2"), -9.81) << text;
  EXPECT_EQ(parse_quantity("10 msec", "s"), 0.01);
  EXPECT_EQ(parse_quantity("2.5 t/m3", "kg/m^3"), 2500);
  EXPECT_EQ(parse_quantity("50 1/s", "Hz"), 50);
}

TEST(Quantity, OtherUnitsAreConverted) {
  EXPECT_DOUBLE_EQ(parse_quantity("0.3 g", "m/s^2"), 0.3 * 9.80665);
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_quantity("90 deg/s", "rad/s"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(parse_quantity("2 min", "s"), 120);
  EXPECT_DOUBLE_EQ(parse_quantity("36 km/h", "m/s"), 10);
}

TEST(Quantity, BareNumbersAreInTheUnitOfTheField) {
  EXPECT_EQ(parse_quantity("30e9", "Pa"), 30e9);
  EXPECT_EQ(parse_quantity("  +.5 ", "m"), 0.5);
  EXPECT_EQ(parse_quantity("1.", ""), 1);
  EXPECT_EQ(parse_quantity("1.e-2", ""), 0.01);
  EXPECT_EQ(parse_quantity("-0", ""), 0);
  EXPECT_TRUE(std::isinf(parse_quantity("inf", "N")));
  EXPECT_TRUE(std::isinf(parse_quantity(".inf", "N")));
}

TEST(Quantity, AnotherDimensionIsRefusedWithBothNamed) {
  EXPECT_EQ(complaint("30 kg", "Pa"), "`30 kg` is a mass; a pressure such as `30 GPa` is expected");
  EXPECT_EQ(complaint("30 GPa", ""), "`30 GPa` is a pressure; a pure number such as `0.25` is expected");
  EXPECT_EQ(complaint("3 m/m", ""),
            "`3 m/m` is written with a unit; a pure number such as `0.25` is expected");
  EXPECT_EQ(complaint("3 m^7", "s"), "`3 m^7` is another quantity; a time such as `10 ms` is expected");
  EXPECT_EQ(
      complaint("2.5 g/cm^3", "kg/m^3"),
      "`2.5 g/cm^3` is another quantity; a density such as `2.5 t/m^3` is expected (`g` is the standard "
      "gravity; write masses in kg or t)");
}

// An angular velocity given in Hz, or a frequency in rad/s, would be wrong by 2 pi.
TEST(Quantity, AngularVelocityIsNoFrequency) {
  EXPECT_EQ(complaint("50 Hz", "rad/s"),
            "`50 Hz` is a frequency; an angular velocity such as `5 deg/s` is expected");
  EXPECT_EQ(complaint("5 rad/s", "Hz"),
            "`5 rad/s` is an angular velocity; a frequency such as `50 Hz` is expected");
}

TEST(Quantity, UnknownUnitsGetTheNearestOne) {
  EXPECT_EQ(complaint("30 gpa", "Pa"), "unit `gpa` is unknown; did you mean `GPa`?");
  EXPECT_EQ(complaint("30 ?", ""), "unit `?` is unknown");
  EXPECT_THAT(complaint("30 mg", "kg"), ::testing::StartsWith("unit `mg` is unknown"));
  EXPECT_THAT(complaint("0x10", "m"), ::testing::StartsWith("unit `x10` is unknown"));
  EXPECT_THAT(complaint("3 m/", "m"), ::testing::HasSubstr("is incomplete"));
  EXPECT_THAT(complaint("3 m//s", "m"), ::testing::HasSubstr("is incomplete"));
  EXPECT_THAT(complaint("3 m^", "m"), ::testing::HasSubstr("power"));
  EXPECT_THAT(complaint("3 m^0", "m"), ::testing::HasSubstr("power"));
  EXPECT_THAT(complaint("3 m^99999999999", "m"), ::testing::HasSubstr("power"));
  EXPECT_THAT(complaint("3 m^1.5", "m"), ::testing::HasSubstr("unknown"));
  EXPECT_THAT(complaint("3 " + std::string(1000, 'm'), "m"), ::testing::HasSubstr("too long"));
}

TEST(Quantity, WhatIsNoNumberIsRefused) {
  const std::string expected = " is not a number; a length such as `0.5 m` is expected";
  for (const std::string text : {"", " ", "m", "one", "nan", "-nan", "-inf", "infinity", "1,5", "1_000",
                                 "--1", "1.2.3", ".", "e5", "1 2 m"})
    EXPECT_NE(complaint(text, "m"), "accepted") << text;
  for (const std::string text : {"", "nan", "-inf", "1,5", "1.2.3", "--1"})
    EXPECT_EQ(complaint(text, "m"), "`" + text + "`" + expected);
}

TEST(Quantity, NumbersBeyondTheRangeAreRefused) {
  for (const std::string text :
       {"1e309", "-1e309", "1e305 Mm", "1e-400", "1e99999999999999999999", "1e307 min"})
    EXPECT_THAT(complaint(text, text.ends_with("min") ? "s" : "m"), ::testing::HasSubstr("beyond the range"))
        << text;
}

// Printing a value in any known unit and reading it gives the value back.
RC_GTEST_PROP(Quantity, PrintingAndReadingGivesTheValueBack, (double mantissa)) {
  RC_PRE(std::isfinite(mantissa) && std::abs(mantissa) < 1e200 &&
         (mantissa == 0 || std::abs(mantissa) > 1e-200));
  const std::string unit = *rc::gen::elementOf(unit_symbols());
  const int power = *rc::gen::element(-2, -1, 1, 2);
  const std::string whole = unit + "^" + std::to_string(power);
  const Unit parsed = parse_unit(whole);
  const auto& d = parsed.dimension;
  std::string si = "1";
  for (const auto& [name, exponent] :
       {std::pair("m", d.length), std::pair("kg", d.mass), std::pair("s", d.time), std::pair("rad", d.angle)})
    if (exponent != 0) si += std::string("*") + name + "^" + std::to_string(exponent);

  char text[40];
  const std::string number(text, std::to_chars(text, text + sizeof text, mantissa).ptr);
  const double value = parse_quantity(number + " " + whole, si);
  const long double exact = static_cast<long double>(mantissa) * std::pow(10.0L, parsed.decimals) *
                            std::pow(static_cast<long double>(parse_unit(unit).factor), power);
  RC_ASSERT(std::abs(value - exact) <= 1e-15L * std::abs(exact));
}

// No text crashes the parser or gives a NaN.
RC_GTEST_PROP(Quantity, AnyTextGivesANumberOrAUserError, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("0123456789.+-eE^*/ \tmskgPaNHzrdtuinf%,")));
  try {
    RC_ASSERT(!std::isnan(parse_quantity(text, "m")));
  } catch (const UserError&) {
  }
}

}  // namespace
}  // namespace adit::protocol::units_test
