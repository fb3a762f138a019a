#include "protocol/motion/records/record_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::motion {

using protocol::quote;
using protocol::UserError;

void RecordText::refuse(std::size_t line, const std::string& message) const {
  throw UserError("", fmt::format("{}:{}: {}", file, line + 1, message));
}

double RecordText::number(std::size_t line, std::string_view text) const {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    refuse(line, quote(text) + " is not a number; a number such as `-0.12E-3` is expected");
  return value;
}

std::string doubt_of_unit(const Motion& motion, double factor, std::string_view unit) {
  constexpr double kStrongest = 10 * 9.80665;  // [m/s^2]
  double largest = 0;
  for (const double a : motion.acceleration) largest = std::max(largest, std::abs(a));
  if (largest <= kStrongest) return "";
  return fmt::format("the largest value is {:.4g} {}, beyond any earthquake: correct the unit (gal?)",
                     largest / factor, unit);
}

RecordText split_text(const std::string& file, const std::string& content) {
  RecordText text{file, {}};
  if (protocol::is_utf16(content)) text.refuse(0, "is text in UTF-16; save it as UTF-8");
  std::istringstream stream{std::string(protocol::without_byte_order_mark(content))};
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    text.lines.push_back(line);
  }
  return text;
}

RecordText read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (std::filesystem::is_directory(file) || !stream)
    throw UserError("", file.string() + ": cannot be read; give the path of a record");
  return split_text(file.string(), {std::istreambuf_iterator<char>(stream), {}});
}

}  // namespace adit::motion
