#include "protocol/scene/fields/units.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

struct Symbol {
  std::string_view name;
  Unit unit;
  bool prefixable;
};

constexpr Symbol kSymbols[] = {
    {"m", {{.length = 1}}, true},
    {"s", {{.time = 1}}, true},
    {"N", {{.length = 1, .mass = 1, .time = -2}}, true},
    {"Pa", {{.length = -1, .mass = 1, .time = -2}}, true},
    {"J", {{.length = 2, .mass = 1, .time = -2}}, true},
    {"Hz", {{.time = -1}}, true},
    {"rad", {{.angle = 1}}, true},
    {"gal", {{.length = 1, .time = -2}, -2}, true},
    {"kg", {{.mass = 1}}, false},
    {"t", {{.mass = 1}, 3}, false},
    {"min", {{.time = 1}, 0, 60}, false},
    {"h", {{.time = 1}, 0, 3600}, false},
    {"bar", {{.length = -1, .mass = 1, .time = -2}, 5}, false},
    {"deg", {{.angle = 1}, 0, std::numbers::pi / 180}, false},
    {"g", {{.length = 1, .time = -2}, 0, 9.80665}, false},
    {"%", {{}, -2}, false},
};

// Other spellings of symbols, as records and tables have them.
constexpr std::pair<std::string_view, std::string_view> kSpellings[] = {
    {"sec", "s"},   {"secs", "s"},   {"second", "s"}, {"seconds", "s"},
    {"msec", "ms"}, {"gals", "gal"}, {"Gal", "gal"},  {"Gals", "gal"}};

struct Prefix {
  std::string_view name;
  int decimals;
};

// Micro stands three times: as u, and as the micro sign, which has two code points (U+00B5 and U+03BC).
constexpr Prefix kPrefixes[] = {{"", 0},   {"T", 12}, {"G", 9},  {"M", 6},       {"k", 3},       {"d", -1},
                                {"c", -2}, {"m", -3}, {"u", -6}, {"\u00b5", -6}, {"\u03bc", -6}, {"n", -9}};

std::optional<Unit> known_symbol(std::string_view name) {
  for (const auto& [spelling, symbol] : kSpellings)
    if (spelling == name) return known_symbol(symbol);
  for (const Symbol& symbol : kSymbols)
    if (symbol.name == name) return symbol.unit;
  for (const Symbol& symbol : kSymbols) {
    if (!symbol.prefixable || !name.ends_with(symbol.name)) continue;
    const auto* prefix =
        std::ranges::find(kPrefixes, name.substr(0, name.size() - symbol.name.size()), &Prefix::name);
    if (prefix == std::end(kPrefixes)) continue;
    Unit unit = symbol.unit;
    unit.decimals += prefix->decimals;
    return unit;
  }
  return std::nullopt;
}

Unit find_symbol(std::string_view name) {
  if (const auto unit = known_symbol(name)) return *unit;
  throw UserError("", "unit " + quote(name) + " is unknown" + did_you_mean(name, unit_symbols()));
}

void multiply(Unit& product, const Unit& unit, int power) {
  product.dimension.length += power * unit.dimension.length;
  product.dimension.mass += power * unit.dimension.mass;
  product.dimension.time += power * unit.dimension.time;
  product.dimension.angle += power * unit.dimension.angle;
  product.decimals += power * unit.decimals;
  product.factor *= std::pow(unit.factor, power);
}

// The steps of parse_unit. Each reads from the beginning of `rest` and removes what it has read.
std::string_view take_symbol(std::string_view& rest) {
  std::string_view symbol = rest.substr(0, rest.find_first_of(" \t*/^"));
  const std::string_view before_power = symbol.substr(0, symbol.find_first_of("-0123456789"));
  if (known_symbol(before_power)) symbol = before_power;
  rest.remove_prefix(symbol.size());
  return symbol;
}

// The power in `s^2`, `s**2` and `s2`.
int take_power(std::string_view& rest, std::string_view whole) {
  const std::size_t mark = rest.starts_with('^') ? 1 : rest.starts_with("**") ? 2 : 0;
  if (rest.find_first_of("-0123456789") != mark && mark == 0) return 1;
  int power = 0;
  const auto end = std::from_chars(rest.data() + mark, rest.data() + rest.size(), power).ptr;
  if (power == 0 || std::abs(power) > 9)
    throw UserError(
        "", "unit " + quote(whole) + " has a power that is not a whole number from -9 to 9, without 0");
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return power;
}

int take_operator(std::string_view& rest) {  // the sign of the next power
  rest = trim(rest);
  const char op = rest.starts_with('/') ? '/' : '*';
  if (rest.starts_with(op)) rest = trim(rest.substr(1));
  return op == '/' ? -1 : 1;
}

}  // namespace

Unit parse_unit(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  // A text of this length is no unit; the limit also bounds the powers of the product.
  if (text.size() > kLongest) throw UserError("", "unit " + quote(text) + " is too long");
  Unit product;
  std::string_view rest = trim(text);
  int sign = 1;
  do {
    const std::string_view symbol = take_symbol(rest);
    if (symbol.empty())
      throw UserError("", "unit " + quote(text) + " is incomplete; write it as in `kg/m^3`");
    const Unit unit = symbol == "1" ? Unit{} : find_symbol(symbol);
    multiply(product, unit, sign * take_power(rest, text));
    if (rest.empty()) return product;
    sign = take_operator(rest);
  } while (true);
}

const std::vector<std::string>& unit_symbols() {
  static const std::vector<std::string> symbols = [] {
    std::vector<std::string> all;
    for (const Prefix& prefix : kPrefixes)
      for (const Symbol& symbol : kSymbols)
        if (prefix.name.empty() || symbol.prefixable)
          all.push_back(std::string(prefix.name) + std::string(symbol.name));
    return all;
  }();
  return symbols;
}

}  // namespace adit::protocol
