#include "protocol/results/summary.hpp"

#include <stdexcept>
#include <utility>

#include "protocol/results/atomic_file.hpp"

namespace adit::results {

void Summary::set(const std::string& name, nlohmann::ordered_json value) {
  if (values_.contains(name)) throw std::logic_error("the summary holds " + name + " already");
  values_[name] = std::move(value);
}

void Summary::set_origin(const protocol::Origin& origin) {
  set("started", origin.started);
  set("command", origin.command);
  set("folder", origin.folder);
  if (!origin.revision.empty()) set("revision", origin.revision);
  auto inputs = nlohmann::ordered_json::object();
  for (const auto& [path, hash] : origin.inputs) inputs[path] = hash;
  set("inputs", std::move(inputs));
}

void Summary::write(const std::filesystem::path& path) const {
  // dump() writes numbers that are not finite as null.
  using Json = nlohmann::ordered_json;
  replace_file(path, values_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace adit::results
