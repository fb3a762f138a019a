// Paths of scene fields, as errors and `--set` write them: particles.loads[0].force.y
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace adit::protocol {

// A field's name and, for an element of a list, its number.
struct PathStep {
  std::string name;
  std::optional<std::size_t> index;
};

// The steps of `path`; nothing if it does not have that form. The empty path has no steps.
std::optional<std::vector<PathStep>> parse_path(std::string_view path);

// The path of a member or an element of what stands at `path`.
std::string member_path(std::string_view path, std::string_view name);
std::string element_path(std::string_view path, std::size_t index);

}  // namespace adit::protocol
