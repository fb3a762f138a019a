// A session of the coupler: the first frame holds the scene as `setup`, those that follow are the answers of
// its participants in the order in which they are collected.
#include <memory>

#include "coupler/participants/members.hpp"
#include "coupler/run.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/wire/content/error_frame.hpp"
#include "tests/fuzz/session/script.hpp"
#include "tests/fuzz/support/target.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::fuzz {
namespace {

class Answers {
 public:
  explicit Answers(std::vector<wire::Frame> frames) : frames_(std::move(frames)) {}

  wire::Frame next(const std::string& peer) {
    if (next_ == frames_.size()) throw protocol::PeerLost(peer, "closed the connection");
    wire::Frame& frame = frames_[next_++];
    if (frame.has_error()) protocol::throw_error(peer, frame.error());
    return std::move(frame);
  }

 private:
  std::vector<wire::Frame> frames_;
  std::size_t next_ = 1;
};

class Connection : public coupler::Connection {
 public:
  Connection(std::string name, std::shared_ptr<Answers> answers)
      : name_(std::move(name)), answers_(std::move(answers)) {}
  const std::string& name() const override { return name_; }
  void post(const wire::Frame&) override {}
  void collect(wire::Frame& reply) override { reply = answers_->next(name_); }

 private:
  std::string name_;
  std::shared_ptr<Answers> answers_;
};

void run(const scene::Scene& scene, std::vector<wire::Frame> frames) {
  const auto answers = std::make_shared<Answers>(std::move(frames));
  protocol::check_rules(scene);
  std::vector<coupler::Participant> participants;
  for (const coupler::Member& member : coupler::members(scene)) {
    coupler::Participant& participant = participants.emplace_back();
    participant.member = member;
    participant.connection = std::make_unique<Connection>(member.name, answers);
  }
  const test::ScratchFolder folder;
  coupler::run(scene, std::move(participants), {}, folder.path());
}

const Target kCouplerSession(
    "coupler_session",
    [](std::string_view input) {
      std::vector<wire::Frame> frames = frames_of(input);
      if (frames.empty() || !is_small(frames.front().setup().scene())) return;
      const scene::Scene scene = frames.front().setup().scene();
      try {
        run(scene, std::move(frames));
      } catch (const protocol::UserError& error) {
        require_one_line(error.what());
      } catch (const protocol::PeerLost& error) {
        require_one_line(error.what());
      } catch (const protocol::Unstable& error) {
        require_one_line(error.what());
      } catch (const protocol::RequestError& error) {
        require_one_line(error.what());
      }
    },
    kModelMemory);

}  // namespace
}  // namespace adit::fuzz
