#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/records/record_text.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::quote;

constexpr std::size_t kLongestHeader = 20;       // lines that may precede the values; PEER writes four
constexpr std::size_t kLongestHeaderLine = 200;  // characters of a line that are read

struct Header {
  std::size_t line;  // the line with count and step, which the values follow
  std::size_t unit_line;
  std::string unit;
  double points;
  double dt;
};

// The words of a line in capitals, separated by blanks, commas, semicolons and equals signs.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line.substr(0, kLongestHeaderLine)) {
    if (std::string_view(" \t,;=").find(c) == std::string_view::npos)
      words.back() += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// The line that gives count and step, and both as the words of that line.
struct Size {
  std::size_t line;
  std::string points, dt;
};
Size find_size(const RecordText& text) {
  for (std::size_t i = 0; i < std::min(kLongestHeader, text.lines.size()); ++i) {
    const auto words = words_of(text.lines[i]);
    if (words.size() < 4) continue;
    if (words[0] == "NPTS" && words[2] == "DT") return {i, words[1], words[3]};
    if (words[2] == "NPTS" && words[3] == "DT") return {i, words[0], words[1]};
  }
  text.refuse(0,
              fmt::format("none of the first {} lines states count and step; a line such as `NPTS = 7500, DT "
                          "= .020 SEC` or `4096 0.0100 NPTS, DT` is expected",
                          kLongestHeader));
}

// The word that follows "UNITS OF" in a line above the line `end`.
struct UnitWord {
  std::size_t line;
  std::string unit;
};
UnitWord find_unit(const RecordText& text, std::size_t end) {
  for (std::size_t i = 0; i < end; ++i) {
    const auto words = words_of(text.lines[i]);
    for (std::size_t k = 2; k < words.size(); ++k) {
      if (words[k - 2] != "UNITS" || words[k - 1] != "OF") continue;
      std::string unit = words[k];
      if (unit.ends_with('.')) unit.pop_back();
      return {i, unit};
    }
  }
  text.refuse(end,
              "no line above states the unit; a line such as `ACCELERATION TIME SERIES IN UNITS OF G` is "
              "expected");
}

Header read_header(const RecordText& text) {
  const Size size = find_size(text);
  const UnitWord unit = find_unit(text, size.line);
  const Header header{size.line, unit.line, unit.unit, text.number(size.line, size.points),
                      text.number(size.line, size.dt)};
  if (header.points < 1 || header.points != std::floor(header.points))
    text.refuse(header.line, "NPTS is " + quote(size.points) + "; a count above 0 is expected");
  if (header.dt <= 0) text.refuse(header.line, "DT is " + quote(size.dt) + "; a step above 0 s is expected");
  return header;
}

double unit_factor(const RecordText& text, const Header& header) {
  try {
    return acceleration_unit(header.unit);
  } catch (const protocol::UserError& error) {
    text.refuse(header.unit_line, error.what());
  }
}

}  // namespace

Motion read_at2(const std::filesystem::path& file) {
  return parse_at2(read_text(file));
}

Motion parse_at2(const RecordText& text) {
  const Header header = read_header(text);
  const double factor = unit_factor(text, header);

  Motion motion{header.dt, {}};
  for (std::size_t i = header.line + 1; i < text.lines.size(); ++i) {
    std::istringstream words(text.lines[i]);
    for (std::string word; words >> word;) motion.acceleration.push_back(text.number(i, word) * factor);
  }
  const std::string unit_doubt = doubt_of_unit(motion, factor, header.unit);
  if (static_cast<double>(motion.acceleration.size()) != header.points)
    text.refuse(header.line,
                fmt::format("states {:.0f} points, but {} values follow; correct the count, or get "
                            "the whole file{}{}",
                            header.points, motion.acceleration.size(),
                            unit_doubt.empty() ? "" : "; moreover, ", unit_doubt));
  if (!unit_doubt.empty()) text.refuse(header.unit_line, unit_doubt);
  return motion;
}

}  // namespace adit::motion
