// summary.json: the figures of a run, in one flat object whose names end in their units.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "protocol/scene/origin.hpp"

namespace adit::results {

class Summary {
 public:
  // Adds a value; the file lists them in the order of the calls. Numbers that are not finite become null, and
  // bytes that are not UTF-8 are replaced. Throws std::logic_error if the name is set already.
  void set(const std::string& name, nlohmann::ordered_json value);

  bool has(const std::string& name) const { return values_.contains(name); }

  // Adds where the results come from: the revision only where it is known.
  void set_origin(const protocol::Origin& origin);

  // Replaces the file as a whole (atomic_file.hpp).
  void write(const std::filesystem::path& path) const;

 private:
  nlohmann::ordered_json values_ = nlohmann::ordered_json::object();
};

}  // namespace adit::results
