#include "fdm_server/solver/sweep.hpp"

#include <algorithm>
#include <numeric>
#include <thread>

#include "fdm_server/solver/damping.hpp"
#include "protocol/kernels/prefetch.hpp"
#include "protocol/participant/local_damping.hpp"

namespace adit::fdm {
namespace {

using protocol::IndexRange;

// Sizes in zones. A chunk is worth a thread's call and has many rows, so that few points belong to two.
constexpr std::size_t kLeastChunk = 4096, kRows = 16, kBlock = 512;
// Grids of more points than caches hold are asked for two blocks ahead. Their blocks are so short that all
// that one asks for can be under way at once.
constexpr std::size_t kCached = 1 << 18, kAhead = 2;
constexpr std::uint32_t kStreamed = 64;

// Where numbers are multiples of `longest`: batches of zones end there, too.
std::vector<ZoneRun> cut(std::span<const ZoneRun> runs, std::uint32_t longest) {
  std::vector<ZoneRun> parts;
  for (ZoneRun rest : runs)
    while (rest.count > 0) {
      ZoneRun& part = parts.emplace_back(rest);
      part.count = std::min(rest.count, longest - rest.first % longest);
      rest.first += part.count;
      rest.count -= part.count;
      for (auto& point : rest.points) point += static_cast<std::int32_t>(part.count);
    }
  return parts;
}

// Calls visit(point) for each corner of each zone.
template <class Visit>
void for_each_corner(std::span<const ZoneRun> runs, Visit&& visit) {
  for (const ZoneRun& run : runs)
    for (std::uint32_t k = 0; k < run.count; ++k)
      for (const auto point : run.points) visit(static_cast<std::uint32_t>(point) + k);
}

// Cuts runs into pieces of about `size` zones.
std::vector<std::span<const ZoneRun>> pieces(std::span<const ZoneRun> runs, std::size_t size) {
  std::size_t zones = 0;
  for (const ZoneRun& run : runs) zones += run.count;
  const std::size_t count = std::max<std::size_t>(1, zones / size);
  std::vector<std::span<const ZoneRun>> result;
  std::size_t begin = 0, done = 0;
  for (std::size_t end = 0; end < runs.size(); ++end) {
    done += runs[end].count;
    if (done * count < zones * (result.size() + 1)) continue;
    result.push_back(runs.subspan(begin, end + 1 - begin));
    begin = end + 1;
  }
  return result;
}

// `points` ascend.
void append(std::vector<IndexRange>& ranges, std::span<const std::uint32_t> points) {
  for (const auto point : points)
    if (!ranges.empty() && ranges.back().end == point)
      ++ranges.back().end;
    else
      ranges.push_back({point, point + 1});
}

void move(std::span<const IndexRange> ranges, double dt, const PointArrays& points) {
  for (const auto [begin, end] : ranges)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      points.ux[i] += dt * points.vx[i];
      points.uy[i] += dt * points.vy[i];
    }
}

void add_steady(std::span<const IndexRange> ranges, const PointArrays& points) {
  if (!points.steady_x) return;
  double *fx = points.fx, *fy = points.fy;
  for (const auto [begin, end] : ranges)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      fx[i] += points.steady_x[i];
      fy[i] += points.steady_y[i];
    }
}

void predict_damped(std::span<const IndexRange> ranges, double kick, const PointArrays& points) {
  double *fx = points.fx, *fy = points.fy;
  for (const auto [begin, end] : ranges)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      const double x = protocol::damped(fx[i], points.tie_x[i], points.vx[i], points.damping);
      const double y = protocol::damped(fy[i], points.tie_y[i], points.vy[i], points.damping);
      points.vx[i] += kick * (points.inverse_mass_x[i] * x);
      points.vy[i] += kick * (points.inverse_mass_y[i] * y);
      fx[i] = 0;
      fy[i] = 0;
    }
}

void predict(std::span<const IndexRange> ranges, double kick, const PointArrays& points) {
  if (points.damping > 0) return predict_damped(ranges, kick, points);
  double *fx = points.fx, *fy = points.fy;
  for (const auto [begin, end] : ranges)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      points.vx[i] += kick * (points.inverse_mass_x[i] * fx[i]);
      points.vy[i] += kick * (points.inverse_mass_y[i] * fy[i]);
      fx[i] = 0;
      fy[i] = 0;
    }
}

// to += from, from = 0
void pour(std::size_t count, double* from, double* to) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    to[i] += from[i];
    from[i] = 0;
  }
}

}  // namespace

std::size_t useful_threads(std::size_t zones) {
  return std::clamp<std::size_t>(zones / (2 * kLeastChunk), 1,
                                 std::max(1u, std::thread::hardware_concurrency()));
}

// For each point: the first and last chunk with a zone that pulls on it, and the last block seen to do so.
struct Sweep::Survey {
  std::vector<std::uint32_t> first, last, block;
  std::uint32_t blocks = 1;  // seen, and one

  bool shared(std::uint32_t point) const { return first[point] != last[point]; }
};

Sweep::Sweep(std::span<const ZoneRun> runs, std::span<const Role> roles, const std::vector<bool>& moved,
             std::size_t threads)
    : streamed_(roles.size() > kCached), buffers_(threads) {
  std::size_t longest = 0;
  for (const ZoneRun& run : runs) longest = std::max<std::size_t>(longest, run.count);
  runs_ = streamed_ ? cut(runs, kStreamed) : std::vector(runs.begin(), runs.end());
  const auto parts = pieces(runs_, std::max(kLeastChunk, kRows * longest));
  chunks_.resize(std::max<std::size_t>(1, parts.size()));

  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  Survey survey{std::vector(roles.size(), kNone), std::vector(roles.size(), kNone),
                std::vector(roles.size(), 0u)};
  for (std::uint32_t c = 0; c < parts.size(); ++c)
    for_each_corner(parts[c], [&](std::uint32_t point) {
      survey.first[point] = std::min(survey.first[point], c);
      survey.last[point] = c;
    });
  for (std::uint32_t c = 0; c < parts.size(); ++c) fill(c, parts[c], roles, moved, survey);

  std::vector<std::uint32_t> to_move, kept;  // without zones
  for (std::uint32_t point = 0; point < roles.size(); ++point) {
    if (survey.first[point] != kNone) continue;
    if (moved[point]) to_move.push_back(point);
    if (roles[point] == Role::kKept) kept.push_back(point);
  }
  append(chunks_[0].moved, to_move);
  append(chunks_[0].kept, kept);
}

void Sweep::fill(std::uint32_t number, std::span<const ZoneRun> runs, std::span<const Role> roles,
                 const std::vector<bool>& moved, Survey& survey) {
  struct Points {
    std::vector<std::uint32_t> moved, swept, left;
  };
  const auto parts = pieces(runs, streamed_ ? kStreamed : kBlock);
  const std::uint32_t before = survey.blocks;
  std::vector<Points> of_block(parts.size());
  std::vector<std::uint32_t> all;
  for (const auto part : parts) {
    for_each_corner(part, [&](std::uint32_t point) {
      if (survey.block[point] < before) {
        all.push_back(point);
        if (moved[point] && !survey.shared(point)) of_block[survey.blocks - before].moved.push_back(point);
      }
      survey.block[point] = survey.blocks;
    });
    ++survey.blocks;
  }
  std::ranges::sort(all);

  Chunk& chunk = chunks_[number];
  Points first;  // of several chunks, this one the first
  std::vector<std::uint32_t> kept;
  for (const auto point : all) {
    const bool is_first = survey.first[point] == number, swept = roles[point] == Role::kSwept;
    if (is_first && roles[point] == Role::kKept) kept.push_back(point);
    if (!survey.shared(point)) {
      auto& points = of_block[survey.block[point] - before];
      (swept ? points.swept : points.left).push_back(point);
      continue;
    }
    if (is_first && moved[point]) first.moved.push_back(point);
    if (is_first && swept) first.swept.push_back(point);
    share(number, survey.first[point], point);
  }
  append(chunk.moved, first.moved);
  append(chunk.swept, first.swept);
  append(chunk.kept, kept);
  for (std::size_t b = 0; b < parts.size(); ++b) {
    auto& points = of_block[b];
    std::ranges::sort(points.moved);
    Block& block = chunk.blocks.emplace_back();
    block.runs = parts[b];
    append(block.moved, points.moved);
    append(block.swept, points.swept);
    append(block.left, points.left);
  }
  chunk.first_point = all.front();
  for (Buffer& buffer : buffers_) buffer.hold(all.back() + 1 - all.front());
}

// A place where the forces of a chunk on a point wait to be summed by the first chunk that has it.
void Sweep::share(std::uint32_t chunk, std::uint32_t first, std::uint32_t point) {
  auto &shared = chunks_[chunk].shared, &sums = chunks_[first].sums;
  if (!shared.empty() && shared.back().points.end == point && !sums.empty() &&
      sums.back().place == shared.back().place) {
    shared.back().points.end = sums.back().points.end = point + 1;
  } else {
    shared.push_back({{point, point + 1}, waiting_.x.size()});
    sums.push_back(shared.back());
  }
  waiting_.hold(waiting_.x.size() + 1);
}

double Sweep::run(protocol::Team& team, ZoneSet& zones, const protocol::Step& step, const PointArrays& points,
                  Damping& damping) {
  damped_.resize(chunks_.size());
  team.run(chunks_.size(), [&](std::size_t c, std::size_t) { move(chunks_[c].moved, step.dt, points); });
  team.run(chunks_.size(), [&](std::size_t c, std::size_t thread) {
    damped_[c] = compute(chunks_[c], buffers_[thread], zones, step, points, damping);
  });
  team.run(chunks_.size(), [&](std::size_t c, std::size_t) {
    for (const auto& [range, place] : chunks_[c].sums) {
      pour(range.end - range.begin, &waiting_.x[place], points.fx + range.begin);
      pour(range.end - range.begin, &waiting_.y[place], points.fy + range.begin);
    }
    for (const IndexRanges* own : {&chunks_[c].swept, &chunks_[c].kept}) add_steady(*own, points);
    damped_[c] += damping.damp(chunks_[c].swept, step, points);
    fdm::predict(chunks_[c].swept, step.kick(), points);
  });
  return std::accumulate(damped_.begin(), damped_.end(), 0.0);
}

double Sweep::compute(const Chunk& chunk, Buffer& buffer, ZoneSet& zones, const protocol::Step& step,
                      const PointArrays& points, Damping& damping) {
  double *fx = buffer.x.data() - chunk.first_point, *fy = buffer.y.data() - chunk.first_point;
  PointArrays swept = points;  // their forces are in the buffer
  swept.fx = fx;
  swept.fy = fy;
  double damped = 0;
  for (std::size_t b = 0; b < chunk.blocks.size(); ++b) {
    const Block& block = chunk.blocks[b];
    if (streamed_ && b + kAhead < chunk.blocks.size()) {
      const Block& later = chunk.blocks[b + kAhead];
      protocol::prefetch(later.moved, {points.ux, points.uy, points.vx, points.vy});
      protocol::prefetch(later.swept, {points.inverse_mass_x, points.inverse_mass_y});
    }
    move(block.moved, step.dt, points);
    zones.add_forces(block.runs, step.dt, {points.vx, points.vy, fx, fy});
    add_steady(block.swept, swept);
    damped += damping.damp(block.swept, step, swept);
    fdm::predict(block.swept, step.kick(), swept);
    for (const auto [begin, end] : block.left) {
      pour(end - begin, fx + begin, points.fx + begin);
      pour(end - begin, fy + begin, points.fy + begin);
    }
  }
  for (const auto& [range, place] : chunk.shared) {
    pour(range.end - range.begin, fx + range.begin, &waiting_.x[place]);
    pour(range.end - range.begin, fy + range.begin, &waiting_.y[place]);
  }
  return damped;
}

void Sweep::predict(protocol::Team& team, double kick, const PointArrays& points) const {
  team.run(chunks_.size(), [&](std::size_t c, std::size_t) { fdm::predict(chunks_[c].kept, kick, points); });
}

}  // namespace adit::fdm
