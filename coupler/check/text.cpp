#include "coupler/check/text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "protocol/standard_streams.hpp"

namespace adit::coupler {
namespace {

constexpr std::size_t kLabel = 19;  // width of a label

}  // namespace

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, ",");
  return digits;
}

std::string memory(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", bytes / 1e3);
  if (bytes < 1e7) return fmt::format("{:.1f} MB", bytes / 1e6);
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string clock_time(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return seconds < 100 * 3600 ? fmt::format("{:.1f} h", seconds / 3600)
                              : fmt::format("{:.0f} days", seconds / 86400);
}

void print_line(const std::string& label, const std::string& text) {
  protocol::print(fmt::format("{:{}}{}\n", label, kLabel, text));
}

void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  widths[0] = std::max(widths[0] + 2, kLabel);
  for (const auto& row : rows) {
    std::string line = fmt::format("{:{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i)
      line += fmt::format("{}{:>{}}", i > 1 ? "  " : "", row[i], widths[i]);
    protocol::print(line + "\n");
  }
}

}  // namespace adit::coupler
