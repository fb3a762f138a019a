// Records of the PEER database.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::excerpt;

constexpr std::size_t kLongestHeader = 20;       // lines that may precede the values; PEER writes four
constexpr std::size_t kLongestHeaderLine = 200;  // characters of a line that are read

// The line that gives count and step, and both as words of that line.
struct Size {
  std::size_t line;
  std::string points, dt, unit;  // of the step
};

std::string header_line(const RecordText& text, std::size_t line) {
  return text.lines[line].substr(0, kLongestHeaderLine);
}

std::optional<Size> size_in(const RecordText& text, std::size_t line) {
  using std::regex;
  static const regex points(R"(\bNPTS\s*[=:]?\s*([-+.\d]\S*?)(?=[,;\s]|$))", regex::icase),
      dt(R"(\bDT\s*[=:]?\s*([-+.\d][-+.\dED]*)\s*(\(?[A-Z]*\)?))", regex::icase),
      numbers_first(R"(^\s*(\S+?)[,\s]+(\S+?)[,\s]+(NPTS\s*,?\s*DT|DT\s*,?\s*NPTS)\s*(\(?[A-Z]*\)?))",
                    regex::icase);
  const std::string words = header_line(text, line);
  std::smatch count, step;
  if (std::regex_search(words, count, points) && std::regex_search(words, step, dt))
    return Size{line, count[1], step[1], step[2]};
  if (!std::regex_search(words, count, numbers_first)) return std::nullopt;
  const bool count_first = protocol::lower_case(count.str(3)).starts_with("npts");
  return Size{line, count[count_first ? 1 : 2], count[count_first ? 2 : 1], count[4]};
}

std::optional<Size> find_size(const RecordText& text) {
  for (std::size_t i = 0; i < std::min(kLongestHeader, text.lines.size()); ++i)
    if (auto size = size_in(text, i)) return size;
  return std::nullopt;
}

// The word that follows "UNITS OF" in a line above the line `end`.
struct UnitWord {
  std::size_t line;
  std::string unit;
};

UnitWord find_unit(const RecordText& text, std::size_t end) {
  static const std::regex unit(R"(\bUNITS?\s+OF\s*[=:]?\s*([^\s,;]+))", std::regex::icase);
  for (std::size_t i = 0; i < end; ++i) {
    const std::string words = header_line(text, i);
    std::smatch found;
    if (!std::regex_search(words, found, unit)) continue;
    std::string word = found[1];
    if (word.ends_with('.')) word.pop_back();
    return {i, word};
  }
  text.refuse(end,
              "no line above states the unit; a line such as `ACCELERATION TIME SERIES IN UNITS OF G` is "
              "expected");
}

double step_of(const RecordText& text, const Size& size) {
  const double step = text.number(size.line, size.dt);
  if (step <= 0) text.refuse(size.line, "DT is " + excerpt(size.dt) + "; a step above 0 s is expected");
  return size.unit.empty() ? step : step * text.at(size.line, [&] { return time_unit(size.unit); });
}

}  // namespace

bool is_at2(const RecordText& text) {
  return protocol::lower_case(text.file).ends_with(".at2") || find_size(text).has_value();
}

Motion parse_at2(const RecordText& text) {
  const auto size = find_size(text);
  if (!size)
    text.refuse(
        0, fmt::format("none of the first {} lines states count and step; a line such as `NPTS = 7500, DT "
                       "= .020 SEC` or `4096 0.0100 NPTS, DT` is expected",
                       kLongestHeader));
  const UnitWord unit = find_unit(text, size->line);
  const double points = text.number(size->line, size->points);
  if (points < 1 || points != std::floor(points))
    text.refuse(size->line, "NPTS is " + excerpt(size->points) + "; a count above 0 is expected");
  const double dt = step_of(text, *size);
  std::vector<double> values;
  for (std::size_t i = size->line + 1; i < text.lines.size(); ++i) text.append_numbers(i, values);
  if (static_cast<double>(values.size()) != points) {
    const double factor = text.at(unit.line, [&] { return acceleration_unit(unit.unit); });
    const std::string doubt = doubt_of_unit(values, factor, unit.unit);
    text.refuse(size->line,
                fmt::format("states {:.0f} points, but {} values follow; correct the count, or get "
                            "the whole file{}{}",
                            points, values.size(), doubt.empty() ? "" : "; moreover, ", doubt));
  }
  return in_unit(text, unit.line, unit.unit, dt, std::move(values));
}

}  // namespace adit::motion
