#include "coupler/side.hpp"

#include "protocol/errors.hpp"

namespace adit::coupler {

const char* to_string(Role role) {
  return role == Role::kContinuum ? "continuum" : "particles";
}

void collect(Side& side, wire::Frame::ContentCase expected) {
  side.peer->collect(side.reply);
  if (side.reply.content_case() == expected) return;
  const auto* descriptor = wire::Frame::descriptor();
  const auto name = [&](int number) {
    const auto* field = descriptor->FindFieldByNumber(number);
    return field ? field->name() : std::string("nothing");
  };
  throw protocol::PeerLost(side.peer->name(), "answered " + name(side.reply.content_case()) + " where " +
                                                  name(expected) + " was expected");
}

}  // namespace adit::coupler
