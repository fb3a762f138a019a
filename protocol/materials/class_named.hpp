// A class of a material by its name in the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::protocol {

// UserError at `path` for a name that no standard knows, with the one that may be meant.
template <class Class>
Class class_named(const std::string& name, std::optional<Class> (*find)(const std::string&),
                  const std::vector<std::string>& names, const std::string& standards,
                  const std::string& path) {
  const auto found = find(name);
  require(found.has_value(), path,
          "is `" + name + "`, expected a class of " + standards + did_you_mean(name, names));
  return *found;
}

}  // namespace adit::protocol
