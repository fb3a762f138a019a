#include "protocol/motion/records/record_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "protocol/excerpt.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::excerpt;
using protocol::UserError;

constexpr std::string_view kBlanks = " \t";
constexpr char kDosEnd = '\x1a';

// Where the first number of `word` ends: before a sign that does not belong to its exponent.
std::size_t end_of_number(std::string_view word) {
  for (std::size_t i = 1; i < word.size(); ++i)
    if ((word[i] == '+' || word[i] == '-') &&
        std::string_view("eEdD").find(word[i - 1]) == std::string_view::npos)
      return i;
  return word.size();
}

}  // namespace

void RecordText::refuse(std::size_t line, const std::string& message) const {
  throw UserError("", fmt::format("{}:{}: {}", file, line + 1, message));
}

double RecordText::number(std::size_t line, std::string_view text) const {
  std::string digits(text.starts_with('+') ? text.substr(1) : text);
  std::ranges::replace_if(
      digits, [](char c) { return c == 'd' || c == 'D'; }, 'e');
  double value = 0;
  const char* last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (error == std::errc() && end == last && std::isfinite(value)) return value;
  if (std::ranges::count(digits, '.') > 1 && digits.find_first_not_of("0123456789.e+-") == std::string::npos)
    refuse(line, excerpt(text) + " is several numbers without a blank between them; separate them");
  refuse(line, excerpt(text) + " is not a number; a number such as `-0.12E-3` is expected");
}

RecordText::Entry RecordText::entry(std::size_t header_lines, std::string_view name) const {
  for (std::size_t i = 0; i < std::min(header_lines, lines.size()); ++i)
    if (lines[i].starts_with(name))
      return {i, protocol::trim(std::string_view(lines[i]).substr(name.size()))};
  refuse(0,
         fmt::format("none of the first {} lines begins with `{}`; give the whole file", header_lines, name));
}

void RecordText::append_numbers(std::size_t line, std::vector<double>& numbers) const {
  std::string_view rest = lines[line];
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (rest.empty()) return;
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
    const std::size_t end = end_of_number(word);
    numbers.push_back(number(line, word.substr(0, end)));
    rest.remove_prefix(end);
  }
}

std::string doubt_of_unit(std::span<const double> values, double factor, std::string_view unit) {
  constexpr double kStrongest = 10 * 9.80665;  // [m/s^2]
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest * factor <= kStrongest) return "";
  return fmt::format("the largest value is {:.4g} {}, beyond any earthquake: correct the unit (gal?)",
                     largest, unit);
}

Motion in_unit(const RecordText& text, std::size_t line, std::string_view unit, double dt,
               std::vector<double> values) {
  const double factor = text.at(line, [&] { return acceleration_unit(unit); });
  if (values.empty()) text.refuse(line, "no values follow; give the whole file");
  if (const std::string doubt = doubt_of_unit(values, factor, unit); !doubt.empty()) text.refuse(line, doubt);
  for (double& value : values) value *= factor;
  return {dt, std::move(values)};
}

RecordText split_text(const std::string& file, const std::string& content) {
  RecordText text{file, {}};
  if (protocol::is_utf16(content)) text.refuse(0, "is text in UTF-16; save it as UTF-8");
  const std::string_view whole = protocol::without_byte_order_mark(content);
  std::istringstream stream{std::string(whole.substr(0, whole.find(kDosEnd)))};
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    text.lines.push_back(line);
  }
  return text;
}

}  // namespace adit::motion
