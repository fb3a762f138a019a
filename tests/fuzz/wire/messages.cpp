// One message as it arrives at either end, whole or in parts: what it takes in memory, its numbers, its
// texts, the rules of a scene, the soundness of an answer.
#include <algorithm>
#include <span>
#include <stdexcept>

#include "coupler/answers/answers.hpp"
#include "protocol/results/vtk.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/wire/content/finite.hpp"
#include "protocol/wire/content/parsed_size.hpp"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/parts.hpp"
#include "tests/fuzz/session/arrival.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

void require_estimated(std::string_view bytes) {
  wire::Frame frame;
  const std::size_t empty = frame.SpaceUsedLong();
  frame.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  const auto estimate = protocol::parsed_size(std::as_bytes(std::span(bytes)), wire::Frame::descriptor());
  if (!estimate || frame.SpaceUsedLong() > *estimate + empty)
    throw std::logic_error("a message takes more memory than was estimated before it was parsed");
}

void require_kept(const wire::Frame& frame) {
  protocol::FrameEncoder encoder;
  const auto bytes = encoder.encode(frame, protocol::kMaxFrameBytes).subspan(sizeof(std::uint32_t));
  const auto again = arrived({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!again || again->SerializeAsString() != frame.SerializeAsString())
    throw std::logic_error("a frame that was sent on is another one");
}

// What has parts of one name beside each other, or what this release does not know, is none of ours.
bool is_ours(const wire::Frame& frame) {
  const auto twins = [](const auto& list) {
    return std::ranges::adjacent_find(list, {}, [](const auto& one) { return one.name(); }) != list.end();
  };
  wire::Frame known = frame;
  known.DiscardUnknownFields();
  return !frame.has_setup() && known.ByteSizeLong() == frame.ByteSizeLong() &&
         !twins(frame.snapshot().pieces()) &&
         std::ranges::none_of(frame.snapshot().pieces(), [&](const wire::Piece& piece) {
           return twins(piece.point_fields()) || twins(piece.cell_fields());
         });
}

void require_same_in_parts(const wire::Frame& frame) {
  if (!is_ours(frame)) return;
  protocol::Assembly assembly;
  wire::Frame whole;
  protocol::divide(frame, sizeof(double), [&](wire::Frame part, bool goes_on) {
    if (assembly.add(part, goes_on)) whole.Swap(&part);
  });
  if (whole.SerializeAsString() != frame.SerializeAsString())
    throw std::logic_error("a message that was sent in parts is another one");
}

void draw(const wire::Snapshot& snapshot) {
  for (const wire::Piece& piece : snapshot.pieces())
    if (!results::wrong_with(piece)) results::vtk_document(piece);
}

const Target kMessages(
    "messages",
    [](std::string_view input) {
      const auto frame = arrived(input);
      if (!frame) return;
      require_estimated(input);
      require_kept(*frame);
      require_same_in_parts(*frame);
      if (const auto wrong = protocol::first_not_finite(*frame)) require_one_line(wrong->c_str());
      if (frame->has_setup()) read_or_refuse([&] { protocol::check_rules(frame->setup().scene()); });
      draw(frame->snapshot());
      try {
        coupler::require_sound(*frame, "peer");
      } catch (const protocol::PeerLost& error) {
        require_one_line(error.what());
      }
    },
    kFrameMemory);

}  // namespace
}  // namespace adit::fuzz
