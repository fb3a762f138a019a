#include "coupler/bridging/interpolation.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using Pair = Eigen::Array2d;  // x, y: one vector of the processor
Eigen::Map<Pair> pair(std::span<double> values, std::size_t k) {
  return Eigen::Map<Pair>(&values[2 * k]);
}
Eigen::Map<const Pair> pair(std::span<const double> values, std::size_t k) {
  return Eigen::Map<const Pair>(&values[2 * k]);
}

// N must reproduce rigid motion: that is what keeps linear momentum exact, whatever the multipliers are.
constexpr double kRowSumTolerance = 1e-9;

}  // namespace

Interpolation::Interpolation(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                             std::vector<double> values, std::vector<double> inverse_masses)
    : row_starts_(std::move(row_starts)),
      columns_(std::move(columns)),
      values_(std::move(values)),
      inverse_masses_(std::move(inverse_masses)) {}

Interpolation::Interpolation(const wire::Operator& op, std::size_t coupling_points, const std::string& peer)
    : Interpolation({op.row_starts().begin(), op.row_starts().end()},
                    {op.columns().begin(), op.columns().end()}, {op.values().begin(), op.values().end()},
                    {op.inverse_masses().begin(), op.inverse_masses().end()}) {
  const auto refuse = [&](const std::string& what) {
    throw protocol::PeerLost(peer, "sent an operator that cannot be used: " + what);
  };
  if (row_starts_.size() != coupling_points + 1)
    refuse("it has " + std::to_string(row_starts_.size()) + " row starts for " +
           std::to_string(coupling_points) + " coupling points");
  if (row_starts_.front() != 0 || row_starts_.back() != columns_.size() ||
      columns_.size() != values_.size() || !std::is_sorted(row_starts_.begin(), row_starts_.end()))
    refuse("its rows do not fit its entries");
  if (inverse_masses_.size() % 2 != 0) refuse("it has no pair of inverse masses for each point");
  for (const double inverse : inverse_masses_)
    if (!(inverse >= 0) || !std::isfinite(inverse)) refuse("an inverse mass is negative or not finite");
  for (const std::uint32_t column : columns_)
    if (column >= own_points()) refuse("it names a point that it does not have");
  for (std::size_t k = 0; k < coupling_points; ++k) {
    double sum = 0;
    for (const double value : values(k)) sum += value;
    if (!(std::abs(sum - 1) <= kRowSumTolerance)) refuse("row " + std::to_string(k) + " does not sum to 1");
  }
}

std::span<const std::uint32_t> Interpolation::columns(std::size_t row) const {
  return std::span(columns_).subspan(row_starts_[row], row_starts_[row + 1] - row_starts_[row]);
}

std::span<const double> Interpolation::values(std::size_t row) const {
  return std::span(values_).subspan(row_starts_[row], row_starts_[row + 1] - row_starts_[row]);
}

bool Interpolation::is_selection() const {
  std::vector<bool> taken(own_points(), false);
  for (std::size_t k = 0; k < coupling_points(); ++k) {
    if (columns(k).size() != 1 || taken[columns(k)[0]]) return false;
    taken[columns(k)[0]] = true;
  }
  return true;
}

void Interpolation::gather(std::span<const double> impulses, std::span<double> own) const {
  std::fill(own.begin(), own.end(), 0.0);
  const std::uint32_t* column = columns_.data();
  const double* value = values_.data();
  for (std::size_t k = 0; k < coupling_points(); ++k) {
    const Pair impulse = pair(impulses, k);
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e)
      pair(own, column[e]) += value[e] * impulse;
  }
}

void Interpolation::interpolate(std::span<const double> own, std::span<double> velocities) const {
  const std::uint32_t* column = columns_.data();
  const double* value = values_.data();
  for (std::size_t k = 0; k < coupling_points(); ++k) {
    Pair velocity = Pair::Zero();
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e)
      velocity += value[e] * pair(own, column[e]);
    pair(velocities, k) = velocity;
  }
}

void Interpolation::divide_by_mass(std::span<double> own) const {
  for (std::size_t i = 0; i < inverse_masses_.size(); ++i) own[i] *= inverse_masses_[i];
}

}  // namespace adit::coupler
