// Units of measurement: "GPa", "t/m^3", "m/s^2". A unit is a product of symbols with integer powers, joined
// by `*`, `/` or a blank and read from left to right (kN/m/s = kN m^-1 s^-1):
// The power may also stand behind `**` or alone (m/s**2, m/s2). Symbols:
//   m s N Pa J Hz rad gal   with the prefixes T G M k d c m u (also µ) n
//   kg t min h bar deg g %  without prefixes; g is the standard gravity 9.80665 m/s^2, so that 0.3 g is an
//                           acceleration; masses are written in kg and t
// `sec`, `msec` and `gals` are other spellings. The angle is a dimension of its own: 50 Hz is not an angular
// velocity, and 5 rad/s is not a frequency.
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

// Value in SI units = number * 10^decimals * factor. The power of ten is kept apart because it is added to
// the exponent of the decimal text: "8.8 us" then gives the same double as 8.8e-6.
struct Unit {
  Dimension dimension;
  int decimals = 0;
  double factor = 1;
};

// Throws UserError without a path if `text` is not a unit.
Unit parse_unit(std::string_view text);

// Every symbol, with and without prefixes.
const std::vector<std::string>& unit_symbols();

}  // namespace adit::protocol
