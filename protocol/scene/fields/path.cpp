#include "protocol/scene/fields/path.hpp"

#include <charconv>

namespace adit::protocol {
namespace {

// Nothing if the text is not a whole number from 0.
std::optional<std::size_t> parse_index(std::string_view text) {
  std::size_t index = 0;
  const char* end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, index);
  if (text.empty() || error != std::errc() || after != end) return {};
  return index;
}

std::optional<PathStep> parse_step(std::string_view text) {
  const std::size_t bracket = text.find('[');
  PathStep step{std::string(text.substr(0, bracket)), {}};
  if (step.name.empty() || step.name.find(']') != std::string::npos) return {};
  if (bracket == std::string_view::npos) return step;
  if (text.back() != ']') return {};
  step.index = parse_index(text.substr(bracket + 1, text.size() - bracket - 2));
  if (!step.index) return {};
  return step;
}

}  // namespace

std::optional<std::vector<PathStep>> parse_path(std::string_view path) {
  std::vector<PathStep> steps;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const std::string_view text = path.substr(0, dot);
    const auto step = parse_step(text);
    if (!step || dot + 1 == path.size()) return {};
    const auto index = parse_index(text);  // `loads.0` for `loads[0]`
    if (index && (steps.empty() || steps.back().index)) return {};
    if (index)
      steps.back().index = index;
    else
      steps.push_back(*step);
    path.remove_prefix(dot == std::string_view::npos ? path.size() : dot + 1);
  }
  return steps;
}

std::string member_path(std::string_view path, std::string_view name) {
  return path.empty() ? std::string(name) : std::string(path) + "." + std::string(name);
}

std::string element_path(std::string_view path, std::size_t index) {
  return std::string(path) + "[" + std::to_string(index) + "]";
}

}  // namespace adit::protocol
