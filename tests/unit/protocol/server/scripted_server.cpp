// A real server whose participant does what the run id says, for the tests of the server.
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "protocol/errors.hpp"
#include "protocol/server/server.hpp"

namespace {

using namespace adit;

class Scripted : public protocol::Participant {
 public:
  void set_up(const wire::Setup& setup, wire::Model& model) override {
    const auto& id = setup.run_id();
    slow_rest_ = id == "slow rest";
    unstable_rest_ = id == "unstable rest";
    if (id == "scene error") throw protocol::UserError("particles.radius", "must be positive");
    if (id == "unstable") throw protocol::Unstable("velocity is not finite");
    if (id == "bug") throw std::runtime_error("a bug");
    if (id == "compute for ever") std::this_thread::sleep_for(std::chrono::hours(1));
    model.set_critical_dt(0.25);
  }
  void weigh(const wire::Weights&, wire::Interface&) override {}
  void couple(const wire::Couple&, wire::Operator&) override {}
  void advance(const wire::Advance&, wire::Predicted&) override {}
  void complete() override {
    if (slow_rest_) std::this_thread::sleep_for(std::chrono::seconds(1));
    if (unstable_rest_) throw protocol::Unstable("the rest is not finite");
  }
  void snapshot(const wire::SnapshotRequest&, wire::Snapshot&) override {}
  void finish(wire::Bye& bye) override { bye.set_updates(42); }

 private:
  bool slow_rest_ = false, unstable_rest_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  protocol::Patience patience = protocol::kPatienceOfServers;
  patience.first_request = std::chrono::milliseconds(1500);
  return protocol::server_main(
      argc, argv, "scripted_server", {"particles"}, [] { return std::make_unique<Scripted>(); }, nullptr,
      patience);
}
