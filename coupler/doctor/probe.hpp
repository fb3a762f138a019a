// Real steps of a model that costs a server next to nothing, to measure the exchange with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "coupler/participants/members.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

struct Exchange {
  std::uint64_t steps = 0;
  std::size_t points = 0;  // coupling points of the model
  // From a request to its answer, without what the server says that it computed [s]: of half of the steps, of
  // 95 % of them.
  double median = 0, most = 0;
  double bytes_sent = 0, bytes_received = 0;  // a step
};

// Takes the participant at the other end, which has greeted, through a whole run: a bar of
// zones or discs that nothing moves, coupled at `points` of them with half their weight. Throws what a run
// throws; a UserError where the participant does not compute such a model.
Exchange measure_exchange(std::unique_ptr<protocol::Connection> connection, Role role, std::size_t points);

}  // namespace adit::coupler
