#include "protocol/scene/yaml/yaml_tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

// Builds the tree from the parser's events; lists and mappings that have not ended yet wait on a stack.
// The tree is built from events, because the parser's own tree would resolve aliases and nest to any depth
// before either could be refused.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::shared_ptr<const std::string> source) : source_(std::move(source)) {}

  YamlValue take_root() { return std::move(root_); }

  Place place(const YAML::Mark& mark) const {
    return {source_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }

  void OnDocumentStart(const YAML::Mark& mark) override { root_.place = place(mark); }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse_at(place(mark), "", "aliases (`*name`) are not read; write the value itself");
  }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (expects_key()) refuse_key(mark);
    close(open(YamlValue::Kind::kNull, mark, "?"));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& text) override {
    // Text in another encoding than UTF-8 arrives as its bytes, which no message could carry.
    if (expects_key()) return take_key(mark, valid_utf8(text));
    YamlValue value = open(YamlValue::Kind::kScalar, mark, tag);
    value.scalar = valid_utf8(text);
    close(std::move(value));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    start(YamlValue::Kind::kList, mark, tag);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    start(YamlValue::Kind::kMapping, mark, tag);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapEnd() override { end(); }

 private:
  struct Key {
    std::string name;  // empty: the next event is a key
    Place place;
    std::unordered_map<std::string, int> lines;  // line of each key of the mapping so far
  };

  bool in_mapping() const { return !open_.empty() && open_.back().kind == YamlValue::Kind::kMapping; }
  bool expects_key() const { return in_mapping() && keys_.back().name.empty(); }

  [[noreturn]] void refuse_key(const YAML::Mark& mark) const {
    refuse_at(place(mark), "", "a key is not a name; write `name: value`");
  }

  void take_key(const YAML::Mark& mark, const std::string& name) {
    if (name.empty()) refuse_key(mark);
    Key& key = keys_.back();
    key.name = name;
    key.place = place(mark);
    const auto [first, is_new] = key.lines.try_emplace(name, key.place.line);
    if (!is_new)
      refuse_at(
          key.place, "",
          quote(name) + " is given twice, first in line " + std::to_string(first->second) + "; keep one");
  }

  YamlValue open(YamlValue::Kind kind, const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse_at(place(mark), "", "tags (" + quote(tag) + ") are not read; write the value itself");
    YamlValue value;
    value.kind = kind;
    value.place = place(mark);
    if (in_mapping()) {
      value.key = std::exchange(keys_.back().name, {});
      // Errors about a member point to its key, where its name stands.
      value.place = keys_.back().place;
    }
    return value;
  }

  void close(YamlValue value) {
    (open_.empty() ? root_ : open_.back().children.emplace_back()) = std::move(value);
  }

  void start(YamlValue::Kind kind, const YAML::Mark& mark, const std::string& tag) {
    if (expects_key()) refuse_key(mark);
    if (open_.size() == kDeepestNesting)
      refuse_at(place(mark), "",
                "is nested more than " + std::to_string(kDeepestNesting) + " levels deep; write it flatter");
    open_.push_back(open(kind, mark, tag));
    keys_.emplace_back();
  }

  void end() {
    YamlValue value = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    close(std::move(value));
  }

  std::shared_ptr<const std::string> source_;
  YamlValue root_;
  std::vector<YamlValue> open_;  // lists and mappings from the root to the innermost
  std::vector<Key> keys_;        // key of the next member, for each value in open_
};

}  // namespace

std::string Place::text() const {
  return line == 0 ? *source : *source + ":" + std::to_string(line) + ":" + std::to_string(column);
}

const YamlValue* YamlValue::find(std::string_view name) const {
  if (kind != Kind::kMapping) return nullptr;
  const auto found = std::ranges::find(children, name, &YamlValue::key);
  return found == children.end() ? nullptr : &*found;
}

YamlValue* YamlValue::find(std::string_view name) {
  return const_cast<YamlValue*>(std::as_const(*this).find(name));
}

YamlValue parse_yaml(const std::string& text, const std::string& source) {
  TreeBuilder builder(std::make_shared<const std::string>(source));
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    YamlValue root = builder.take_root();
    if (!root.place.source) root.place = builder.place(YAML::Mark());
    if (parser.HandleNextDocument(builder))
      refuse_at(builder.take_root().place, "", "a second document begins here; write one document in a file");
    return root;
  } catch (const YAML::Exception& error) {
    refuse_at(builder.place(error.mark), "", "is not YAML: " + shorten(error.msg));
  }
}

void refuse_at(const Place& place, std::string_view path, std::string_view message) {
  std::string line = place.text() + ": ";
  if (!path.empty()) line += std::string(path) + ": ";
  throw UserError("", line + std::string(message));
}

}  // namespace adit::protocol
