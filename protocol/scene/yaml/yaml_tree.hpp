// YAML text as a tree of values with their places in the text. It is independent of the scene's fields.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace adit::protocol {

// A file with line and column (from 1), or something without lines (line 0), such as a `--set` argument.
struct Place {
  std::shared_ptr<const std::string> source;
  int line = 0;
  int column = 0;
  std::string text() const;  // "cases/x.yaml:12:5"
};

struct YamlValue {
  enum class Kind { kNull, kScalar, kList, kMapping };
  Kind kind = Kind::kNull;
  Place place;                      // where the value stands; for a member of a mapping, where its key stands
  std::string key;                  // key of a member of a mapping
  std::string scalar;               // text of a scalar; of null as it is written, empty where nothing is
  std::vector<YamlValue> children;  // elements of a list; members of a mapping, keys unique

  // The member called `name`; nullptr if there is none.
  const YamlValue* find(std::string_view name) const;
  YamlValue* find(std::string_view name);

  // Whether `null` or `~` is written, which takes away what another layer of the scene gives. A key without
  // a value is more likely a mistake.
  bool takes_away() const { return kind == Kind::kNull && !scalar.empty(); }
};

// Deeper nesting is refused, so that recursive functions on trees cannot exhaust the stack.
constexpr std::size_t kDeepestNesting = 32;

// Values that anchors may hold and aliases repeat, all in all: a few lines of aliases of aliases could stand
// for any number.
constexpr std::size_t kMostRepeated = 200'000;

// Reads a text with anchors (`&name`) and aliases (`*name`); a mapping takes from the mappings that its key
// `<<` gives what it does not give itself. Throws UserError, without a path and with the place in the
// message, if the text is not exactly one YAML document of scalars, lists and mappings with unique names as
// keys. Tags are refused.
YamlValue parse_yaml(const std::string& text, const std::string& source);

// The error in one line, "cases/x.yaml:12:5: particles.packing.radius: is -0.1 m, …"; the path may be empty.
[[noreturn]] void refuse_at(const Place& place, std::string_view path, std::string_view message);

}  // namespace adit::protocol
