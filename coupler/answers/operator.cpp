#include "coupler/answers/operator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// The rows of N must sum to 1, so that N reproduces translation; then linear momentum is kept exactly,
// whatever the multipliers are.
constexpr double kRowSumTolerance = 1e-9;

void check(const wire::Operator& op, std::size_t coupling_points, const std::string& peer) {
  const auto refuse = [&](const std::string& what) {
    throw protocol::PeerLost(peer, "sent an operator that cannot be used: " + what);
  };
  const auto &starts = op.row_starts(), &columns = op.columns();
  if (static_cast<std::size_t>(starts.size()) != coupling_points + 1)
    refuse("it has " + std::to_string(starts.size()) + " row starts for " + std::to_string(coupling_points) +
           " coupling points");
  const int entries = columns.size();
  if (starts[0] != 0 || *starts.rbegin() != static_cast<std::uint32_t>(entries) ||
      op.values_size() != entries || !std::ranges::is_sorted(starts))
    refuse("its rows do not fit its entries");
  if (op.inverse_masses_size() % 2 != 0) refuse("it has no pair of inverse masses for each point");
  for (const auto* masses : {&op.inverse_masses(), &op.scaled_inverse_masses()})
    for (const double inverse : *masses)
      if (!(inverse >= 0) || (inverse > 0 && !std::isnormal(1 / inverse)))
        refuse("an inverse mass is negative or not finite, or beyond that of any mass");
  if (op.scaled_inverse_masses_size() > 0 && op.scaled_inverse_masses_size() != op.inverse_masses_size())
    refuse("it has not as many masses for statics as for time");
  for (const std::uint32_t column : columns)
    if (column >= static_cast<std::uint32_t>(op.inverse_masses_size() / 2))
      refuse("it names a point that it does not have");
  for (std::size_t k = 0; k < coupling_points; ++k) {
    const auto row = static_cast<int>(k);
    const double sum =
        std::accumulate(op.values().begin() + starts[row], op.values().begin() + starts[row + 1], 0.0);
    if (!(std::abs(sum - 1) <= kRowSumTolerance)) refuse("row " + std::to_string(k) + " does not sum to 1");
  }
}

}  // namespace

Interpolation interpolation_of(const wire::Operator& op, std::size_t coupling_points,
                               const std::string& peer) {
  check(op, coupling_points, peer);
  return {{op.row_starts().begin(), op.row_starts().end()},
          {op.columns().begin(), op.columns().end()},
          {op.values().begin(), op.values().end()},
          {op.inverse_masses().begin(), op.inverse_masses().end()},
          {op.scaled_inverse_masses().begin(), op.scaled_inverse_masses().end()}};
}

}  // namespace adit::coupler
