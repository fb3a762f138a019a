#include "coupler/servers/remote_connection.hpp"

#include <stdexcept>
#include <string>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

bool builds(wire::Frame::ContentCase request) {
  return request == wire::Frame::kSetup || request == wire::Frame::kWeights ||
         request == wire::Frame::kCouple;
}

}  // namespace

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
