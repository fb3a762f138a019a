#include "coupler/bridging/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// The rows of N must sum to 1, so that N reproduces translation; then linear momentum is kept exactly,
// whatever the multipliers are.
constexpr double kRowSumTolerance = 1e-9;

}  // namespace

Interpolation::Interpolation(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                             std::vector<double> values, std::vector<double> inverse_masses,
                             std::vector<double> scaled_inverse_masses)
    : SparseRows(std::move(row_starts), std::move(columns), std::move(values)),
      inverse_masses_(std::move(inverse_masses)),
      other_inverse_masses_(std::move(scaled_inverse_masses)) {}

Interpolation::Interpolation(const wire::Operator& op, std::size_t coupling_points, const std::string& peer)
    : Interpolation({op.row_starts().begin(), op.row_starts().end()},
                    {op.columns().begin(), op.columns().end()}, {op.values().begin(), op.values().end()},
                    {op.inverse_masses().begin(), op.inverse_masses().end()},
                    {op.scaled_inverse_masses().begin(), op.scaled_inverse_masses().end()}) {
  const auto refuse = [&](const std::string& what) {
    throw protocol::PeerLost(peer, "sent an operator that cannot be used: " + what);
  };
  if (row_starts().size() != coupling_points + 1)
    refuse("it has " + std::to_string(row_starts().size()) + " row starts for " +
           std::to_string(coupling_points) + " coupling points");
  const std::size_t entries = columns().size();
  if (row_starts().front() != 0 || row_starts().back() != entries || values().size() != entries ||
      !std::ranges::is_sorted(row_starts()))
    refuse("its rows do not fit its entries");
  if (inverse_masses_.size() % 2 != 0) refuse("it has no pair of inverse masses for each point");
  for (const auto* masses : {&inverse_masses_, &other_inverse_masses_})
    for (const double inverse : *masses)
      if (!(inverse >= 0) || (inverse > 0 && !std::isnormal(1 / inverse)))
        refuse("an inverse mass is negative or not finite, or beyond that of any mass");
  if (!other_inverse_masses_.empty() && other_inverse_masses_.size() != inverse_masses_.size())
    refuse("it has not as many masses for statics as for time");
  for (const std::uint32_t column : columns())
    if (column >= own_points()) refuse("it names a point that it does not have");
  for (std::size_t k = 0; k < coupling_points; ++k) {
    double sum = 0;
    for (const double value : values(k)) sum += value;
    if (!(std::abs(sum - 1) <= kRowSumTolerance)) refuse("row " + std::to_string(k) + " does not sum to 1");
  }
}

bool Interpolation::is_selection() const {
  std::vector<bool> taken(own_points(), false);
  for (std::size_t k = 0; k < coupling_points(); ++k) {
    if (columns(k).size() != 1 || taken[columns(k)[0]]) return false;
    taken[columns(k)[0]] = true;
  }
  return true;
}

void Interpolation::scale_masses(bool scaled) {
  if (scaled != scaled_ && !other_inverse_masses_.empty()) inverse_masses_.swap(other_inverse_masses_);
  scaled_ = scaled;
}

void Interpolation::divide_by_mass(std::span<double> own) const {
  for (std::size_t i = 0; i < inverse_masses_.size(); ++i) own[i] *= inverse_masses_[i];
}

}  // namespace adit::coupler
