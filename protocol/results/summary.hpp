// summary.json: what a run says of itself, one flat object whose names end in their units.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace adit::results {

class Summary {
 public:
  // Adds a value, in the order of the calls. Numbers that are not finite become null, bytes that are no
  // UTF-8 are replaced; a name that is set already is a std::logic_error.
  void set(const std::string& name, nlohmann::ordered_json value);

  // Replaces the file in one go.
  void write(const std::filesystem::path& path) const;

 private:
  nlohmann::ordered_json values_ = nlohmann::ordered_json::object();
};

}  // namespace adit::results
