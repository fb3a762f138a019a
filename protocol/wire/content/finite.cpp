#include "protocol/wire/content/finite.hpp"

#include <fmt/format.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// A field that holds numbers, or messages that hold some.
struct Part {
  const FieldDescriptor* field;
  std::vector<Part> within;  // of the messages
};

// Those of which wire.proto says that they may be missing or infinite, and the scene.
bool is_excepted(const FieldDescriptor* field) {
  static const std::array excepted = {
      wire::Setup::descriptor()->FindFieldByName("scene"),
      wire::Predicted::descriptor()->FindFieldByName("histories"),
      wire::Relaxation::descriptor()->FindFieldByName("drag_x"),
      wire::Relaxation::descriptor()->FindFieldByName("drag_y"),
      wire::Field::descriptor()->FindFieldByName("values"),
      wire::Figure::descriptor()->FindFieldByName("value"),
  };
  return std::ranges::find(excepted, field) != excepted.end();
}

std::vector<Part> parts_of(const Descriptor* type) {
  std::vector<Part> parts;
  for (int i = 0; i < type->field_count(); ++i) {
    const FieldDescriptor* field = type->field(i);
    if (is_excepted(field)) continue;
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) parts.push_back({field, {}});
    if (!field->message_type()) continue;
    if (auto within = parts_of(field->message_type()); !within.empty())
      parts.push_back({field, std::move(within)});
  }
  return parts;
}

// The array itself. What protobuf recommends instead hands out one number after another by virtual calls,
// which takes as long as the exchange of a small model.
std::span<const double> numbers_of(const Message& message, const FieldDescriptor* field) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  const auto& list = message.GetReflection()->GetRepeatedField<double>(message, field);
#pragma GCC diagnostic pop
  return {list.data(), static_cast<std::size_t>(list.size())};
}

// The way to a number, from the number outwards: fields, with the place in those that are lists.
struct Step {
  const FieldDescriptor* field;
  std::ptrdiff_t place;
};
struct Way {
  std::vector<Step> steps;
  double number = 0;
};

bool has_wrong_number(const Message& message, const FieldDescriptor* field, Way& way) {
  const double single = field->is_repeated() ? 0 : message.GetReflection()->GetDouble(message, field);
  const auto values = field->is_repeated() ? numbers_of(message, field) : std::span(&single, 1);
  if (all_finite(values)) return false;
  const auto wrong = std::ranges::find_if_not(values, [](double value) { return std::isfinite(value); });
  way = {{{field, wrong - values.begin()}}, *wrong};
  return true;
}

bool has_wrong(const Message& message, const std::vector<Part>& parts, Way& way) {
  const auto& get = *message.GetReflection();
  for (const auto& [field, within] : parts) {
    if (within.empty()) {
      if (has_wrong_number(message, field, way)) return true;
      continue;
    }
    const bool list = field->is_repeated();
    const int count = list ? get.FieldSize(message, field) : get.HasField(message, field) ? 1 : 0;
    for (int i = 0; i < count; ++i)
      if (has_wrong(list ? get.GetRepeatedMessage(message, field, i) : get.GetMessage(message, field), within,
                    way)) {
        way.steps.push_back({field, i});
        return true;
      }
  }
  return false;
}

std::string named(const Way& way) {
  std::string name;
  for (auto step = way.steps.rbegin(); step != way.steps.rend(); ++step) {
    name += (name.empty() ? "" : ".") + step->field->name();
    if (step->field->is_repeated()) name += fmt::format("[{}]", step->place);
  }
  return name;
}

}  // namespace

// By the exponent, whose bits are all set in what is not finite: one more then carries into the sign.
// Compilers make vectors of these operations, but none of comparisons.
bool all_finite(std::span<const double> values) {
  constexpr std::uint64_t kExponent = 0x7ff0'0000'0000'0000, kOne = 0x0010'0000'0000'0000;
  std::uint64_t found = 0;
  for (const double value : values) found |= (std::bit_cast<std::uint64_t>(value) & kExponent) + kOne;
  return found >> 63 == 0;
}

std::optional<std::string> first_not_finite(const wire::Frame& frame) {
  static const std::vector<Part> contents = parts_of(wire::Frame::descriptor());
  const auto content = std::ranges::find(contents, static_cast<int>(frame.content_case()),
                                         [](const Part& part) { return part.field->number(); });
  if (content == contents.end()) return std::nullopt;
  Way way;
  if (!has_wrong(frame.GetReflection()->GetMessage(frame, content->field), content->within, way))
    return std::nullopt;
  way.steps.push_back({content->field, 0});
  return fmt::format("{} is {}", named(way), way.number);
}

}  // namespace adit::protocol
