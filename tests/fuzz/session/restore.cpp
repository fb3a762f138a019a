#include "tests/fuzz/session/restore.hpp"

#include "protocol/state/archive.hpp"
#include "tests/fuzz/session/scenes.hpp"
#include "tests/fuzz/session/serve.hpp"

namespace adit::fuzz {
namespace {

constexpr std::uint64_t kSteps = 3;

wire::Frame restore(std::string_view state) {
  wire::Frame frame;
  wire::Restore& part = *frame.mutable_restore();
  part.set_size(state.size());
  part.set_data(std::string(state));
  part.set_checksum(state::checksum(state));
  return frame;
}

}  // namespace

bool go_on_from(std::string_view input, protocol::Participant& participant,
                const std::vector<std::string>& scenes) {
  if (input.size() < 2) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(input[i]); };
  std::vector<wire::Frame> requests = beginning(scenes[byte(0) % scenes.size()]);
  requests.push_back(restore(input.substr(2)));
  for (std::uint64_t n = byte(1); n < byte(1) + kSteps; ++n) requests.push_back(advance_to(n));
  requests.emplace_back().mutable_snapshot_request();
  requests.emplace_back().mutable_save();
  requests.emplace_back().mutable_finish();
  return serve(participant, requests);
}

}  // namespace adit::fuzz
