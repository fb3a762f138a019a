#include "fdm_server/water/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "protocol/kernels/sums.hpp"

namespace adit::fdm {
namespace {

using protocol::IndexRange;

constexpr std::uint32_t kChunk = 4096;  // zones worth a thread's call

std::vector<IndexRange> pieces(std::span<const IndexRange> ranges) {
  std::vector<IndexRange> result;
  for (const auto [first, last] : ranges)
    for (std::uint32_t begin = first; begin < last; begin += kChunk)
      result.push_back({begin, std::min(begin + kChunk, last)});
  return result;
}

// u beyond a side less that of its zone.
double rise(const WaterPassage& passage, std::span<const double> u, double own) {
  return (passage.beyond == kOpenSide ? 0 : u[passage.beyond]) - own;
}

// The magnitudes of the coefficients of rise().
double magnitude(const WaterPassage& passage) {
  return passage.beyond == kOpenSide ? 1 : 2;
}

bool has_passage(const WaterPassages& passages) {
  return std::ranges::any_of(passages,
                             [](const WaterPassage& passage) { return passage.transmissibility > 0; });
}

}  // namespace

Flow::Flow(const Grid& grid, Faces faces, std::span<const double> stiffness)
    : faces_(std::move(faces)),
      transmissibilities_(grid.zones.size()),
      stiffness_(stiffness.begin(), stiffness.end()),
      per_area_(grid.zones.size()) {
  std::vector<bool> flows(grid.zones.size());
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z) {
    flows[z] = has_passage(faces_.of_zone[z]);
    per_area_[z] = 1 / area(corners(grid, z));
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [transmissibility, beyond] = faces_.of_zone[z][c];
      transmissibilities_[c][z] = transmissibility;
      if (beyond == kOpenSide) outlets_.push_back({z, transmissibility});
    }
  }
  chunks_ = pieces(protocol::index_ranges(flows, true));
  for (const IndexRange& chunk : chunks_) runs_.push_back(lay_out(chunk, faces_.of_zone));
  energies_.resize(chunks_.size());
  if (!faces_.skewed.empty()) {
    const IndexRange all{0, static_cast<std::uint32_t>(faces_.skewed.size())};
    skewed_chunks_ = pieces({&all, 1});
    gradients_.resize(grid.zones.size(), Eigen::Vector2d::Zero());  // also beyond, where no zone is skewed
    crossing_.resize(grid.zones.size());
  }
  critical_step_ = 1 / largest_row();
}

std::vector<Flow::Run> Flow::lay_out(const IndexRange& zones, std::span<const WaterPassages> passages) {
  std::vector<Run> runs;
  const auto continues = [&](std::uint32_t zone) {
    if (runs.empty() || runs.back().count == kBatch) return false;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint32_t first = runs.back().beyond[c];
      if (passages[zone][c].beyond != (first == kOpenSide ? first : first + runs.back().count)) return false;
    }
    return true;
  };
  for (std::uint32_t z = zones.begin; z < zones.end; ++z)
    if (continues(z)) {
      ++runs.back().count;
    } else {
      Run& run = runs.emplace_back(Run{z, 1, {}});
      for (std::size_t c = 0; c < 4; ++c) run.beyond[c] = passages[z][c].beyond;
    }
  return runs;
}

// Where u is within -1 and 1, |-du/dt| is at most the sum of magnitudes in a row.
double Flow::largest_row() const {
  std::vector<double> gradients(faces_.skewed.empty() ? 0 : per_area_.size(), 0.0),
      rows(per_area_.size(), 0.0);
  for (const SkewedZone& skewed : faces_.skewed)
    for (std::size_t c = 0; c < 4; ++c)
      gradients[skewed.zone] += skewed.slope[c].norm() * magnitude(faces_.of_zone[skewed.zone][c]);
  for (const SkewedZone& skewed : faces_.skewed) {
    Eigen::Vector2d own = Eigen::Vector2d::Zero();
    for (std::size_t c = 0; c < 4; ++c) {
      own += skewed.cross[c];
      const std::uint32_t beyond = faces_.of_zone[skewed.zone][c].beyond;
      if (beyond != kOpenSide) rows[skewed.zone] += skewed.cross[c].norm() * gradients[beyond];
    }
    rows[skewed.zone] += own.norm() * gradients[skewed.zone];
  }
  double largest = 0;
  for (const auto [begin, end] : chunks_)
    for (std::uint32_t z = begin; z < end; ++z) {
      for (const WaterPassage& side : faces_.of_zone[z]) rows[z] += side.transmissibility * magnitude(side);
      largest = std::max(largest, rows[z] / storage(z));
    }
  return largest;
}

void Flow::step(protocol::Team& team, double dt, std::span<const double> excess, std::span<double> inflow) {
  cross(team, excess);
  const auto flowing = dt <= critical_step_ ? excess : end_of_step(dt, excess);
  gather(team, dt, flowing, excess, inflow);
  for (const Outlet& outlet : outlets_) left_ += dt * outlet.transmissibility * flowing[outlet.zone];
  dissipated_ = std::accumulate(energies_.begin(), energies_.end(), dissipated_);
}

// Both zones of a side add the same two gradients in sum: what one gets the other gives, to the last bit.
void Flow::cross(protocol::Team& team, std::span<const double> excess) {
  team.run(skewed_chunks_.size(), [&](std::size_t chunk, std::size_t) {
    for (std::uint32_t k = skewed_chunks_[chunk].begin; k < skewed_chunks_[chunk].end; ++k) {
      const SkewedZone& skewed = faces_.skewed[k];
      Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
      for (std::size_t c = 0; c < 4; ++c)
        gradient += skewed.slope[c] * rise(faces_.of_zone[skewed.zone][c], excess, excess[skewed.zone]);
      gradients_[skewed.zone] = gradient;
    }
  });
  team.run(skewed_chunks_.size(), [&](std::size_t chunk, std::size_t) {
    for (std::uint32_t k = skewed_chunks_[chunk].begin; k < skewed_chunks_[chunk].end; ++k) {
      const SkewedZone& skewed = faces_.skewed[k];
      double sum = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        const std::uint32_t beyond = faces_.of_zone[skewed.zone][c].beyond;
        if (beyond != kOpenSide) sum += skewed.cross[c].dot(gradients_[skewed.zone] + gradients_[beyond]);
      }
      crossing_[skewed.zone] = sum;
    }
  });
}

// (storage + dt L) u = storage u before + dt crossing, L the two-point part.
std::span<const double> Flow::end_of_step(double dt, std::span<const double> excess) {
  if (!factor_ || factor_step_ != dt) factor(dt);
  Eigen::Index row = 0;
  for (const auto [begin, end] : chunks_)
    for (std::uint32_t z = begin; z < end; ++z)
      solution_[factor_->place(row++)] = storage(z) * excess[z] + (crossing_.empty() ? 0 : dt * crossing_[z]);
  factor_->solve(solution_);
  row = 0;
  for (const auto [begin, end] : chunks_)
    for (std::uint32_t z = begin; z < end; ++z) end_[z] = solution_[factor_->place(row++)];
  return end_;
}

void Flow::factor(double dt) {
  std::vector<int> row_of(per_area_.size(), 0);
  int rows = 0;
  for (const auto [begin, end] : chunks_)
    for (std::uint32_t z = begin; z < end; ++z) row_of[z] = rows++;
  std::vector<Eigen::Triplet<double>> lower;
  for (const auto [begin, end] : chunks_)
    for (std::uint32_t z = begin; z < end; ++z) {
      lower.emplace_back(row_of[z], row_of[z], storage(z));
      for (const auto& [transmissibility, beyond] : faces_.of_zone[z]) {
        lower.emplace_back(row_of[z], row_of[z], dt * transmissibility);
        if (beyond != kOpenSide && beyond < z)
          lower.emplace_back(row_of[z], row_of[beyond], -dt * transmissibility);
      }
    }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(lower.begin(), lower.end());
  factor_.emplace(matrix);
  factor_step_ = dt;
  solution_.resize(rows);
  end_.resize(per_area_.size());
}

void Flow::gather(protocol::Team& team, double dt, std::span<const double> flowing,
                  std::span<const double> excess, std::span<double> inflow) {
  team.run(chunks_.size(), [&](std::size_t chunk, std::size_t) {
    double energy = 0;
    for (const Run& run : runs_[chunk]) energy += gather(run, dt, flowing, excess, inflow);
    energies_[chunk] = energy;
  });
}

// The energy that a zone loses is that of the mean pressure of the step, u + M zeta/2.
double Flow::gather(const Run& run, double dt, std::span<const double> flowing,
                    std::span<const double> excess, std::span<double> inflow) const {
  const auto own = [&](std::span<const double> values) { return values.data() + run.first; };
  const auto beyond = [&](std::size_t c) {
    return run.beyond[c] == kOpenSide ? zeros_.data() : flowing.data() + run.beyond[c];
  };
  const auto transmissibility = [&](std::size_t c) { return own(transmissibilities_[c]); };
  const double *t0 = transmissibility(0), *t1 = transmissibility(1), *t2 = transmissibility(2),
               *t3 = transmissibility(3), *u0 = beyond(0), *u1 = beyond(1), *u2 = beyond(2), *u3 = beyond(3);
  const double *u = own(flowing), *before = own(excess), *stiffness = own(stiffness_),
               *per_area = own(per_area_), *crossing = crossing_.empty() ? zeros_.data() : own(crossing_);
  double* zeta = inflow.data() + run.first;
  return protocol::eight_sums(0, run.count, [&](std::size_t i) {
    const double rate =
        (((crossing[i] + t0[i] * (u0[i] - u[i])) + t1[i] * (u1[i] - u[i])) + t2[i] * (u2[i] - u[i])) +
        t3[i] * (u3[i] - u[i]);
    const double volume = dt * rate;
    zeta[i] = volume * per_area[i];
    return -volume * (before[i] + 0.5 * stiffness[i] * zeta[i]);
  });
}

}  // namespace adit::fdm
