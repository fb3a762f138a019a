// YAML text as a tree that remembers where every value was written. It knows nothing of the scene's fields.
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
  Place place;                      // of the key for a member of a mapping, else of the value
  std::string key;                  // of a member of a mapping
  std::string scalar;               // text of a scalar
  std::vector<YamlValue> children;  // elements of a list; members of a mapping, keys unique

  // The member called `name`, nullptr where there is none.
  const YamlValue* find(std::string_view name) const;
  YamlValue* find(std::string_view name);
};

// Deeper nesting than any scene needs is refused, so that nothing that walks a tree exhausts the stack.
constexpr std::size_t kDeepestNesting = 32;

// Throws UserError (no path; the place stands in the message) for text that is not exactly one YAML document
// of scalars, lists and mappings with unique names as keys: aliases and tags are refused too.
YamlValue parse_yaml(const std::string& text, const std::string& source);

// The error in one line, "cases/x.yaml:12:5: particles.packing.radius: is -0.1 m, …"; the path may be empty.
[[noreturn]] void refuse_at(const Place& place, std::string_view path, std::string_view message);

}  // namespace adit::protocol
