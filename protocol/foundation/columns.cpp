#include "protocol/foundation/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::foundation {
namespace {

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(protocol::trim(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

}  // namespace

std::vector<std::vector<double>> read_columns(const std::string& file, const std::string& content,
                                              std::span<const std::string> names) {
  const motion::RecordText text = motion::split_text(file, content);
  const std::string heading = fmt::format("{}", fmt::join(names, ","));
  std::vector<std::vector<double>> columns(names.size());
  bool named = false;
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    const std::string_view row = protocol::trim(text.lines[line]);
    if (row.empty() || row.starts_with('#')) continue;
    const auto found = cells(row);
    if (!named) {
      if (!std::ranges::equal(found, names))
        text.refuse(line,
                    protocol::excerpt(row) + " is not the line of names, `" + heading + "`; begin with it");
      named = true;
      continue;
    }
    if (found.size() != names.size())
      text.refuse(line, fmt::format("has {} values, but there are {} columns; give one for each",
                                    found.size(), names.size()));
    for (std::size_t k = 0; k < found.size(); ++k) columns[k].push_back(text.number(line, found[k]));
  }
  if (columns.front().empty())
    text.refuse(0, "holds no row of values; give the line `" + heading + "` and at least one row below it");
  return columns;
}

}  // namespace adit::foundation
