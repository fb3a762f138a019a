#include "protocol/scene/study.hpp"

#include "protocol/errors.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/reader.hpp"
#include "protocol/scene/yaml/message_reader.hpp"

namespace adit::protocol {

study::Study read_study(const std::string& path) {
  const YamlValue tree = load_yaml(path);
  study::Study study;
  read_message(tree, "", study);
  try {
    check_rules(study);
  } catch (const UserError& error) {
    throw UserError("", nearest(tree, error.path()).place.text() + ": " + error.path() + ": " + error.what());
  }
  return study;
}

}  // namespace adit::protocol
