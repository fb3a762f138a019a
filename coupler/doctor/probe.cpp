#include "coupler/doctor/probe.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "coupler/servers/remote_connection.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSeconds = 0.5;         // for all steps
constexpr std::size_t kWarmUp = 200;     // steps that are not counted: memory is touched for the first time
constexpr std::size_t kLeastSteps = 20;  // counted, however long they take
constexpr double kWeight = 0.5;

// One row of zones, or of bonded discs side by side, each of 1 m; one more than points, since a disc alone
// has no bond.
scene::Scene bar(Role role, std::size_t points) {
  const std::size_t length = points + 1;
  scene::Scene scene;
  scene.mutable_material()->set_young_modulus(1e9);
  scene.mutable_material()->set_poisson_ratio(0.2);
  scene.mutable_material()->set_density(2000);
  scene.mutable_time()->set_duration(1);
  const auto place = [length](auto& box) {
    box.set_x_min(0);
    box.set_x_max(static_cast<double>(length));
    box.set_y_min(0);
    box.set_y_max(1);
  };
  if (role == Role::kContinuum) {
    auto& block = *scene.mutable_continuum()->mutable_block();
    place(block);
    block.set_zones_x(static_cast<std::uint32_t>(length));
    block.set_zones_y(1);
  } else {
    auto& packing = *scene.mutable_particles()->mutable_packing();
    place(packing);
    packing.set_radius(0.5);
    scene.mutable_particles()->mutable_bonds();
  }
  return scene;
}

const wire::Frame& ask(Participant& participant, wire::Frame::ContentCase expected) {
  participant.connection->post(participant.request);
  collect(participant, expected);
  return participant.reply;
}

// Up to `points` of those that the participant offers.
std::size_t couple(Participant& participant, std::size_t points) {
  auto& weights = *participant.request.mutable_weights();
  weights.mutable_weights()->Resize(participant.model.sample_points_size() / 2, kWeight);
  weights.set_floor(1e-3);
  weights.set_x_min(participant.model.x_min());
  weights.set_x_max(participant.model.x_max());
  weights.set_y_min(participant.model.y_min());
  weights.set_y_max(participant.model.y_max());
  const auto offered = ask(participant, wire::Frame::kInterface).interface().points();
  const int numbers = std::min(offered.size(), static_cast<int>(2 * points)) / 2 * 2;
  auto& chosen = *participant.request.mutable_couple()->mutable_points();
  chosen.Add(offered.begin(), offered.begin() + numbers);
  ask(participant, wire::Frame::kOperator);
  return static_cast<std::size_t>(numbers) / 2;
}

double share(std::vector<double>& values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Exchange measure_exchange(std::unique_ptr<protocol::Connection> connection, Role role, std::size_t points) {
  const protocol::Connection& wire = *connection;
  Participant participant;
  participant.member = {to_string(role), role, to_string(role)};
  participant.connection = std::make_unique<RemoteConnection>(std::move(connection));
  participant.request.mutable_setup()->set_run_id("doctor");
  *participant.request.mutable_setup()->mutable_scene() = bar(role, points);
  ask(participant, wire::Frame::kModel);
  participant.model.Swap(participant.reply.mutable_model());

  Exchange exchange;
  exchange.points = couple(participant, points);
  auto& advance = *participant.request.mutable_advance();
  advance.set_dt(participant.model.critical_dt() / 2);
  std::vector<double> seconds;
  protocol::Traffic before;
  const auto start = Clock::now();
  for (std::size_t step = 0;; ++step) {
    if (step == kWarmUp) before = wire.traffic();
    advance.set_step(step);
    if (step == 1) advance.mutable_impulses()->Resize(static_cast<int>(2 * exchange.points), 0);
    const auto asked = Clock::now();
    const wire::Predicted& predicted = ask(participant, wire::Frame::kPredicted).predicted();
    const std::chrono::duration<double> took = Clock::now() - asked;
    if (step < kWarmUp) continue;
    seconds.push_back(std::max(0.0, took.count() - predicted.compute_seconds() - predicted.hidden_seconds()));
    if (seconds.size() >= kLeastSteps && Clock::now() - start > std::chrono::duration<double>(kSeconds))
      break;
  }
  const protocol::Traffic after = wire.traffic();
  exchange.steps = seconds.size();
  exchange.bytes_sent =
      static_cast<double>(after.bytes_sent - before.bytes_sent) / static_cast<double>(exchange.steps);
  exchange.bytes_received =
      static_cast<double>(after.bytes_received - before.bytes_received) / static_cast<double>(exchange.steps);
  exchange.median = share(seconds, 0.5);
  exchange.most = share(seconds, 0.95);
  participant.request.mutable_finish();
  ask(participant, wire::Frame::kBye);
  return exchange;
}

}  // namespace adit::coupler
