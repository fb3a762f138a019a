#include "protocol/wire/content/error_frame.hpp"

#include "protocol/machine/refusal.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {

void fill_error(const std::exception& cause, wire::Error& error) {
  error.set_message(one_line(cause.what()));
  if (const auto* user_error = dynamic_cast<const UserError*>(&cause)) {
    error.set_kind(wire::Error::SCENE);
    error.set_path(one_line(user_error->path()));
  } else if (dynamic_cast<const Unstable*>(&cause) != nullptr) {
    error.set_kind(wire::Error::UNSTABLE);
  } else if (dynamic_cast<const RequestError*>(&cause) != nullptr) {
    error.set_kind(wire::Error::REQUEST);
  } else if (const auto refusal = refusal_of(cause)) {
    error.set_kind(wire::Error::SCENE);
    error.set_message(one_line(refusal->message));
  } else {
    error.set_kind(wire::Error::INTERNAL);
  }
}

void throw_error(const std::string& peer, const wire::Error& error) {
  constexpr std::size_t kLongest = 2000;  // that a user reads, however much a peer says
  std::string message = error.message();
  if (message.size() > kLongest) message = valid_utf8(message.substr(0, kLongest)) + " ...";
  switch (error.kind()) {
    case wire::Error::SCENE:
      // Without a place in the scene it is something of the peer's machine.
      throw UserError(error.path(), error.path().empty() ? peer + ": " + message : message);
    case wire::Error::UNSTABLE:
      throw Unstable(peer + ": " + message);
    case wire::Error::REFUSED:
      throw UserError("", peer + " refused: " + message);
    case wire::Error::REQUEST:
      throw RequestError(peer + " cannot answer: " + message);
    default:
      throw PeerLost(peer, message);
  }
}

}  // namespace adit::protocol
