#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::quote;
using protocol::trim;
using protocol::UserError;

constexpr double kStepTolerance = 0.01;

bool is_passed_over(std::string_view line) {
  return trim(line).empty() || trim(line).starts_with('#');
}

std::pair<std::string_view, std::string_view> cells(const RecordText& text, std::size_t line) {
  const std::string_view row = text.lines[line];
  const auto comma = row.find(',');
  if (comma == std::string_view::npos || row.find(',', comma + 1) != std::string_view::npos)
    text.refuse(
        line, quote(row) + " is not two columns; time and acceleration, separated by a comma, are expected");
  return {trim(row.substr(0, comma)), trim(row.substr(comma + 1))};
}

// The unit in a column's name: "m/s^2" for "acceleration_m/s^2", "a [m/s^2]" and "a (m/s^2)"; empty if there
// is none.
std::string_view unit_of(std::string_view name) {
  for (const std::string_view brackets : {"[]", "()"})
    if (const auto open = name.rfind(brackets[0]);
        name.ends_with(brackets[1]) && open != std::string_view::npos)
      return trim(name.substr(open + 1, name.size() - open - 2));
  const auto underscore = name.rfind('_');
  return underscore == std::string_view::npos ? std::string_view() : name.substr(underscore + 1);
}

double time_unit(std::string_view name) {
  const protocol::Unit unit = protocol::parse_unit(name);
  if (unit.dimension != protocol::Dimension{.time = 1})
    throw UserError("", quote(name) + " is not a unit of time; give one such as s or ms");
  return unit.factor * std::pow(10.0, unit.decimals);
}

struct Factors {
  double time, acceleration;
  std::string_view unit;  // unit of the acceleration
};

Factors read_names(const RecordText& text, std::size_t line) {
  const auto [time, acceleration] = cells(text, line);
  for (const auto name : {time, acceleration})
    if (unit_of(name).empty())
      text.refuse(line, quote(name) +
                            " states no unit; a name such as `time_s` or `acceleration [m/s^2]` is expected");
  try {
    return {time_unit(unit_of(time)), acceleration_unit(unit_of(acceleration)), unit_of(acceleration)};
  } catch (const UserError& error) {
    text.refuse(line, error.what());
  }
}

struct Row {
  std::size_t line;
  double time;
};

// The mean step, after a check that every step differs from it by at most kStepTolerance.
double equal_step(const RecordText& text, const std::vector<Row>& rows) {
  const double dt = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
  if (!(dt > 0))
    text.refuse(rows.back().line,
                fmt::format("the last time, {:.6g} s, is not after the first, {:.6g} s; order "
                            "the rows by time",
                            rows.back().time, rows.front().time));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step = rows[i].time - rows[i - 1].time;
    if (std::abs(step - dt) > kStepTolerance * dt)
      text.refuse(rows[i].line,
                  fmt::format("is {:.6g} s after the row before, but the mean step is {:.6g} s; give "
                              "the motion at equal steps",
                              step, dt));
  }
  return dt;
}

// Reads a motion in the format that the ending of the file's name tells.
template <class Read>
Motion parse(const std::filesystem::path& file, const Read& text) {
  const std::string end = protocol::lower_case(file.extension().string());
  if (end == ".at2") return parse_at2(text());
  if (end == ".csv") return parse_csv(text());
  throw UserError("",
                  file.string() + ": ends neither in .AT2 nor in .csv; give a PEER record or a table in CSV");
}

}  // namespace

Motion read_csv(const std::filesystem::path& file) {
  return parse_csv(read_text(file));
}

Motion parse_csv(const RecordText& text) {
  std::size_t line = 0;
  while (line < text.lines.size() && is_passed_over(text.lines[line])) ++line;
  if (line == text.lines.size())
    text.refuse(0,
                "holds no motion; a line of names such as `time_s,acceleration_m/s^2` and rows are expected");
  const std::size_t names = line;
  const Factors factors = read_names(text, names);

  Motion motion;
  std::vector<Row> rows;
  for (++line; line < text.lines.size(); ++line) {
    if (is_passed_over(text.lines[line])) continue;
    const auto [time, acceleration] = cells(text, line);
    rows.push_back({line, text.number(line, time) * factors.time});
    motion.acceleration.push_back(text.number(line, acceleration) * factors.acceleration);
  }
  if (rows.size() < 2)
    text.refuse(text.lines.size() - 1,
                fmt::format("has {} rows of values; at least two are expected", rows.size()));
  motion.dt = equal_step(text, rows);
  if (const auto doubt = doubt_of_unit(motion, factors.acceleration, factors.unit); !doubt.empty())
    text.refuse(names, doubt);
  return motion;
}

Motion read_motion(const std::filesystem::path& file) {
  return parse(file, [&] { return read_text(file); });
}

Motion parse_motion(const std::string& file, const std::string& content) {
  return parse(file, [&] { return split_text(file, content); });
}

}  // namespace adit::motion
