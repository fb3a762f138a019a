// dem_server, but it answers when the whole step is computed, and leaves nothing to be hidden behind the
// exchange: what tools/bench network compares it with.
#include <memory>

#include "dem_server/participant/participant.hpp"
#include "protocol/server/server.hpp"

namespace {

namespace wire = adit::wire;

class LateParticles : public adit::protocol::Participant {
 public:
  explicit LateParticles(std::size_t threads) : particles_(threads) {}

  void set_up(const wire::Setup& setup, wire::Model& model) override { particles_.set_up(setup, model); }
  void weigh(const wire::Weights& weights, wire::Interface& interface) override {
    particles_.weigh(weights, interface);
  }
  void couple(const wire::Couple& couple, wire::Operator& op) override { particles_.couple(couple, op); }
  void advance(const wire::Advance& request, wire::Predicted& predicted) override {
    particles_.advance(request, predicted);
    particles_.complete();
  }
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override {
    particles_.snapshot(request, snapshot);
  }
  void finish(wire::Bye& bye) override { particles_.finish(bye); }

 private:
  adit::dem::DemParticipant particles_;
};

}  // namespace

int main(int argc, char** argv) {
  std::size_t threads = 0;
  return adit::protocol::server_main(
      argc, argv, "late_particles", {"name", "description", "plane", "material", "time", "particles"},
      [&] { return std::make_unique<LateParticles>(threads); }, &threads);
}
