#include "coupler/servers/remote_connection.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "protocol/errors.hpp"
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

bool builds(wire::Frame::ContentCase request) {
  return request == wire::Frame::kSetup || request == wire::Frame::kWeights ||
         request == wire::Frame::kCouple || request == wire::Frame::kCondense;
}

}  // namespace

void AnswerBounds::asked(const wire::Frame& request) {
  if (request.has_condense()) masters_ = request.condense().masters();
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
    case wire::Frame::kCondense:
      return kMaxRunBytes + protocol::condensed_bytes(masters_);
    case wire::Frame::kAdvance:
      return kMaxRunBytes + sizeof(double) * coupling_numbers_ + kCrackBytes * bonds_;
    case wire::Frame::kSnapshotRequest:
      return std::max(protocol::kMaxFrameBytes, kMaxRunBytes + protocol::kSnapshotBytes * samples_);
    default:
      return kMaxRunBytes;
  }
}

void RemoteConnection::post(const wire::Frame& request) {
  const auto& patience = connection_->patience();
  wait_ = builds(request.content_case()) ? patience.set_up : patience.answer;
  bounds_.asked(request);
  connection_->accept_up_to(bounds_.longest(request.content_case()));
  try {
    connection_->send(request);
  } catch (const std::length_error& error) {
    throw protocol::PeerLost(name(), std::string("cannot take a request: ") + error.what());
  }
}

void RemoteConnection::collect(wire::Frame& reply) {
  connection_->receive(reply, wait_);
  bounds_.answered(reply);
}

}  // namespace adit::coupler
