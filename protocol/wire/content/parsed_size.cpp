#include "protocol/wire/content/parsed_size.hpp"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/message.h>
#include <google/protobuf/wire_format_lite.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::MessageFactory;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

constexpr int kDeepest = 100;  // as protobuf's parser
// Lists grow by doubling, so they hold up to twice what they need.
constexpr std::uint64_t kGrowth = 2;
constexpr std::uint64_t kPointer = 8, kUnknownField = 64;

// Parts of a message whose first piece takes just what it needs: lists of doubles, and messages, which are
// merged where they come again. They grow from the second piece on.
class Pieces {
 public:
  // What a piece of this size takes beyond its size.
  std::uint64_t growth(const FieldDescriptor* field, std::uint64_t size) {
    for (auto& [known, grows_not_yet] : pieces_)
      if (known == field) return std::exchange(grows_not_yet, 0) + size;
    pieces_.emplace_back(field, size);
    return 0;
  }

 private:
  std::vector<std::pair<const FieldDescriptor*, std::uint64_t>> pieces_;
};

class Estimate {
 public:
  explicit Estimate(CodedInputStream& bytes) : bytes_(bytes) {}

  std::uint64_t total() const { return total_; }

  // Adds what is within a message of this type; false if the bytes are no such message.
  bool add_fields(const Descriptor* type, int depth) {
    Pieces pieces;
    while (const std::uint32_t tag = bytes_.ReadTag()) {
      const auto* field = type->FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      if (!add_field(tag, field, depth, pieces)) return false;
    }
    return bytes_.ConsumedEntireMessage();
  }

 private:
  bool add_field(std::uint32_t tag, const FieldDescriptor* field, int depth, Pieces& pieces) {
    const auto wire_type = WireFormatLite::GetTagWireType(tag);
    if (wire_type == WireFormatLite::WIRETYPE_START_GROUP) return add_group(tag);
    if (field != nullptr && !may_come_as(wire_type, field)) field = nullptr;
    if (wire_type != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
      if (field == nullptr)
        total_ += kUnknownField;
      else if (field->is_repeated() || field->enum_type() != nullptr)
        total_ += number_size(field) + (is_list_of_doubles(field) ? pieces.growth(field, 0) : 0);
      return WireFormatLite::SkipField(&bytes_, tag);
    }
    int length = 0;
    if (!bytes_.ReadVarintSizeAsInt(&length)) return false;
    if (field == nullptr || field->message_type() == nullptr) {
      const std::uint64_t size = size_within(field, static_cast<std::uint64_t>(length));
      total_ += size + (is_list_of_doubles(field) ? pieces.growth(field, size) : 0);
      return bytes_.Skip(length);
    }
    const std::uint64_t before = total_;
    total_ += empty_size(field->message_type()) + kGrowth * kPointer;
    if (depth == kDeepest) return false;
    const auto limit = bytes_.PushLimit(length);
    const bool complete = add_fields(field->message_type(), depth + 1);
    bytes_.PopLimit(limit);
    if (!field->is_repeated()) total_ += pieces.growth(field, total_ - before);
    return complete;
  }

  // None of our messages has groups: the parser keeps them as fields that it does not know, the least in two
  // bytes.
  bool add_group(std::uint32_t tag) {
    const int begin = bytes_.CurrentPosition();
    if (!WireFormatLite::SkipField(&bytes_, tag)) return false;
    total_ += kUnknownField * static_cast<std::uint64_t>(bytes_.CurrentPosition() - begin);
    return true;
  }

  static bool is_list_of_doubles(const FieldDescriptor* field) {
    return field != nullptr && field->is_repeated() && field->type() == FieldDescriptor::TYPE_DOUBLE;
  }

  // The parser keeps a field that comes otherwise among those that it does not know.
  static bool may_come_as(WireFormatLite::WireType wire_type, const FieldDescriptor* field) {
    if (wire_type == WireFormatLite::WIRETYPE_LENGTH_DELIMITED && field->is_packable()) return true;
    const auto type = static_cast<WireFormatLite::FieldType>(field->type());
    return wire_type == WireFormatLite::WireTypeForFieldType(type);
  }

  // Of a text, a packed list of numbers, or a field that is not known, at which the bytes stand.
  std::uint64_t size_within(const FieldDescriptor* field, std::uint64_t length) {
    if (field == nullptr) return kUnknownField + length;
    if (field->type() == FieldDescriptor::TYPE_STRING || field->type() == FieldDescriptor::TYPE_BYTES)
      return sizeof(std::string) + kGrowth * kPointer + length;
    if (field->type() == FieldDescriptor::TYPE_DOUBLE) return length + kPointer;  // their number is known
    return number_size(field) * count_numbers(length);
  }

  // In a list. A number that names no enumerator is kept as a field that is not known.
  static std::uint64_t number_size(const FieldDescriptor* field) {
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_ENUM:
        return kUnknownField;
      case FieldDescriptor::CPPTYPE_DOUBLE:
      case FieldDescriptor::CPPTYPE_INT64:
      case FieldDescriptor::CPPTYPE_UINT64:
        return kGrowth * 8;
      default:
        return kGrowth * 4;
    }
  }

  // Of packed numbers that take one byte or more: the last byte of each has its top bit clear.
  std::uint64_t count_numbers(std::uint64_t length) {
    const void* begin = nullptr;
    int available = 0;
    bytes_.GetDirectBufferPointer(&begin, &available);
    const std::span all(static_cast<const std::uint8_t*>(begin), static_cast<std::size_t>(available));
    const auto within = all.first(std::min<std::uint64_t>(length, all.size()));
    return static_cast<std::uint64_t>(std::ranges::count_if(within, [](auto byte) { return byte < 128; }));
  }

  std::uint64_t empty_size(const Descriptor* type) {
    const auto [found, is_new] = empty_sizes_.try_emplace(type, 0);
    if (is_new) found->second = MessageFactory::generated_factory()->GetPrototype(type)->SpaceUsedLong();
    return found->second;
  }

  CodedInputStream& bytes_;
  std::uint64_t total_ = 0;
  std::unordered_map<const Descriptor*, std::uint64_t> empty_sizes_;
};

}  // namespace

std::optional<std::uint64_t> parsed_size(std::span<const std::byte> bytes, const Descriptor* type) {
  CodedInputStream stream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                          static_cast<int>(bytes.size()));
  Estimate estimate(stream);
  if (!estimate.add_fields(type, 0)) return std::nullopt;
  return estimate.total();
}

}  // namespace adit::protocol
