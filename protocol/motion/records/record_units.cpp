#include <algorithm>
#include <cmath>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::Dimension;
using protocol::excerpt;
using protocol::UserError;

// `text` as scenes write units: small letters, without brackets, a number of the unit behind it in brackets
// (`cm/sec2 (04)`), or a full stop; `m_per_s2` is m/s2.
std::string as_in_scenes(std::string_view text) {
  std::string unit = protocol::lower_case(protocol::trim(text));
  if (!unit.starts_with('(') && !unit.starts_with('[')) unit = unit.substr(0, unit.find_first_of("(["));
  std::erase_if(unit, [](char c) { return std::string_view("()[].\"").find(c) != std::string_view::npos; });
  for (std::size_t at = unit.find("_per_"); at != std::string::npos; at = unit.find("_per_"))
    unit.replace(at, 5, "/");
  return std::string(protocol::trim(unit));
}

double factor_of(std::string_view text, const Dimension& dimension, const std::string& name,
                 const std::string& examples) {
  protocol::Unit unit;
  try {
    unit = protocol::parse_unit(as_in_scenes(text));
  } catch (const UserError&) {
    unit.dimension = {.angle = -1};  // nothing that is asked for
  }
  if (unit.dimension == dimension) return unit.factor * std::pow(10.0, unit.decimals);
  const bool moves =
      unit.dimension == Dimension{.length = 1, .time = -1} || unit.dimension == Dimension{.length = 1};
  throw UserError("", excerpt(text) + " is not a unit of " + name + "; " +
                          (moves ? "give the record of the acceleration" : "give one such as " + examples));
}

}  // namespace

double acceleration_unit(std::string_view unit) {
  return factor_of(unit, {.length = 1, .time = -2}, "acceleration", "g, gal, cm/s^2 or m/s^2");
}

double time_unit(std::string_view unit) {
  return factor_of(unit, {.time = 1}, "time", "s or ms");
}

}  // namespace adit::motion
