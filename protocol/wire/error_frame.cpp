#include "protocol/wire/error_frame.hpp"

namespace adit::protocol {

void fill_error(const std::exception& cause, wire::Error& error) {
  error.set_message(cause.what());
  if (const auto* user_error = dynamic_cast<const UserError*>(&cause)) {
    error.set_kind(wire::Error::SCENE);
    error.set_path(user_error->path());
  } else if (dynamic_cast<const Unstable*>(&cause) != nullptr) {
    error.set_kind(wire::Error::UNSTABLE);
  } else if (dynamic_cast<const RequestError*>(&cause) != nullptr) {
    error.set_kind(wire::Error::REQUEST);
  } else {
    error.set_kind(wire::Error::INTERNAL);
  }
}

void throw_error(const std::string& peer, const wire::Error& error) {
  switch (error.kind()) {
    case wire::Error::SCENE:
      throw UserError(error.path(), error.message());
    case wire::Error::UNSTABLE:
      throw Unstable(peer + ": " + error.message());
    case wire::Error::REFUSED:
      throw UserError("", peer + " refused: " + error.message());
    case wire::Error::REQUEST:
      throw RequestError(peer + " cannot answer: " + error.message());
    default:
      throw PeerLost(peer, error.message());
  }
}

}  // namespace adit::protocol
