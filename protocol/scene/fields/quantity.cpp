#include "protocol/scene/fields/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "protocol/errors.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

struct Quantity {
  Dimension dimension;
  std::string_view name;
  std::string_view example;
  std::string_view unit = {};  // in which only this quantity is written, of several with the dimension
};

constexpr Quantity kQuantities[] = {
    {{}, "a pure number", "0.25"},
    {{.length = 1}, "a length", "0.5 m"},
    {{.length = 2}, "an area", "0.5 m^2"},
    {{.length = 3}, "a volume", "0.5 m^3"},
    {{.mass = 1}, "a mass", "30 kg"},
    {{.time = 1}, "a time", "10 ms"},
    {{.angle = 1}, "an angle", "30 deg"},
    {{.length = 1, .mass = 1, .time = -2}, "a force", "5 MN"},
    {{.length = -1, .mass = 1, .time = -2}, "a pressure", "30 GPa"},
    {{.length = 2, .mass = 1, .time = -2}, "an energy", "5 kJ"},
    {{.mass = 1, .time = -2}, "a stiffness", "30 GN/m"},
    {{.mass = 1, .time = -2}, "an energy per area", "100 J/m^2", "J/m^2"},
    {{.length = -3, .mass = 1}, "a density", "2.5 t/m^3"},
    {{.time = -1}, "a frequency", "50 Hz"},
    {{.length = 1, .time = -1}, "a velocity", "20 mm/s"},
    {{.length = 1, .time = -2}, "an acceleration", "-9.81 m/s^2"},
    {{.time = -1, .angle = 1}, "an angular velocity", "5 deg/s"},
};

const Quantity* find_quantity(const Dimension& dimension) {
  const auto* found = std::ranges::find(kQuantities, dimension, &Quantity::dimension);
  return found == std::end(kQuantities) ? nullptr : found;
}

const Quantity* find_quantity(std::string_view si_unit) {
  const auto* found = std::ranges::find(kQuantities, si_unit, &Quantity::unit);
  return found == std::end(kQuantities) ? find_quantity(parse_unit(si_unit).dimension) : found;
}

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct Parts {
  std::string_view number;
  std::string_view unit;
};

// Splits `text` into the longest beginning that is a decimal number, and the rest.
Parts split(std::string_view text) {
  std::size_t end = 0;
  const auto digits = [&] {
    const std::size_t begin = end;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - begin;
  };
  const auto one_of = [&](std::string_view set) {
    const bool hit = end < text.size() && set.find(text[end]) != std::string_view::npos;
    if (hit) ++end;
    return hit;
  };
  one_of("+-");
  std::size_t count = digits();
  if (one_of(".")) count += digits();
  if (count == 0) return {{}, text};
  const std::size_t mantissa = end;
  if (one_of("eE")) {
    one_of("+-");
    // An `e` without digits begins the unit.
    if (digits() == 0) end = mantissa;
  }
  return {text.substr(0, end), trim(text.substr(end))};
}

// number * 10^decimals, rounded once, because the power of ten is added to the exponent in the text.
double scale(std::string_view number, int decimals) {
  if (number.starts_with('+')) number.remove_prefix(1);
  const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
  long exponent = 0;
  if (mark < number.size()) {
    const char* begin = number.data() + mark + 1;
    if (*begin == '+') ++begin;
    if (std::from_chars(begin, number.data() + number.size(), exponent).ec != std::errc() ||
        // The bound keeps the sum below from overflowing; no double has such an exponent.
        std::abs(exponent) > 1'000'000'000)
      throw UserError("", quote(number) + " is beyond the range of numbers");
  }
  const std::string text = std::string(number.substr(0, mark)) + "e" + std::to_string(exponent + decimals);
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
    throw UserError("", quote(number) + " is beyond the range of numbers");
  return value;
}

std::string expectation(std::string_view si_unit) {
  return quantity_name(si_unit) + " such as `" + quantity_example(si_unit) + "` is expected";
}

[[noreturn]] void refuse_dimension(std::string_view text, const Unit& found, std::string_view si_unit) {
  const Quantity* quantity = find_quantity(found.dimension);
  const std::string name = found.dimension == Dimension{} ? "written with a unit"
                           : quantity                     ? std::string(quantity->name)
                                                          : "another quantity";
  // A product that holds the standard gravity and is no known quantity, such as g/cm^3, was meant in grams.
  const bool meant_gram = !quantity && found.factor == parse_unit("g").factor;
  throw UserError("", quote(text) + " is " + name + "; " + expectation(si_unit) +
                          (meant_gram ? " (`g` is the standard gravity; write masses in kg or t)" : ""));
}

}  // namespace

double parse_quantity(std::string_view text, std::string_view si_unit) {
  const std::string_view trimmed = trim(text);
  if (trimmed == "inf" || trimmed == ".inf") return std::numeric_limits<double>::infinity();
  const auto [number, unit_text] = split(trimmed);
  // A unit begins with a letter or the micro sign; other signs belong to a mistyped number ("1,5").
  if (number.empty() ||
      (!unit_text.empty() && std::string_view(",.:;_-+'").find(unit_text.front()) != std::string_view::npos))
    throw UserError("", quote(text) + " is not a number; " + expectation(si_unit));
  if (unit_text.empty()) return scale(number, 0);
  const Unit unit = parse_unit(unit_text);
  // A pure number may be a share in percent; other products without a dimension, such as m/m, are mistakes.
  if (si_unit.empty() ? unit_text != "%" : unit.dimension != parse_unit(si_unit).dimension)
    refuse_dimension(text, unit, si_unit);
  const double value = scale(number, unit.decimals) * unit.factor;
  if (!std::isfinite(value)) throw UserError("", quote(text) + " is beyond the range of numbers");
  return value;
}

std::string quantity_name(std::string_view si_unit) {
  if (si_unit.empty()) return "a pure number";
  const Quantity* quantity = find_quantity(si_unit);
  return quantity ? std::string(quantity->name) : "a quantity in " + std::string(si_unit);
}

std::string quantity_example(std::string_view si_unit) {
  if (si_unit.empty()) return "0.25";
  const Quantity* quantity = find_quantity(si_unit);
  return quantity ? std::string(quantity->example) : "1 " + std::string(si_unit);
}

}  // namespace adit::protocol
