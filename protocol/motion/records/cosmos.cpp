// Records in the format of COSMOS (strongmotion.org, version 1.20) and in that of CSMIP before it, V1 and V2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "protocol/motion/records/record_text.hpp"
#include "protocol/text.hpp"

namespace adit::motion {
namespace {

using protocol::quote;

constexpr std::size_t kLongestLine = 200;
// Entries of the real header that give the step in s and in ms, and the number that stands for an unknown
// one.
constexpr std::size_t kSeconds = 34, kMilliseconds = 62;
constexpr double kUnknown = -999;

// A line that says what the numbers below it are.
struct Block {
  std::size_t line;
  double count;
  double step;  // [s]; 0 where the real header states it
  std::string unit;
  std::size_t width;  // characters of a number
};

std::string beginning_of(const RecordText& text, std::size_t line) {
  return text.lines[line].substr(0, kLongestLine);
}

std::size_t width_of(const RecordText& text, std::size_t line) {
  static const std::regex format(R"(\(\s*\d*\s*[EFGID]([1-9]\d?)(\.\d+)?[^)]*\)\s*$)", std::regex::icase);
  const std::string words = beginning_of(text, line);
  std::smatch found;
  if (!std::regex_search(words, found, format))
    text.refuse(line, "ends without a format of the values; one such as `(8f10.3)` is expected");
  return std::stoul(found[1]);
}

std::optional<Block> block_at(const RecordText& text, std::size_t line) {
  using std::regex;
  static const regex csmip(
      R"(^\s*(\d+)\s+points of accel\S*\s+data equally spaced at\s*(\S+)\s*(\S+?),?\s+in\s+([^\s,]+))",
      regex::icase),
      cosmos(R"(^\s*(\d+)\s+acceleration\s+(?:pts|points),.*units\s*=\s*([^\s,(]+))", regex::icase);
  const std::string words = beginning_of(text, line);
  if (words.find_first_of("cC") == std::string::npos)
    return std::nullopt;  // values only, by far the most lines
  std::smatch found;
  if (std::regex_search(words, found, csmip))
    return Block{line, text.number(line, found.str(1)),
                 text.number(line, found.str(2)) * text.at(line, [&] { return time_unit(found.str(3)); }),
                 found[4], width_of(text, line)};
  if (std::regex_search(words, found, cosmos))
    return Block{line, text.number(line, found.str(1)), 0, found[2], width_of(text, line)};
  return std::nullopt;
}

// The numbers from `line` on, each in its `width`, as many as `count`.
std::vector<double> numbers_from(const RecordText& text, std::size_t line, std::size_t width, double count) {
  std::vector<double> numbers;
  const auto enough = [&] { return static_cast<double>(numbers.size()) >= count; };
  for (; line < text.lines.size() && !enough(); ++line)
    for (std::size_t at = 0; at < text.lines[line].size() && !enough(); at += width) {
      const std::string_view word = protocol::trim(std::string_view(text.lines[line]).substr(at, width));
      if (!word.empty()) numbers.push_back(text.number(line, word));
    }
  return numbers;
}

// The step that the last real header above the block states.
double step_in_header(const RecordText& text, const Block& block) {
  static const std::regex header(R"(^\s*(\d+)\s+Real-header values follow)", std::regex::icase);
  for (std::size_t line = block.line; line-- > 0;) {
    const std::string words = beginning_of(text, line);
    std::smatch found;
    if (!std::regex_search(words, found, header)) continue;
    const auto entries = numbers_from(text, line + 1, width_of(text, line),
                                      std::min(text.number(line, found.str(1)), double{kMilliseconds}));
    const auto entry = [&](std::size_t k) { return k <= entries.size() ? entries[k - 1] : kUnknown; };
    if (entry(kSeconds) > 0) return entry(kSeconds);
    if (entry(kMilliseconds) > 0) return entry(kMilliseconds) / 1000;
    text.refuse(line,
                fmt::format("states no step: neither entry {} of the real header, in s, nor {}, in ms, is "
                            "above 0",
                            kSeconds, kMilliseconds));
  }
  text.refuse(block.line, "has no real header above, which states the step; give the whole file");
}

std::vector<Block> blocks_in(const RecordText& text) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < text.lines.size(); ++i)
    if (auto block = block_at(text, i)) blocks.push_back(*block);
  return blocks;
}

const Block& chosen(const RecordText& text, const std::vector<Block>& blocks, const std::string& channel) {
  if (channel.empty() && blocks.size() == 1) return blocks.front();
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (channel == fmt::format("{}", k + 1)) return blocks[k];
  text.refuse(blocks.front().line,
              fmt::format("is the first of {} channels of acceleration; give the number of one as `column`",
                          blocks.size()));
}

}  // namespace

bool is_cosmos(const RecordText& text) {
  return !blocks_in(text).empty();
}

Motion parse_cosmos(const RecordText& text, const std::string& channel) {
  const auto blocks = blocks_in(text);
  if (blocks.empty()) text.refuse(0, "no line says where an acceleration begins; give a file V1 or V2");
  const Block& block = chosen(text, blocks, channel);
  const double dt = block.step > 0 ? block.step : step_in_header(text, block);
  auto values = numbers_from(text, block.line + 1, block.width, block.count);
  if (static_cast<double>(values.size()) != block.count)
    text.refuse(block.line, fmt::format("states {:.0f} values, but {} follow; get the whole file",
                                        block.count, values.size()));
  return in_unit(text, block.line, block.unit, dt, std::move(values));
}

}  // namespace adit::motion
