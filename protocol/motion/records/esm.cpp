// Records of the Engineering Strong-Motion database in its ASCII format (esm-db.eu): 64 lines `NAME: value`,
// then a value a line.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::excerpt;

constexpr std::size_t kEsmHeader = 64;  // lines
constexpr std::string_view kStep = "SAMPLING_INTERVAL_S:";

bool is_entry(const std::string& line) {
  return !line.empty() && line.front() >= 'A' && line.front() <= 'Z' && line.find(':') != std::string::npos;
}

}  // namespace

bool is_esm(const RecordText& text) {
  const auto end = text.lines.begin() + static_cast<std::ptrdiff_t>(std::min(kEsmHeader, text.lines.size()));
  return std::any_of(text.lines.begin(), end,
                     [](const std::string& line) { return line.starts_with(kStep); });
}

Motion parse_esm(const RecordText& text) {
  const RecordText::Entry step = text.entry(kEsmHeader, kStep), count = text.entry(kEsmHeader, "NDATA:"),
                          unit = text.entry(kEsmHeader, "UNITS:");
  const double dt = text.number(step.line, step.value), points = text.number(count.line, count.value);
  if (dt <= 0) text.refuse(step.line, "the step is " + excerpt(step.value) + "; one above 0 s is expected");
  std::size_t line = std::max({step.line, count.line, unit.line}) + 1;
  while (line < std::min(kEsmHeader, text.lines.size()) && is_entry(text.lines[line])) ++line;
  std::vector<double> values;
  for (; line < text.lines.size(); ++line) text.append_numbers(line, values);
  if (static_cast<double>(values.size()) != points)
    text.refuse(count.line, fmt::format("states {:.0f} values, but {} follow; get the whole file", points,
                                        values.size()));
  return in_unit(text, unit.line, unit.value, dt, std::move(values));
}

}  // namespace adit::motion
