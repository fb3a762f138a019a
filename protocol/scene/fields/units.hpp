// Units of measurement: "GPa", "t/m^3", "m/s^2". A unit is a product of symbols with integer powers, joined
// by `*`, `/` or a blank and read from left to right (kN/m/s = kN m^-1 s^-1):
//   m s N Pa J Hz rad gal   with the prefixes T G M k d c m u (also µ) n
//   kg t min h bar deg g    as they are; g is the standard gravity 9.80665 m/s^2, so that 0.3 g is an
//                           acceleration; masses are written in kg and t
// The angle counts as a dimension of its own: 50 Hz is no angular velocity, 5 rad/s is no frequency.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace adit::protocol {

// Exponents of metre, kilogram, second and radian.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  bool operator==(const Dimension&) const = default;
};

// Value in SI units = number * 10^decimals * factor. The power of ten stands apart because it goes into the
// decimal text: "8.8 us" is the same double as 8.8e-6.
struct Unit {
  Dimension dimension;
  int decimals = 0;
  double factor = 1;
};

// Throws UserError (with no path) where `text` is no unit.
Unit parse_unit(std::string_view text);

// Every symbol, with and without prefixes.
const std::vector<std::string>& unit_symbols();

}  // namespace adit::protocol
