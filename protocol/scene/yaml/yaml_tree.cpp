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

constexpr const char* kMergeKey = "<<";

// The null that is written at the beginning of the text; empty if there is none.
std::string written_null(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n,]}#"));
  return word == "~" || word == "null" || word == "Null" || word == "NULL" ? std::string(word) : "";
}

// A value and all values in it.
std::size_t count_of(const YamlValue& value) {
  std::size_t count = 1;
  for (const YamlValue& child : value.children) count += count_of(child);
  return count;
}

// Levels of lists and mappings.
std::size_t depth_of(const YamlValue& value) {
  std::size_t deepest = 0;
  for (const YamlValue& child : value.children) deepest = std::max(deepest, depth_of(child));
  return deepest + (value.kind == YamlValue::Kind::kList || value.kind == YamlValue::Kind::kMapping ? 1 : 0);
}

// Builds the tree from the parser's events; lists and mappings that have not ended yet wait on a stack.
// The tree is built from events, because the parser's own tree would resolve aliases and nest to any depth
// before either could be refused.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, std::shared_ptr<const std::string> source)
      : text_(text), source_(std::move(source)) {}

  YamlValue take_root() { return std::move(root_); }

  Place place(const YAML::Mark& mark) const {
    return {source_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }

  void OnDocumentStart(const YAML::Mark& mark) override { root_.place = place(mark); }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (expects_key()) refuse_key(mark);
    const auto known = anchored_.find(anchor);
    if (known == anchored_.end())
      refuse_at(place(mark), "",
                "an alias (`*name`) stands inside the value that it names; write the value itself");
    if (open_.size() + known->second.depth > kDeepestNesting) refuse_depth(mark);
    count_repeated(place(mark), known->second.count);
    YamlValue value = open(known->second.value.kind, mark, "");
    value.scalar = known->second.value.scalar;
    value.children = known->second.value.children;
    close(std::move(value), YAML::NullAnchor);
  }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (expects_key()) refuse_key(mark);
    YamlValue value = open(YamlValue::Kind::kNull, mark, "?");
    const auto at = static_cast<std::size_t>(std::max(mark.pos, 0));
    if (at < text_.size()) value.scalar = written_null(std::string_view(text_).substr(at));
    close(std::move(value), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    // Text in another encoding than UTF-8 arrives as its bytes, which no message could carry.
    if (expects_key()) return take_key(mark, valid_utf8(text), anchor);
    YamlValue value = open(YamlValue::Kind::kScalar, mark, tag);
    value.scalar = valid_utf8(text);
    close(std::move(value), anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    start(YamlValue::Kind::kList, mark, tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    start(YamlValue::Kind::kMapping, mark, tag, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapEnd() override { end(); }

 private:
  struct Key {
    std::string name;  // empty: the next event is a key
    Place place;
    std::unordered_map<std::string, int> lines;  // line of each key of the mapping so far
    YAML::anchor_t anchor;                       // of the list or mapping itself
  };

  // What aliases repeat.
  struct Anchored {
    YamlValue value;
    std::size_t count, depth;
  };

  bool in_mapping() const { return !open_.empty() && open_.back().kind == YamlValue::Kind::kMapping; }
  bool expects_key() const { return in_mapping() && keys_.back().name.empty(); }

  [[noreturn]] void refuse_key(const YAML::Mark& mark) const {
    refuse_at(place(mark), "", "a key is not a name; write `name: value`");
  }

  [[noreturn]] void refuse_depth(const YAML::Mark& mark) const {
    refuse_at(place(mark), "",
              "is nested more than " + std::to_string(kDeepestNesting) + " levels deep; write it flatter");
  }

  void count_repeated(const Place& place, std::size_t values) {
    repeated_ += values;
    if (repeated_ > kMostRepeated)
      refuse_at(place, "",
                "anchors and aliases (`&name`, `*name`) hold more than " + std::to_string(kMostRepeated) +
                    " values up to here; repeat less of the scene");
  }

  void take_key(const YAML::Mark& mark, const std::string& name, YAML::anchor_t anchor) {
    if (name.empty() || anchor != YAML::NullAnchor) refuse_key(mark);
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

  void close(YamlValue value, YAML::anchor_t anchor) {
    if (anchor != YAML::NullAnchor) {
      const std::size_t count = count_of(value);
      count_repeated(value.place, count);
      anchored_[anchor] = {value, count, depth_of(value)};
    }
    (open_.empty() ? root_ : open_.back().children.emplace_back()) = std::move(value);
  }

  void start(YamlValue::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (expects_key()) refuse_key(mark);
    if (open_.size() == kDeepestNesting) refuse_depth(mark);
    open_.push_back(open(kind, mark, tag));
    keys_.push_back({.name = {}, .place = {}, .lines = {}, .anchor = anchor});
  }

  void end() {
    YamlValue value = std::move(open_.back());
    Key key = std::move(keys_.back());
    open_.pop_back();
    keys_.pop_back();
    if (key.lines.contains(kMergeKey)) take_merged(value, key);
    close(std::move(value), key.anchor);
  }

  // Puts what the key `<<` of a mapping gives in its place: members that the mapping does not have, of a list
  // of mappings those of the first that has them.
  static void take_merged(YamlValue& mapping, Key& key) {
    const auto merged = std::ranges::find(mapping.children, kMergeKey, &YamlValue::key);
    YamlValue given = std::move(*merged);
    mapping.children.erase(merged);
    std::vector<YamlValue> sources =
        given.kind == YamlValue::Kind::kList ? std::move(given.children) : std::vector<YamlValue>{given};
    for (YamlValue& each : sources) {
      if (each.kind != YamlValue::Kind::kMapping)
        refuse_at(given.place, "", "`<<` takes the members of mappings, as in `<<: *name`");
      for (YamlValue& member : each.children)
        if (key.lines.try_emplace(member.key, 0).second) mapping.children.push_back(std::move(member));
    }
  }

  const std::string& text_;
  std::shared_ptr<const std::string> source_;
  YamlValue root_;
  std::vector<YamlValue> open_;  // lists and mappings from the root to the innermost
  std::vector<Key> keys_;        // key of the next member, for each value in open_
  std::unordered_map<YAML::anchor_t, Anchored> anchored_;
  std::size_t repeated_ = 0;  // values of anchors, and those that aliases have repeated
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
  TreeBuilder builder(text, std::make_shared<const std::string>(source));
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
