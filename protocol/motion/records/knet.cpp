// Records of K-NET and KiK-net (www.kyoshin.bosai.go.jp, "K-NET ASCII format").
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "protocol/excerpt.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::excerpt;
using protocol::trim;

constexpr std::size_t kKnetHeader = 17;  // lines

// The part before the first of the characters, and what follows it.
std::pair<std::string_view, std::string_view> split(std::string_view text, std::string_view characters) {
  const std::size_t at = std::min(text.find_first_of(characters), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

double positive(const RecordText& text, std::size_t line, std::string_view word) {
  const double value = text.number(line, trim(word));
  if (value <= 0) text.refuse(line, excerpt(word) + " is not a number above 0");
  return value;
}

}  // namespace

bool is_knet(const RecordText& text) {
  return text.lines.size() > kKnetHeader && text.lines[0].starts_with("Origin Time");
}

Motion parse_knet(const RecordText& text) {
  const RecordText::Entry frequency = text.entry(kKnetHeader, "Sampling Freq(Hz)"),
                          scale = text.entry(kKnetHeader, "Scale Factor"),
                          duration = text.entry(kKnetHeader, "Duration Time(s)");
  const double dt = 1 / positive(text, frequency.line, split(frequency.value, "Hh").first);
  const auto [most, rest] = split(scale.value, "(");  // 3920(gal)/6182761
  const auto [unit, counts] = split(rest, "/");
  const double factor = positive(text, scale.line, most) / positive(text, scale.line, counts);
  std::vector<double> values;
  for (std::size_t i = kKnetHeader; i < text.lines.size(); ++i) text.append_numbers(i, values);
  const double stated = positive(text, duration.line, duration.value) / dt;
  if (std::abs(static_cast<double>(values.size()) - stated) > 1.5)
    text.refuse(duration.line, fmt::format("states {:.0f} values, but {} follow; get the whole file", stated,
                                           values.size()));
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values) value = factor * (value - mean);
  return in_unit(text, scale.line, split(unit, ")").first, dt, std::move(values));
}

}  // namespace adit::motion
