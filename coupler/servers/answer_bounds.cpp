#include "coupler/servers/answer_bounds.hpp"

#include <algorithm>

#include "protocol/wire/bounds.hpp"

namespace adit::coupler {
namespace {

using protocol::kMaxRunBytes;

// Of the operator, for each number that states a coupling point: rows of some tens of entries.
constexpr std::uint64_t kOperatorBytes = 512;
// Of a step: for each bond, that it broke; else kMaxRunBytes hold histories, energies and the like.
constexpr std::uint64_t kCrackBytes = 256;
// Bonds that a model may have for each of its sample points.
constexpr std::uint64_t kMostBonds = 4;

}  // namespace

void AnswerBounds::asked(const wire::Frame& request) {
  if (request.has_couple()) coupling_numbers_ = static_cast<std::uint64_t>(request.couple().points_size());
}

void AnswerBounds::answered(const wire::Frame& answer) {
  if (answer.has_model()) samples_ = static_cast<std::uint64_t>(answer.model().sample_points_size()) / 2;
  if (answer.has_interface()) bonds_ = std::min(answer.interface().bonds(), kMostBonds * samples_);
}

std::uint64_t AnswerBounds::longest(wire::Frame::ContentCase request) const {
  switch (request) {
    case wire::Frame::kSetup:
      return protocol::kMaxModelBytes;
    case wire::Frame::kWeights:
      return kMaxRunBytes + protocol::kInterfaceBytes * samples_;
    case wire::Frame::kCouple:
      return kMaxRunBytes + kOperatorBytes * coupling_numbers_;
    case wire::Frame::kAdvance:
      return kMaxRunBytes + sizeof(double) * coupling_numbers_ + kCrackBytes * bonds_;
    case wire::Frame::kSnapshotRequest:
      return std::max(protocol::kMaxFrameBytes, kMaxRunBytes + protocol::kSnapshotBytes * samples_);
    default:
      return kMaxRunBytes;
  }
}

}  // namespace adit::coupler
