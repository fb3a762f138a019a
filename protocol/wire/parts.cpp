#include "protocol/wire/parts.hpp"

#include <google/protobuf/util/field_mask_util.h>

#include <algorithm>
#include <span>
#include <string>

#include "protocol/wire/bounds.hpp"
#include "protocol/wire/content/parsed_size.hpp"
#include "protocol/wire/frame.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::RepeatedField;
using google::protobuf::RepeatedPtrField;

// The place in a part of the message that is being divided.
using Open = std::function<Message&(wire::Frame& part)>;

constexpr std::uint64_t kElementBytes = 1024;  // of a message in a list, with its texts: cracks and the like

bool is_list(const FieldDescriptor* field) {
  return field->is_repeated() && field->cpp_type() != FieldDescriptor::CPPTYPE_STRING;
}

// Of the messages in a list, which a part that goes on with one of them repeats: pieces and their fields.
const FieldDescriptor* name_in(const FieldDescriptor* list) {
  return list->message_type() == wire::Piece::descriptor() ||
                 list->message_type() == wire::Field::descriptor()
             ? list->message_type()->FindFieldByName("name")
             : nullptr;
}

class Division {
 public:
  Division(std::uint64_t list_bytes, const SendPart& send) : list_bytes_(list_bytes), send_(send) {}

  void divide(const Message& from, const Open& open) const {
    send_what_is_no_list(from, open);
    for (int i = 0; i < from.GetDescriptor()->field_count(); ++i)
      if (const FieldDescriptor* field = from.GetDescriptor()->field(i); is_list(field))
        divide_list(from, field, open);
  }

 private:
  void send_what_is_no_list(const Message& from, const Open& open) const {
    google::protobuf::FieldMask fields;
    for (int i = 0; i < from.GetDescriptor()->field_count(); ++i)
      if (const FieldDescriptor* field = from.GetDescriptor()->field(i); !is_list(field))
        fields.add_paths(field->name());
    wire::Frame part;
    google::protobuf::util::FieldMaskUtil::MergeMessageTo(from, fields, {}, &open(part));
    send_(part, true);
  }

  void divide_list(const Message& from, const FieldDescriptor* list, const Open& open) const {
    switch (list->cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return divide_numbers<double>(from, list, open);
      case FieldDescriptor::CPPTYPE_UINT32:
        return divide_numbers<std::uint32_t>(from, list, open);
      default:
        return name_in(list) != nullptr ? divide_elements(from, list, open)
                                        : divide_messages(from, list, open);
    }
  }

  template <class Number>
  void divide_numbers(const Message& from, const FieldDescriptor* list, const Open& open) const {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // what takes its place hands out one by one
    const auto& numbers = from.GetReflection()->GetRepeatedField<Number>(from, list);
    const auto place = [list](Message& to) {
      return to.GetReflection()->MutableRepeatedField<Number>(&to, list);
    };
#pragma GCC diagnostic pop
    const auto most = static_cast<int>(list_bytes_ / sizeof(double));
    for (int begin = 0; begin < numbers.size(); begin += most) {
      wire::Frame part;
      place(open(part))
          ->Add(numbers.begin() + begin, numbers.begin() + begin + std::min(most, numbers.size() - begin));
      send_(part, true);
    }
  }

  void divide_messages(const Message& from, const FieldDescriptor* list, const Open& open) const {
    const auto& get = *from.GetReflection();
    const auto most = static_cast<int>(std::max<std::uint64_t>(list_bytes_ / kElementBytes, 1));
    for (int begin = 0; begin < get.FieldSize(from, list); begin += most) {
      wire::Frame part;
      Message& to = open(part);
      for (int i = begin; i < std::min(begin + most, get.FieldSize(from, list)); ++i)
        get.AddMessage(&to, list)->CopyFrom(get.GetRepeatedMessage(from, list, i));
      send_(part, true);
    }
  }

  void divide_elements(const Message& from, const FieldDescriptor* list, const Open& open) const {
    for (int i = 0; i < from.GetReflection()->FieldSize(from, list); ++i) {
      const Message& element = from.GetReflection()->GetRepeatedMessage(from, list, i);
      divide(element, [&](wire::Frame& part) -> Message& {
        Message& owner = open(part);
        Message& to = *owner.GetReflection()->AddMessage(&owner, list);
        const FieldDescriptor* name = name_in(list);
        to.GetReflection()->SetString(&to, name, element.GetReflection()->GetString(element, name));
        return to;
      });
    }
  }

  std::uint64_t list_bytes_;
  const SendPart& send_;
};

void divide_setup(const wire::Setup& setup, std::uint64_t list_bytes, const SendPart& send) {
  const std::string scene = setup.scene().SerializeAsString();
  for (std::size_t begin = 0; begin < scene.size(); begin += list_bytes) {
    wire::Frame part;
    part.mutable_setup()->set_run_id(setup.run_id());
    part.mutable_setup()->set_alone(setup.alone());
    part.mutable_setup()->add_scene_parts(scene.substr(begin, list_bytes));
    send(part, true);
  }
}

template <class Named>
void append(RepeatedPtrField<Named>& next, RepeatedPtrField<Named>& list);

void append(wire::Field& next, wire::Field& whole) {
  whole.MergeFrom(next);
}

void append(wire::Piece& next, wire::Piece& whole) {
  append(*next.mutable_point_fields(), *whole.mutable_point_fields());
  append(*next.mutable_cell_fields(), *whole.mutable_cell_fields());
  whole.MergeFrom(next);
}

// What has the name of the last one goes on with it.
template <class Named>
void append(RepeatedPtrField<Named>& next, RepeatedPtrField<Named>& list) {
  for (Named& element : next)
    if (!list.empty() && list.rbegin()->name() == element.name())
      append(element, *list.rbegin());
    else
      list.Add(std::move(element));
  next.Clear();
}

void join_scene(wire::Setup& setup) {
  if (setup.scene_parts().empty()) return;
  std::string scene;
  for (std::string& part : *setup.mutable_scene_parts()) {
    scene += part;
    std::string().swap(part);
  }
  setup.clear_scene_parts();
  const auto memory = parsed_size(std::as_bytes(std::span(scene)), scene::Scene::descriptor());
  if (!memory || *memory > most_parsed_bytes(scene.size()) || !setup.mutable_scene()->ParseFromString(scene))
    throw Malformed("sent a scene in parts that cannot be read");
}

}  // namespace

void divide(const wire::Frame& message, std::uint64_t list_bytes, const SendPart& send) {
  const auto* content = wire::Frame::descriptor()->FindFieldByNumber(message.content_case());
  const auto& reflection = *wire::Frame::GetReflection();
  const auto open = [&](wire::Frame& part) -> Message& { return *reflection.MutableMessage(&part, content); };
  if (message.has_setup())
    divide_setup(message.setup(), list_bytes, send);
  else
    Division(list_bytes, send).divide(reflection.GetMessage(message, content), open);
  wire::Frame last;
  open(last);
  send(last, false);
}

bool Assembly::add(wire::Frame& frame, bool goes_on) {
  if (open_ && !frame.has_error()) {
    if (frame.content_case() != whole_.content_case())
      throw Malformed("sent a part of another message than it had begun");
    if (frame.has_snapshot())
      append(*frame.mutable_snapshot()->mutable_pieces(), *whole_.mutable_snapshot()->mutable_pieces());
    else
      whole_.MergeFrom(frame);
  } else if (goes_on) {
    whole_.Swap(&frame);
  }
  if (open_ && !goes_on && !frame.has_error()) frame.Swap(&whole_);
  open_ = goes_on;
  if (goes_on) return false;
  whole_.Clear();
  if (frame.has_setup()) join_scene(*frame.mutable_setup());
  return true;
}

}  // namespace adit::protocol
