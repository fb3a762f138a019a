// Records as tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::excerpt;
using protocol::trim;
using protocol::UserError;

constexpr double kStepTolerance = 0.01;

bool is_passed_over(std::string_view line) {
  return trim(line).empty() || trim(line).starts_with('#');
}

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == cell.back() && (cell[0] == '"' || cell[0] == '\'');
  return trim(quoted ? cell.substr(1, cell.size() - 2) : cell);
}

std::vector<std::string_view> cells_between(std::string_view row, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = row.find(separator);
    cells.push_back(unquoted(trim(row.substr(0, end))));
    if (end == std::string_view::npos) return cells;
    row.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> words_of(std::string_view row) {
  std::vector<std::string_view> words;
  for (row = trim(row); !row.empty(); row = trim(row)) {
    words.push_back(unquoted(row.substr(0, row.find_first_of(" \t"))));
    row.remove_prefix(std::min(row.find_first_of(" \t"), row.size()));
  }
  return words;
}

// The separator of a line of names: a blank stands inside of `Time (s)`, too, where another one is there.
char separator_of(std::string_view names) {
  for (const char separator : {',', ';', '\t'})
    if (names.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

std::vector<std::string_view> cells(std::string_view row, char separator) {
  return separator == ' ' ? words_of(row) : cells_between(row, separator);
}

bool begins_with_number(std::string_view row) {
  return row.find_first_of("0123456789") == row.find_first_not_of("+-. \t\"");
}

template <class Parse>
std::optional<double> parsed(const Parse& parse, std::string_view unit) {
  try {
    return parse(unit);
  } catch (const UserError&) {
    return std::nullopt;
  }
}

// A column's name and the unit in it: "m/s^2" for "acceleration_m/s^2", "a [m/s^2]" and "a (m/s^2)",
// "m_per_s2" for "acceleration_m_per_s2"; empty if there is none.
struct Name {
  std::string_view name, unit;
};

Name name_of(std::string_view cell) {
  for (const std::string_view brackets : {"[]", "()"})
    if (const auto open = cell.rfind(brackets[0]);
        cell.ends_with(brackets[1]) && open != std::string_view::npos)
      return {trim(cell.substr(0, open)), trim(cell.substr(open + 1, cell.size() - open - 2))};
  for (std::size_t at = cell.find('_'); at != std::string_view::npos; at = cell.find('_', at + 1))
    if (const auto unit = cell.substr(at + 1); parsed(acceleration_unit, unit) || parsed(time_unit, unit))
      return {cell.substr(0, at), unit};
  const auto last = cell.rfind('_');
  if (last == std::string_view::npos) return {cell, ""};
  return {cell.substr(0, last), cell.substr(last + 1)};
}

struct Columns {
  std::optional<std::size_t> time;  // none where the scene states the step
  double time_factor = 1;           // [s]
  std::size_t acceleration;
  std::string unit;
};

bool is_called(std::string_view cell, const std::string& name) {
  const std::string wanted = protocol::lower_case(name);
  return protocol::lower_case(cell) == wanted || protocol::lower_case(name_of(cell).name) == wanted;
}

std::size_t only_acceleration(const RecordText& text, std::size_t line,
                              const std::vector<std::string_view>& names, std::size_t first) {
  std::vector<std::size_t> found;
  for (std::size_t k = first; k < names.size(); ++k)
    if (parsed(acceleration_unit, name_of(names[k]).unit)) found.push_back(k);
  if (found.size() == 1) return found[0];
  if (names.size() == first + 1) return first;  // its unit is refused, or given by the scene
  text.refuse(line,
              fmt::format("has {} columns of acceleration; give the name of one as `column`, such as {}",
                          found.size(), excerpt(names[found.empty() ? first : found[0]])));
}

Columns columns_of(const RecordText& text, std::size_t line, const std::vector<std::string_view>& names,
                   const RecordKeys& keys) {
  Columns columns{};
  if (keys.time_step == 0) {
    const Name time = name_of(names[0]);
    if (time.unit.empty())
      text.refuse(line, excerpt(names[0]) + " states no unit; a name such as `time_s` is expected");
    columns.time = 0;
    columns.time_factor = text.at(line, [&] { return time_unit(time.unit); });
  }
  const std::size_t first = columns.time ? 1 : 0;
  if (names.size() == first) text.refuse(line, "names no column of acceleration besides the time");
  if (keys.column.empty()) {
    columns.acceleration = only_acceleration(text, line, names, first);
  } else {
    const auto found =
        std::ranges::find_if(names, [&](std::string_view cell) { return is_called(cell, keys.column); });
    if (found == names.end())
      text.refuse(line, fmt::format("has no column `{}`; its columns are {}", keys.column,
                                    excerpt(fmt::format("{}", fmt::join(names, ", ")))));
    columns.acceleration = static_cast<std::size_t>(found - names.begin());
  }
  const std::string_view name = names[columns.acceleration], unit = name_of(name).unit;
  if (unit.empty() && keys.unit.empty())
    text.refuse(line, excerpt(name) +
                          " states no unit; a name such as `acceleration [m/s^2]` is expected, or `unit`");
  columns.unit = keys.unit.empty() ? unit : keys.unit;
  text.at(line, [&] { return acceleration_unit(columns.unit); });
  return columns;
}

struct Row {
  std::size_t line;
  double time;
};

// The mean step, after a check that every step differs from it by at most kStepTolerance, and that the motion
// begins where its time does.
double equal_step(const RecordText& text, const std::vector<Row>& rows) {
  if (rows.size() < 2)
    text.refuse(text.lines.size() - 1,
                fmt::format("has {} rows of values; at least two are expected", rows.size()));
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
  const double first = rows.front().time / dt;
  if (first < -kStepTolerance || first > 1 + kStepTolerance)
    text.refuse(rows.front().line,
                fmt::format("the first time is {:.6g} s; let the times begin at 0 s", rows.front().time));
  return dt;
}

Motion without_names(const RecordText& text, std::size_t line, const RecordKeys& keys) {
  if (keys.time_step == 0 || keys.unit.empty())
    text.refuse(line,
                "has no line of names above; begin with one such as `time_s,acceleration_m/s^2`, or state "
                "`time_step` "
                "and `unit` of a file of values only");
  if (words_of(text.lines[line]).size() == 2 || separator_of(text.lines[line]) != ' ')
    text.refuse(line, "has several columns; begin with a line of names such as `time_s,acceleration_m/s^2`");
  std::vector<double> values;
  for (std::size_t i = line; i < text.lines.size(); ++i)
    if (!is_passed_over(text.lines[i])) text.append_numbers(i, values);
  return in_unit(text, line, keys.unit, keys.time_step, std::move(values));
}

}  // namespace

Motion parse_table(const RecordText& text, const RecordKeys& keys) {
  std::size_t line = 0;
  while (line < text.lines.size() && is_passed_over(text.lines[line])) ++line;
  if (line == text.lines.size())
    text.refuse(0,
                "holds no motion; a line of names such as `time_s,acceleration_m/s^2` and rows are expected");
  if (begins_with_number(text.lines[line])) return without_names(text, line, keys);
  const std::size_t names_line = line;
  const char separator = separator_of(text.lines[line]);
  const auto names = cells(text.lines[line], separator);
  const Columns columns = columns_of(text, names_line, names, keys);

  std::vector<Row> rows;
  std::vector<double> values;
  for (++line; line < text.lines.size(); ++line) {
    if (is_passed_over(text.lines[line])) continue;
    const auto row = cells(text.lines[line], separator);
    if (row.size() != names.size())
      text.refuse(line, fmt::format("has {} values, but there are {} columns; give one for each", row.size(),
                                    names.size()));
    if (columns.time) rows.push_back({line, text.number(line, row[*columns.time]) * columns.time_factor});
    values.push_back(text.number(line, row[columns.acceleration]));
  }
  const double dt = columns.time ? equal_step(text, rows) : keys.time_step;
  return in_unit(text, names_line, columns.unit, dt, std::move(values));
}

}  // namespace adit::motion
