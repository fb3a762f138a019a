#include "tests/fuzz/session/scenes.hpp"

#include <map>

#include "protocol/scene/reader.hpp"

namespace adit::fuzz {
namespace {

constexpr double kStep = 1e-6;  // below the critical step of each of the scenes [s]

}  // namespace

scene::Scene small_scene(const std::string& name) {
  return protocol::read_scene(ADIT_FUZZ_SCENES "/" + name + ".yaml").scene;
}

const std::vector<wire::Frame>& beginning(const std::string& scene) {
  static std::map<std::string, std::vector<wire::Frame>> known;
  std::vector<wire::Frame>& frames = known[scene];
  if (!frames.empty()) return frames;
  *frames.emplace_back().mutable_setup()->mutable_scene() = small_scene(scene);
  frames.emplace_back().mutable_weights();
  return frames;
}

wire::Frame advance_to(std::uint64_t n) {
  wire::Frame frame;
  wire::Advance& advance = *frame.mutable_advance();
  advance.set_step(n);
  advance.set_dt(kStep);
  advance.set_want_energies(true);
  advance.set_want_histories(true);
  advance.set_want_peaks(true);
  return frame;
}

}  // namespace adit::fuzz
