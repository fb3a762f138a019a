#include "coupler/side.hpp"

#include <algorithm>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// A region's model stands under `continuum` or `particles` in what its participant sees.
std::string path_in_scene(const std::string& path, const Member& member) {
  const std::string own = to_string(member.role);
  return path.rfind(own, 0) == 0 ? member.path + path.substr(own.size()) : path;
}

}  // namespace

void collect(Side& side, wire::Frame::ContentCase expected) {
  try {
    side.peer->collect(side.reply);
  } catch (const protocol::UserError& error) {
    throw protocol::UserError(path_in_scene(error.path(), side.member), error.what());
  }
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
