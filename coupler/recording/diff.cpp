#include "coupler/recording/diff.hpp"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/unknown_field_set.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "coupler/check/text.hpp"
#include "coupler/recording/reader.hpp"
#include "coupler/recording/turns.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr const char* kNothing = "nothing";

void clear_what_may_differ(wire::Frame& frame) {
  switch (frame.content_case()) {
    case wire::Frame::kSetup:
      frame.mutable_setup()->clear_run_id();
      frame.mutable_setup()->mutable_scene()->clear_name();
      frame.mutable_setup()->mutable_scene()->clear_description();
      return;
    case wire::Frame::kModel:
      return frame.mutable_model()->clear_state_format();
    case wire::Frame::kInterface:
      return frame.mutable_interface()->clear_resident_bytes();
    case wire::Frame::kPredicted:
      frame.mutable_predicted()->clear_compute_seconds();
      return frame.mutable_predicted()->clear_hidden_seconds();
    case wire::Frame::kState:  // it holds clocks, too
      frame.mutable_state()->clear_checksum();
      return frame.mutable_state()->clear_data();
    case wire::Frame::kBye:
      return frame.mutable_bye()->clear_cpu_seconds();
    default:
      return;
  }
}

std::string text_of(const Message& message, const FieldDescriptor* field, int i) {
  std::string text;
  google::protobuf::TextFormat::PrintFieldValueToString(message, field, i, &text);
  return text;
}

// The values of one field, by its place in a list, or -1 where it is no list.
class Values {
 public:
  Values(const Message& a, const Message& b, const FieldDescriptor* field) : a_(a), b_(b), field_(field) {}

  std::optional<Difference> at(int i, const std::string& path) const {
    switch (field_->type()) {
      case FieldDescriptor::TYPE_DOUBLE:
        return numbers(i, path);
      case FieldDescriptor::TYPE_BYTES:
        return bytes(i, path);
      default:
        return texts(i, path);
    }
  }

 private:
  std::optional<Difference> texts(int i, const std::string& path) const {
    const std::string a = text_of(a_, field_, i), b = text_of(b_, field_, i);
    if (a == b) return std::nullopt;
    return Difference{path, protocol::shorten(a), protocol::shorten(b)};
  }

  double number(const Message& message, int i) const {
    const auto& reflection = *message.GetReflection();
    return i < 0 ? reflection.GetDouble(message, field_) : reflection.GetRepeatedDouble(message, field_, i);
  }

  std::optional<Difference> numbers(int i, const std::string& path) const {
    const double a = number(a_, i), b = number(b_, i);
    if (std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b)) return std::nullopt;
    const auto shown = [](double value) {
      return std::isnan(value) ? fmt::format("nan ({:#x})", std::bit_cast<std::uint64_t>(value))
                               : fmt::format("{}", value);
    };
    return Difference{path, shown(a), shown(b)};
  }

  // Contents of files and states: the first byte that differs.
  std::optional<Difference> bytes(int i, const std::string& path) const {
    std::string scratch_a, scratch_b;
    const auto content = [&](const Message& message, std::string& scratch) -> const std::string& {
      const auto& reflection = *message.GetReflection();
      return i < 0 ? reflection.GetStringReference(message, field_, &scratch)
                   : reflection.GetRepeatedStringReference(message, field_, i, &scratch);
    };
    const std::string &a = content(a_, scratch_a), &b = content(b_, scratch_b);
    if (a == b) return std::nullopt;
    const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const auto shown = [](const std::string& all, std::string::const_iterator byte) {
      return byte == all.end() ? std::string("the end")
                               : fmt::format("{:#04x}", static_cast<unsigned char>(*byte));
    };
    return Difference{fmt::format("{}, byte {}", path, in_a - a.begin()), shown(a, in_a), shown(b, in_b)};
  }

  const Message &a_, &b_;
  const FieldDescriptor* field_;
};

std::optional<Difference> in_messages(const Message& a, const Message& b, const std::string& path);

std::optional<Difference> in_list(const Message& a, const Message& b, const FieldDescriptor* field,
                                  const std::string& path) {
  const auto &of_a = *a.GetReflection(), &of_b = *b.GetReflection();
  const int count_a = of_a.FieldSize(a, field), count_b = of_b.FieldSize(b, field);
  const bool messages = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
  for (int i = 0; i < std::min(count_a, count_b); ++i) {
    const std::string element = protocol::element_path(path, static_cast<std::size_t>(i));
    auto found = messages ? in_messages(of_a.GetRepeatedMessage(a, field, i),
                                        of_b.GetRepeatedMessage(b, field, i), element)
                          : Values(a, b, field).at(i, element);
    if (found) return found;
  }
  if (count_a == count_b) return std::nullopt;
  return Difference{path, fmt::format("{} values", count_a), fmt::format("{} values", count_b)};
}

std::optional<Difference> in_field(const Message& a, const Message& b, const FieldDescriptor* field,
                                   const std::string& path) {
  if (field->is_repeated()) return in_list(a, b, field, path);
  const auto &of_a = *a.GetReflection(), &of_b = *b.GetReflection();
  if (field->has_presence()) {
    const bool in_a = of_a.HasField(a, field), in_b = of_b.HasField(b, field);
    const auto shown = [field](const Message& message, bool there) {
      const std::string text = there ? text_of(message, field, -1) : kNothing;
      const bool braces = there && field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
      return protocol::shorten(braces ? "{ " + text + "}" : text);
    };
    if (!in_a && !in_b) return std::nullopt;
    if (in_a != in_b) return Difference{path, shown(a, in_a), shown(b, in_b)};
  }
  if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
    return in_messages(of_a.GetMessage(a, field), of_b.GetMessage(b, field), path);
  return Values(a, b, field).at(-1, path);
}

std::optional<Difference> in_messages(const Message& a, const Message& b, const std::string& path) {
  const auto* descriptor = a.GetDescriptor();
  for (int i = 0; i < descriptor->field_count(); ++i) {
    const FieldDescriptor* field = descriptor->field(i);
    if (auto found = in_field(a, b, field, protocol::member_path(path, field->name()))) return found;
  }
  std::string unknown_a, unknown_b;
  a.GetReflection()->GetUnknownFields(a).SerializeToString(&unknown_a);
  b.GetReflection()->GetUnknownFields(b).SerializeToString(&unknown_b);
  if (unknown_a == unknown_b) return std::nullopt;
  return Difference{path + ", fields of another release", fmt::format("{} bytes", unknown_a.size()),
                    fmt::format("{} bytes", unknown_b.size())};
}

std::string content_of(const wire::Frame& frame) {
  if (frame.has_error()) return "error: " + protocol::shorten(frame.error().message());
  return wire::Frame::descriptor()->FindFieldByNumber(frame.content_case())->name();
}

// A difference in the `turn`-th turn of a participant.
struct Finding {
  std::uint64_t turn;
  bool in_answer;
  std::string text;

  bool operator<(const Finding& other) const {
    return std::tie(turn, in_answer) < std::tie(other.turn, other.in_answer);
  }
};

struct Comparison {
  std::uint64_t turns = 0;  // that both have
  std::string last;         // place of the last of them
  std::vector<Finding> findings;
};

bool next(Turns& turns, Turn& turn) {
  while (turns.next(turn))
    if (!turn.request.has_save()) return true;
  return false;
}

std::string told(const std::string& place, const Difference& difference) {
  return fmt::format("{}: {} is {} in A, {} in B", place, difference.field, difference.a, difference.b);
}

// The first request and the first answer that differ; nothing is compared beyond different requests of
// another kind, because the turns no longer belong together.
Comparison compare(Turns& of_a, Turns& of_b) {
  Comparison comparison;
  bool asked = false, answered = false;
  for (Turn a, b; !(asked && answered); ++comparison.turns) {
    const bool in_a = next(of_a, a), in_b = next(of_b, b);
    if (!in_a && !in_b) return comparison;
    if (in_a != in_b) {
      comparison.findings.push_back({comparison.turns, false,
                                     fmt::format("{} has no more, {} goes on with {}", in_a ? "B" : "A",
                                                 in_a ? "A" : "B", in_a ? a.place : b.place)});
      return comparison;
    }
    comparison.last = a.place;
    const bool same_kind = a.request.content_case() == b.request.content_case();
    if (const auto found = first_difference(a.request, b.request); found && !asked) {
      comparison.findings.push_back({comparison.turns, false, told("request of " + a.place, *found)});
      asked = true;
    }
    if (!same_kind || (!a.answered && !b.answered)) return comparison;
    if (a.answered != b.answered) {
      comparison.findings.push_back(
          {comparison.turns, true,
           fmt::format("only {} has an answer to {}", a.answered ? "A" : "B", a.place)});
      return comparison;
    }
    if (answered) continue;
    if (const auto found = first_difference(a.answer, b.answer)) {
      comparison.findings.push_back({comparison.turns, true, told("answer to " + a.place, *found)});
      answered = true;
    }
  }
  return comparison;
}

std::optional<std::uint16_t> find(const std::vector<Speaker>& speakers, const std::string& name) {
  const auto found = std::find_if(speakers.begin(), speakers.end(),
                                  [&](const Speaker& speaker) { return speaker.name == name; });
  if (found == speakers.end()) return std::nullopt;
  return static_cast<std::uint16_t>(found - speakers.begin());
}

void print_programs(const char* label, const std::filesystem::path& path,
                    const std::vector<Speaker>& speakers) {
  std::vector<std::string> programs;
  programs.reserve(speakers.size());
  for (const Speaker& speaker : speakers)
    programs.push_back(fmt::format("{} by {} {}", speaker.name, speaker.program, speaker.release));
  print_line(label, fmt::format("{}: {}", path.string(), fmt::join(programs, ", ")));
}

}  // namespace

std::optional<Difference> first_difference(wire::Frame& a, wire::Frame& b) {
  if (a.content_case() != b.content_case()) return Difference{"the message", content_of(a), content_of(b)};
  clear_what_may_differ(a);
  clear_what_may_differ(b);
  // Equal frames, which are most, are found by their bytes: those that protobuf writes for equal messages.
  if (a.SerializeAsString() == b.SerializeAsString()) return std::nullopt;
  return in_messages(a, b, "");
}

int diff(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::vector<Speaker> in_a = RecordingReader(a).speakers(), in_b = RecordingReader(b).speakers();
  print_programs("A", a, in_a);
  print_programs("B", b, in_b);
  std::vector<std::pair<Finding, std::string>> all;  // with the participant's name
  for (const Speaker& speaker : in_b)
    if (!find(in_a, speaker.name)) all.push_back({{0, false, "is in B only"}, speaker.name});
  for (const Speaker& speaker : in_a) {
    const auto other = find(in_b, speaker.name);
    if (!other) {
      all.push_back({{0, false, "is in A only"}, speaker.name});
      continue;
    }
    Turns of_a(a, *find(in_a, speaker.name)), of_b(b, *other);
    const Comparison comparison = compare(of_a, of_b);
    for (const Finding& finding : comparison.findings) all.emplace_back(finding, speaker.name);
    if (comparison.findings.empty())
      print_line(speaker.name, fmt::format("equal: {} requests and their answers, up to {}",
                                           grouped(comparison.turns), comparison.last));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  for (const auto& [finding, name] : all) print_line(name, finding.text);
  print_line("not compared", kNotCompared);
  return all.empty() ? 0 : kDifferent;
}

}  // namespace adit::coupler
