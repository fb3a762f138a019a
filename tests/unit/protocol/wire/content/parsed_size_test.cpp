// Requirement: the memory of a message is known from its bytes, before it is taken.
#include "protocol/wire/content/parsed_size.hpp"

#include <gtest/gtest.h>

#include <string>

#include "protocol/messages/wire.pb.h"

namespace adit::protocol::parsed_size_test {
namespace {

std::optional<std::uint64_t> size_of(const std::string& bytes, const google::protobuf::Descriptor* type) {
  return parsed_size(std::as_bytes(std::span(bytes)), type);
}

// Between what protobuf says that the parsed message takes beyond an empty one, and twice that.
template <class Message>
void expect_near(const Message& message) {
  Message parsed;
  const std::uint64_t empty = parsed.SpaceUsedLong();
  ASSERT_TRUE(parsed.ParseFromString(message.SerializeAsString()));
  const double taken = static_cast<double>(parsed.SpaceUsedLong() - empty);
  const auto size = size_of(message.SerializeAsString(), Message::descriptor());
  ASSERT_TRUE(size.has_value());
  EXPECT_GE(static_cast<double>(*size), 0.95 * taken);
  EXPECT_LE(static_cast<double>(*size), 2.1 * taken);
}

TEST(ParsedSize, IsThatOfProtobuf) {
  constexpr int kMany = 10000;
  wire::Setup regions, friction, files;
  wire::Predicted cracks, velocities;
  wire::Model notes;
  wire::Piece cells;
  for (int i = 0; i < kMany; ++i) {
    regions.mutable_scene()->add_regions();
    auto& group = *friction.mutable_scene()->mutable_particles()->add_groups();
    group.set_name("group " + std::to_string(i));
    wire::Crack& crack = *cracks.add_cracks();
    crack.set_x(i);
    crack.set_parent_a(static_cast<std::uint64_t>(i));
    crack.set_group("a group with a long name");
    velocities.add_velocities(i);
    notes.add_notes("");
    cells.add_connectivity(static_cast<std::uint32_t>(i));
  }
  files.mutable_scene()->mutable_continuum()->mutable_mesh()->set_content(std::string(100 * kMany, 'a'));
  expect_near(regions);
  expect_near(friction);
  expect_near(files);
  expect_near(cracks);
  expect_near(velocities);
  expect_near(notes);
  expect_near(cells);
}

template <class Message>
void expect_enough(const std::string& bytes) {
  Message parsed;
  const std::uint64_t empty = parsed.SpaceUsedLong();
  ASSERT_TRUE(parsed.ParseFromString(bytes));
  EXPECT_GE(size_of(bytes, Message::descriptor()).value_or(0), parsed.SpaceUsedLong() - empty);
}

template <class Message>
void expect_counted(std::string_view field) {
  std::string bytes;
  for (int i = 0; i < 10000; ++i) bytes += field;
  expect_enough<Message>(bytes);
}

// The parser keeps what it does not know.
TEST(ParsedSize, CountsWhatIsNotKnown) {
  expect_counted<wire::Model>("\xf8\x07\x01");                      // field 127: 1
  expect_counted<wire::Model>("\x08\x01");                          // critical_dt as a whole number
  expect_counted<wire::Model>("\x0a\x01z");                         // the same as a text
  expect_counted<scene::Scene>("\x20\x7f");                         // plane: an enumerator that there is not
  expect_counted<wire::Model>("\x73\x74");                          // an empty group
  expect_counted<wire::Model>("\x73\x73\x08\x01\x74\x08\x01\x74");  // groups with numbers
}

std::string varint(std::size_t value) {
  std::string bytes;
  for (; value > 127; value >>= 7) bytes += static_cast<char>(value | 128);
  return bytes + static_cast<char>(value);
}

// A field that holds these bytes.
std::string holding(int number, const std::string& bytes) {
  return varint(static_cast<std::size_t>(number) << 3 | 2) + varint(bytes.size()) + bytes;
}

// A list whose number is known takes what it needs, and doubles when one more comes; so do those of a message
// that comes again.
TEST(ParsedSize, CountsWhatComesInPieces) {
  const std::string doubles(8000, '\1'), one(8, '\1');
  constexpr int kVelocities = wire::Predicted::kVelocitiesFieldNumber;
  const std::string list = holding(kVelocities, doubles), short_list = holding(kVelocities, one),
                    value = varint(kVelocities << 3 | 1) + one;
  for (const auto& bytes : {list, list + short_list, list + value, value + list, list + list + value + list})
    expect_enough<wire::Predicted>(bytes);

  const auto output = [](const std::string& times) {
    return holding(scene::Scene::kOutputFieldNumber, holding(scene::Output::kFieldTimesFieldNumber, times));
  };
  expect_enough<scene::Scene>(output(doubles) + output(one));
}

TEST(ParsedSize, IsNothingForBytesThatAreNoMessage) {
  const auto* type = wire::Setup::descriptor();
  EXPECT_FALSE(
      size_of("\x12\x05"
              "abc",
              type))
      << "cut short";
  EXPECT_FALSE(size_of("\xfb\x07", type)) << "a group without an end";
  EXPECT_FALSE(size_of(std::string(1, '\x00'), type)) << "field 0";
  EXPECT_FALSE(size_of("\xff", type)) << "half a tag";
}

}  // namespace
}  // namespace adit::protocol::parsed_size_test
