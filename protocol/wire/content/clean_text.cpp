#include "protocol/wire/content/clean_text.hpp"

#include <string>
#include <unordered_map>
#include <vector>

#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// The fields of each message that hold text, themselves or within. A step's messages have few of them, and
// only these are looked at.
using TextFields = std::unordered_map<const Descriptor*, std::vector<const FieldDescriptor*>>;

void find_text_fields(const Descriptor* type, TextFields& found) {
  if (found.contains(type)) return;
  found[type] = {};
  for (int i = 0; i < type->field_count(); ++i) {
    const FieldDescriptor* field = type->field(i);
    const Descriptor* within = field->message_type();
    if (within != nullptr && within->file() == wire::Frame::descriptor()->file())
      find_text_fields(within, found);
    const bool holds_text =
        field->type() == FieldDescriptor::TYPE_STRING || (found.contains(within) && !found[within].empty());
    if (holds_text) found[type].push_back(field);
  }
}

const std::vector<const FieldDescriptor*>& text_fields(const Descriptor* type) {
  static const TextFields all = [] {
    TextFields found;
    find_text_fields(wire::Frame::descriptor(), found);
    return found;
  }();
  return all.at(type);
}

void clean(Message& message) {
  const auto& reflection = *message.GetReflection();
  for (const FieldDescriptor* field : text_fields(message.GetDescriptor())) {
    const bool list = field->is_repeated();
    const int count = list ? reflection.FieldSize(message, field) : reflection.HasField(message, field);
    for (int i = 0; i < count; ++i) {
      if (field->message_type() != nullptr)
        clean(*(list ? reflection.MutableRepeatedMessage(&message, field, i)
                     : reflection.MutableMessage(&message, field)));
      else if (list)
        reflection.SetRepeatedString(&message, field, i,
                                     one_line(reflection.GetRepeatedString(message, field, i)));
      else
        reflection.SetString(&message, field, one_line(reflection.GetString(message, field)));
    }
  }
}

}  // namespace

// A frame holds one content.
void clean_text(wire::Frame& frame) {
  const FieldDescriptor* content = wire::Frame::descriptor()->FindFieldByNumber(frame.content_case());
  if (content != nullptr) clean(*frame.GetReflection()->MutableMessage(&frame, content));
}

}  // namespace adit::protocol
