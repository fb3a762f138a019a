#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "dem_server/model/placement/placed_table.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/model/placement/written_numbers.hpp"
#include "protocol/errors.hpp"
#include "protocol/excerpt.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::excerpt;

constexpr double kGroupNumbersEnd = 1e6;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.emplace_back(protocol::trim(cell));
  if (line.ends_with(',')) cells.emplace_back();
  return cells;
}

class Table {
 public:
  Table(const std::string& content, const std::string& path)
      : stream_(std::string(protocol::without_byte_order_mark(content))), path_(path) {
    if (protocol::is_utf16(content)) throw protocol::UserError(path, "is text in UTF-16; save it as UTF-8");
  }

  // The next line that is not empty, in cells; without its end.
  bool next(std::vector<std::string>& cells) {
    for (std::string line; std::getline(stream_, line);) {
      ++number_;
      if (line.ends_with('\r')) line.pop_back();
      if (protocol::trim(line).empty()) continue;
      cells = split(line);
      return true;
    }
    return false;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw protocol::UserError(path_, fmt::format("line {}: {}", number_, message));
  }

  double number(const std::string& text) const {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || after != end || !std::isfinite(value))
      refuse(excerpt(text) + " is not a number; write one such as 0.05");
    return value;
  }

 private:
  std::istringstream stream_;
  std::string path_;
  std::size_t number_ = 0;
};

const std::array<std::string, 4> kColumns{"x_m", "y_m", "radius_m", "group"};

// Which column holds each of kColumns; -1 for `group` where there is none.
std::array<int, 4> read_heading(const Table& table, const std::vector<std::string>& heading) {
  std::array<int, 4> place{-1, -1, -1, -1};
  for (std::size_t k = 0; k < heading.size(); ++k) {
    const auto known = std::ranges::find(kColumns, heading[k]);
    if (known == kColumns.end())
      table.refuse(excerpt(heading[k]) +
                   " is no column of particles, which are x_m, y_m, radius_m and group" +
                   protocol::did_you_mean(heading[k], kColumns));
    int& at = place[static_cast<std::size_t>(known - kColumns.begin())];
    if (at >= 0) table.refuse("two columns are named " + excerpt(heading[k]) + "; keep one");
    at = static_cast<int>(k);
  }
  for (std::size_t c = 0; c < 3; ++c)
    if (place[c] < 0)
      table.refuse("the heading has no column `" + kColumns[c] + "`; begin the file with x_m,y_m,radius_m");
  return place;
}

}  // namespace

std::optional<std::string> wrong_with_disc(double x, double y, double radius) {
  if (!(radius > 0)) return fmt::format("the radius is {} m; give one above 0", radius);
  if (!(radius >= kSmallestRadius && radius <= kLargestPlace))
    return fmt::format("the radius is {} m; give one from {:g} to {:g} m", radius, kSmallestRadius,
                       kLargestPlace);
  if (!(std::abs(x) <= kLargestPlace && std::abs(y) <= kLargestPlace))
    return fmt::format("the place is ({}, {}) m; give one within {:g} m of the origin", x, y, kLargestPlace);
  return std::nullopt;
}

PlacedDiscs read_csv(const std::string& content, const std::string& path) {
  Table table(content, path);
  std::vector<std::string> cells;
  if (!table.next(cells))
    throw protocol::UserError(path, "is empty; give a heading x_m,y_m,radius_m and a line for each particle");
  const auto place = read_heading(table, cells);
  const std::size_t columns = cells.size();
  PlacedDiscs placed;
  WrittenNumbers x, y, radius;
  while (table.next(cells)) {
    if (cells.size() != columns)
      table.refuse(
          fmt::format("has {} values, the heading {} columns; give one for each", cells.size(), columns));
    const auto cell = [&](std::size_t column) { return cells[static_cast<std::size_t>(place[column])]; };
    const auto value = [&](std::size_t column, WrittenNumbers& written) {
      const double number = table.number(cell(column));
      written.add(cell(column), number);
      return number;
    };
    placed.discs.x.push_back(value(0, x));
    placed.discs.y.push_back(value(1, y));
    placed.discs.radius.push_back(value(2, radius));
    if (const auto wrong =
            wrong_with_disc(placed.discs.x.back(), placed.discs.y.back(), placed.discs.radius.back()))
      table.refuse(*wrong);
    if (place[3] < 0) continue;
    const double group = table.number(cell(3));
    if (!(group >= 0 && group < kGroupNumbersEnd && group == std::floor(group)))
      table.refuse(fmt::format("the group is {}; give a whole number from 0", group));
    placed.number.push_back(static_cast<std::uint32_t>(group));
  }
  placed.x_rounding = x.rounding();
  placed.y_rounding = y.rounding();
  placed.radius_rounding = radius.rounding();
  return placed;
}

}  // namespace adit::dem
