// Writes first inputs into a folder, TARGET/NAME each, from the scenes of tests/fuzz/scenes and what the
// programs say to each other about them: fuzz_seeds FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "coupler/run.hpp"
#include "dem_server/participant/participant.hpp"
#include "fdm_server/participant/participant.hpp"
#include "protocol/wire/frame.hpp"
#include "tests/fuzz/session/restore.hpp"
#include "tests/fuzz/session/scenes.hpp"
#include "tests/fuzz/session/script.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFrames = 12;  // of a session

void write(const fs::path& file, std::string_view content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

std::string payload(const wire::Frame& frame) {
  return frame.SerializeAsString();
}

struct Heard {
  std::vector<wire::Frame> requests, answers;
};

// A participant whose words are noted, by itself and in the order in which the coupler hears all of them.
class Noted : public coupler::Connection {
 public:
  Noted(std::unique_ptr<coupler::Connection> inner, Heard& own, std::vector<wire::Frame>& all)
      : inner_(std::move(inner)), own_(own), all_(all) {}
  const std::string& name() const override { return inner_->name(); }
  void post(const wire::Frame& request) override {
    own_.requests.push_back(request);
    inner_->post(request);
  }
  void collect(wire::Frame& reply) override {
    inner_->collect(reply);
    own_.answers.push_back(reply);
    all_.push_back(reply);
  }

 private:
  std::unique_ptr<coupler::Connection> inner_;
  Heard& own_;
  std::vector<wire::Frame>& all_;
};

void shorten(std::vector<wire::Frame>& frames) {
  if (frames.size() > kMostFrames) frames.resize(kMostFrames);
}

// One frame of each kind.
void write_messages(const std::vector<wire::Frame>& frames, const std::string& scene,
                    const fs::path& folder) {
  for (const wire::Frame& frame : frames) {
    const auto* kind = wire::Frame::descriptor()->FindFieldByNumber(frame.content_case());
    write(folder / "messages" / (kind->name() + "_" + scene), payload(frame));
  }
}

void run_noted(const std::string& name, const fs::path& folder) {
  const scene::Scene scene = small_scene(name);
  std::vector<coupler::Participant> participants = test::local_participants(scene);
  std::vector<Heard> heard(participants.size());
  std::vector<wire::Frame> all(1);
  *all[0].mutable_setup()->mutable_scene() = scene;
  for (std::size_t k = 0; k < participants.size(); ++k)
    participants[k].connection =
        std::make_unique<Noted>(std::move(participants[k].connection), heard[k], all);
  const bool has_zones = scene.has_continuum(), is_alone = heard.size() == 1;
  const test::ScratchFolder results;
  try {
    coupler::run(scene, std::move(participants), {}, results.path());
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
  }
  for (std::size_t k = 0; k < heard.size(); ++k) {
    const char* session = has_zones && k == 0 ? "fdm_session" : "dem_session";
    write_messages(heard[k].requests, name, folder);
    write_messages(heard[k].answers, is_alone ? name : name + std::to_string(k), folder);
    shorten(heard[k].requests);
    write(folder / session / name, script_of(heard[k].requests));
  }
  shorten(all);
  write(folder / "coupler_session" / name, script_of(all));
}

// The state before the first step, and after some.
template <class Participant>
void write_states(const std::vector<std::string>& scenes, const fs::path& folder) {
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    Participant participant;
    protocol::Conversation conversation(participant);
    wire::Frame reply, save;
    save.mutable_save();
    const auto note = [&](char next) {
      conversation.answer(save, reply);
      write(folder / (scenes[k] + "_" + std::to_string(int{next})),
            std::string{static_cast<char>(k), next} + reply.state().data());
    };
    for (const wire::Frame& request : beginning(scenes[k])) conversation.answer(request, reply);
    note(0);
    for (char n = 0; n < 3; ++n) conversation.answer(advance_to(static_cast<std::uint64_t>(n)), reply);
    note(3);
  }
}

// A greeting and some requests as one stream of bytes.
void write_stream(const fs::path& folder) {
  std::string stream(1, '\x05');
  const auto add = [&](std::span<const std::byte> bytes) {
    stream.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  add(protocol::encode_preamble());
  wire::Frame hello;
  hello.mutable_hello()->set_protocol_version(protocol::kProtocolVersion);
  hello.mutable_hello()->set_program("coupler");
  hello.mutable_hello()->set_max_frame_bytes(protocol::kMaxFrameBytes);
  hello.mutable_hello()->set_challenge(std::string(32, '?'));
  wire::Frame proof;
  proof.mutable_proof()->set_hmac(std::string(32, '!'));
  protocol::FrameEncoder encoder;
  for (const wire::Frame& frame : {hello, proof, advance_to(0), advance_to(1)}) {
    add(encoder.encode(frame, protocol::kMaxFrameBytes));
    add(protocol::heartbeat_frame());
  }
  write(folder / "greeting_and_steps", stream);
}

}  // namespace
}  // namespace adit::fuzz

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "fuzz_seeds FOLDER\n";
    return 2;
  }
  using namespace adit;
  const std::filesystem::path folder = argv[1];
  for (const char* scene :
       {"block", "ground", "slipping", "lattice", "grains", "ring", "cells", "coupled", "at_rest"})
    fuzz::run_noted(scene, folder);
  fuzz::write_states<fdm::FdmParticipant>(fuzz::kScenesOfGround, folder / "fdm_state");
  fuzz::write_states<dem::DemParticipant>(fuzz::kScenesOfParticles, folder / "dem_state");
  fuzz::write_stream(folder / "frames");
}
