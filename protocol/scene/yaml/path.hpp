// Paths of scene fields, as errors and `--set` write them: particles.loads[0].force.y
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace adit::protocol {

// A field's name and then, for one element of a list, its number.
struct PathStep {
  std::string name;
  std::optional<std::size_t> index;
};

// Nothing where `path` is not of that form; the empty path has no steps.
std::optional<std::vector<PathStep>> parse_path(std::string_view path);

// `path` one level deeper.
std::string member_path(std::string_view path, std::string_view name);
std::string element_path(std::string_view path, std::size_t index);

}  // namespace adit::protocol
