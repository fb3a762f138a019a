#include "protocol/scene/fields/path.hpp"

#include <charconv>

namespace adit::protocol {
namespace {

std::optional<PathStep> parse_step(std::string_view text) {
  const std::size_t bracket = text.find('[');
  PathStep step{std::string(text.substr(0, bracket)), {}};
  if (step.name.empty() || step.name.find(']') != std::string::npos) return {};
  if (bracket == std::string_view::npos) return step;
  std::size_t index = 0;
  const char* end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data() + bracket + 1, end, index);
  if (error != std::errc() || after + 1 != end || *after != ']') return {};
  step.index = index;
  return step;
}

}  // namespace

std::optional<std::vector<PathStep>> parse_path(std::string_view path) {
  std::vector<PathStep> steps;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const auto step = parse_step(path.substr(0, dot));
    if (!step || dot + 1 == path.size()) return {};
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
