#include "protocol/scene/yaml/merge.hpp"

#include <utility>

#include "protocol/errors.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using Kind = YamlValue::Kind;

// The type of the message that the member `name` of `type` holds; null if it holds none.
const Descriptor* member_type(const Descriptor* type, const std::string& name) {
  const FieldDescriptor* field = type ? type->FindFieldByName(name) : nullptr;
  return field && field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE ? field->message_type() : nullptr;
}

// Removes the members that exclude the member `name`.
void drop_rivals(YamlValue& mapping, const std::string& name, const Descriptor* type) {
  const FieldDescriptor* field = type ? type->FindFieldByName(name) : nullptr;
  const auto* oneof = field ? field->real_containing_oneof() : nullptr;
  if (!oneof) return;
  std::erase_if(mapping.children, [&](const YamlValue& member) {
    const FieldDescriptor* other = type->FindFieldByName(member.key);
    return other && other != field && other->real_containing_oneof() == oneof;
  });
}

// The member `name`; an empty one is added if it is missing.
YamlValue& member(YamlValue& mapping, const std::string& name, const Place& place) {
  if (YamlValue* present = mapping.find(name)) return *present;
  YamlValue& added = mapping.children.emplace_back();
  added.key = name;
  added.place = place;
  return added;
}

void relocate(YamlValue& value, const Place& place) {
  value.place = place;
  for (YamlValue& child : value.children) relocate(child, place);
}

YamlValue parse_value(const Override& set, const Place& place) {
  // The value has no line in a file, so all of it stands at the --set argument.
  YamlValue value = parse_yaml(set.value, *place.source);
  relocate(value, place);
  return value;
}

// Removes the member or the element at the path.
void remove(const std::vector<PathStep>& steps, YamlValue& root, const Place& place) {
  YamlValue* holder = nullptr;
  YamlValue* target = &root;
  std::string path;
  for (const PathStep& step : steps) {
    holder = target;
    target = holder->find(step.name);
    path = member_path(path, step.name);
    if (target && step.index) {
      holder = target;
      target = holder->kind == Kind::kList && *step.index < holder->children.size()
                   ? &holder->children[*step.index]
                   : nullptr;
      path = element_path(path, *step.index);
    }
    if (!target) refuse_at(place, path, "is not given, so that nothing can be taken away; leave this out");
  }
  holder->children.erase(holder->children.begin() + (target - holder->children.data()));
}

}  // namespace

void merge(YamlValue& into, YamlValue from, const Descriptor* type) {
  if (into.kind != Kind::kMapping || from.kind != Kind::kMapping) {
    into = std::move(from);
    return;
  }
  into.place = from.place;
  std::erase_if(from.children, [&](const YamlValue& child) {
    return child.takes_away() &&
           std::erase_if(into.children, [&](const YamlValue& member) { return member.key == child.key; }) > 0;
  });
  // All rivals go before any member is merged. Two members of `from` that exclude each other thus both stay,
  // and the reader refuses them.
  for (const YamlValue& child : from.children) drop_rivals(into, child.key, type);
  for (YamlValue& child : from.children) {
    YamlValue& target = member(into, child.key, child.place);
    const Descriptor* inner = member_type(type, child.key);
    merge(target, std::move(child), inner);
  }
}

std::vector<Override> parse_overrides(std::span<const std::string> texts) {
  std::vector<Override> sets;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw UserError("", "--set " + shorten(text) +
                              ": is not path=value, as in `--set particles.bonds.tensile_strength=10 MN`");
    sets.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return sets;
}

void apply(const Override& set, YamlValue& root, const Descriptor* type) {
  const Place place{std::make_shared<const std::string>("--set " + shorten(set.path + "=" + set.value)), 0,
                    0};
  const auto steps = parse_path(set.path);
  if (!steps || steps->empty() || steps->size() > kDeepestNesting)
    refuse_at(place, "", quote(set.path) + " is not a path such as `particles.loads[0].force.y`");
  if (steps->front().name == "extends")
    refuse_at(place, "extends", "can only be given in the scene file; name the other scene file instead");

  YamlValue value = parse_value(set, place);
  if (value.takes_away()) return remove(*steps, root, place);
  YamlValue* target = &root;
  std::string path;
  for (const PathStep& step : *steps) {
    if (target->kind == Kind::kList)
      refuse_at(place, path,
                "is a list; name one of its elements, as in " +
                    quote(member_path(element_path(path, 0), step.name)));
    if (target->kind != Kind::kMapping) {
      target->kind = Kind::kMapping;
      target->children.clear();
      target->place = place;
    }
    drop_rivals(*target, step.name, type);
    target = &member(*target, step.name, place);
    type = member_type(type, step.name);
    path = member_path(path, step.name);
    if (!step.index) continue;
    const std::size_t size = target->kind == Kind::kList ? target->children.size() : 0;
    if (*step.index >= size)
      refuse_at(place, element_path(path, *step.index),
                "does not exist; " + path + " has " + std::to_string(size) + " elements, counted from 0");
    target = &target->children[*step.index];
    path = element_path(path, *step.index);
  }
  // The whole value is replaced; its key belongs to the mapping and stays.
  value.key = std::move(target->key);
  *target = std::move(value);
}

}  // namespace adit::protocol
