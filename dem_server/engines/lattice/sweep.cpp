#include "dem_server/engines/lattice/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/particles/integrate.hpp"
#include "protocol/kernels/prefetch.hpp"

namespace adit::dem {
namespace {

using protocol::IndexRange;

// Particles of a block at least: worth a thread's call, and so many times the reach of a bond that little
// lies in seams.
constexpr std::uint32_t kLeastBlock = 4096, kReaches = 12;
constexpr std::uint32_t kBeat = 128;  // bonds
// Memory is asked for so many beats before it is needed, in models of more particles than caches hold.
constexpr std::size_t kAhead = 2, kCached = 1 << 17;

std::uint32_t low_of(const Run& run) {
  return std::min(run.first, run.second);
}

std::uint32_t end_of(const Run& run) {
  return std::max(run.first, run.second) + run.count;
}

// The ranges of the particles begin … end - 1 that pass the test.
template <class Test>
std::vector<IndexRange> chosen(std::uint32_t begin, std::uint32_t end, Test&& test) {
  std::vector<IndexRange> found;
  if (begin < end)
    protocol::for_each_range(
        end - begin, [&](std::uint32_t k) { return test(begin + k); },
        [&](const IndexRange& range, bool passed) {
          if (passed) found.push_back({begin + range.begin, begin + range.end});
        });
  return found;
}

// What a beat reads.
[[gnu::always_inline]] inline void prefetch(std::span<const IndexRange> moved,
                                            std::span<const IndexRange> swept, std::span<const Run> runs,
                                            const Assembly& assembly) {
  const Particles& p = assembly.particles;
  protocol::prefetch(moved, {p.ux.data(), p.uy.data(), p.vx.data(), p.vy.data(), p.spin.data()});
  protocol::prefetch(swept, {p.inverse_mass.data(), p.inverse_inertia.data()});
  for (const Run& run : runs)
    protocol::prefetch(std::span(assembly.bonds.shear_force).subspan(run.begin, run.count));
}

void pour(const IndexRange& range, std::uint32_t first, std::vector<double>& from, std::vector<double>& to) {
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    to[i] += from[i - first];
    from[i - first] = 0;
  }
}

void add_weight(std::span<const IndexRange> ranges, const Acceleration& gravity, Particles& p) {
  if (gravity.x == 0 && gravity.y == 0) return;
  for (const auto [begin, end] : ranges)
    for (std::uint32_t i = begin; i < end; ++i) {
      p.fx[i] += p.mass[i] * gravity.x;
      p.fy[i] += p.mass[i] * gravity.y;
    }
}

}  // namespace

Sweep::Sweep(std::span<const Run> runs, std::span<const Role> roles, const std::vector<bool>& moved,
             std::size_t threads)
    : buffers_(threads) {
  lay_out(runs, static_cast<std::uint32_t>(roles.size()));
  deal(runs);
  std::vector<bool> in_seam(roles.size(), false), in_beat = in_seam;
  const auto mark = [](const std::vector<Run>& some, std::vector<bool>& flags) {
    for (const Run& run : some)
      for (std::uint32_t k = 0; k < run.count; ++k) flags[run.first + k] = flags[run.second + k] = true;
  };
  for (const Block& block : blocks_) {
    mark(block.seam, in_seam);
    for (const Beat& beat : block.beats) mark(beat.runs, in_beat);
  }

  const auto at_once = [&](std::uint32_t i) { return roles[i] == Role::kSwept && !in_seam[i]; };
  std::uint32_t largest = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    const auto [begin, end] = block.particles;
    largest = std::max(largest, end - begin);
    for (Beat& beat : block.beats) {
      beat.moved = chosen(beat.moved[0].begin, beat.moved[0].end, [&](std::uint32_t i) { return moved[i]; });
      beat.swept = chosen(beat.swept[0].begin, beat.swept[0].end, at_once);
    }
    block.cleared = chosen(begin, end, [&](std::uint32_t i) { return moved[i] && !at_once(i); });
    block.left = chosen(begin, end, [&](std::uint32_t i) { return in_beat[i] && !at_once(i); });
    block.kept = chosen(begin, end, [&](std::uint32_t i) { return roles[i] == Role::kKept; });
    if (block.seam.empty()) continue;
    const std::uint32_t middle = end, last = blocks_[b + 1].particles.end;
    block.seam_swept = chosen(middle - (middle - begin) / 2, middle + (last - middle) / 2,
                              [&](std::uint32_t i) { return roles[i] == Role::kSwept && in_seam[i]; });
  }
  for (Buffer& buffer : buffers_)
    for (auto* resultant : {&buffer.fx, &buffer.fy, &buffer.moment}) resultant->assign(largest, 0.0);
  outcomes_.resize(2 * blocks_.size());
}

void Sweep::lay_out(std::span<const Run> runs, std::uint32_t particles) {
  std::uint32_t reach = 0, bonds = 0;
  for (const Run& run : runs) {
    reach = std::max(reach, end_of(run) - run.count - low_of(run));
    bonds += run.count;
  }
  const std::uint32_t size = std::max(kLeastBlock, kReaches * reach);
  // The bonds count, too: those of the interface are few among many particles, and a block is worth a
  // thread's call only if it has bonds enough.
  const std::uint32_t count = std::max(1u, std::min(particles, bonds) / size);
  for (std::uint64_t b = 0; b < count; ++b)
    blocks_.emplace_back().particles = {static_cast<std::uint32_t>(b * particles / count),
                                        static_cast<std::uint32_t>((b + 1) * particles / count)};
}

// Cuts the runs where a particle enters the next block.
void Sweep::deal(std::span<const Run> runs) {
  std::vector<std::vector<Run>> own(blocks_.size());
  const auto block_of = [&](std::uint32_t particle) {
    return static_cast<std::size_t>(
               std::ranges::upper_bound(blocks_, particle, {},
                                        [](const Block& b) { return b.particles.begin; }) -
               blocks_.begin()) -
           1;
  };
  for (Run rest : runs)
    while (rest.count > 0) {
      const std::size_t of_first = block_of(rest.first), of_second = block_of(rest.second);
      Run part = rest;
      part.count = std::min({rest.count, blocks_[of_first].particles.end - rest.first,
                             blocks_[of_second].particles.end - rest.second});
      (of_first == of_second ? own[of_first] : blocks_[std::min(of_first, of_second)].seam).push_back(part);
      for (auto* number : {&rest.begin, &rest.first, &rest.second}) *number += part.count;
      rest.count -= part.count;
    }
  for (std::size_t b = 0; b < blocks_.size(); ++b) set_beats(std::move(own[b]), blocks_[b]);
}

// Where the particles moved and swept by each beat begin and end.
void Sweep::set_beats(std::vector<Run> runs, Block& block) {
  // By the lower particle, so that particles complete in the order of memory.
  std::ranges::stable_sort(runs, {}, low_of);
  block.beats.emplace_back();
  std::uint32_t bonds = 0;
  for (const Run& run : runs) {
    if (bonds >= kBeat) {
      block.beats.emplace_back();
      bonds = 0;
    }
    block.beats.back().runs.push_back(run);
    bonds += run.count;
  }
  std::uint32_t moved = block.particles.begin, swept = moved;
  for (std::size_t b = 0; b < block.beats.size(); ++b) {
    const bool last = b + 1 == block.beats.size();
    Beat& beat = block.beats[b];
    std::uint32_t reached = last ? block.particles.end : moved;
    for (const Run& run : beat.runs) reached = std::max(reached, end_of(run));
    const std::uint32_t complete =
        last ? block.particles.end : std::clamp(low_of(block.beats[b + 1].runs.front()), swept, reached);
    beat.moved = {{moved, reached}};
    beat.swept = {{swept, complete}};
    moved = reached;
    swept = complete;
  }
}

double Sweep::run(protocol::Team& team, const ContactBond& law, const protocol::Step& step,
                  Assembly& assembly, BondResult& result, std::vector<std::uint32_t>& broken) {
  const std::size_t count = blocks_.size();
  for (Outcome& outcome : outcomes_) {
    outcome.contacts = {};
    outcome.fastest = 0;
    outcome.broken.clear();
  }
  team.run(count, [&](std::size_t b, std::size_t thread) {
    run_block(blocks_[b], buffers_[thread], law, step, assembly, outcomes_[b]);
  });
  if (count > 1)
    team.run(count - 1, [&](std::size_t b, std::size_t) {
      run_seam(blocks_[b], law, step, assembly, outcomes_[count + b]);
    });
  double fastest = 0;
  const auto old = static_cast<std::ptrdiff_t>(broken.size());
  for (const Outcome& outcome : outcomes_) {
    result.add(outcome.contacts);
    fastest = std::max(fastest, outcome.fastest);
    broken.insert(broken.end(), outcome.broken.begin(), outcome.broken.end());
  }
  // Blocks and seams list what broke in their own order; sorted, the list does not depend on it.
  std::sort(broken.begin() + old, broken.end());
  return std::sqrt(fastest);
}

void Sweep::run_block(const Block& block, Buffer& buffer, const ContactBond& law, const protocol::Step& step,
                      Assembly& assembly, Outcome& outcome) const {
  Particles& particles = assembly.particles;
  const std::uint32_t first = block.particles.begin;
  // Particles keep their numbers in the buffer of a block, which holds the resultants from `first` on only.
  const Resultants resultants{buffer.fx.data() - first, buffer.fy.data() - first,
                              buffer.moment.data() - first};
  clear(block.cleared, resultants_of(particles));
  const bool ahead = particles.size() > kCached;
  for (std::size_t b = 0; b < block.beats.size(); ++b) {
    const Beat& beat = block.beats[b];
    if (ahead && b + kAhead < block.beats.size()) {
      const Beat& later = block.beats[b + kAhead];
      prefetch(later.moved, later.swept, later.runs, assembly);
    }
    if (!step.from_rest()) outcome.fastest = std::max(outcome.fastest, move(step.dt, beat.moved, particles));
    add_bond_forces(law, step.dt, beat.runs, particles, assembly.bonds, resultants, outcome.contacts,
                    outcome.broken);
    kick(step, beat.swept, resultants, particles, assembly.gravity);
    // The buffer serves the next block of this thread, so it is left as zero as it was found.
    clear(beat.swept, resultants);
  }
  for (const IndexRange& range : block.left) {
    pour(range, first, buffer.fx, particles.fx);
    pour(range, first, buffer.fy, particles.fy);
    pour(range, first, buffer.moment, particles.moment);
  }
  add_weight(block.kept, assembly.gravity, particles);
}

void Sweep::run_seam(const Block& block, const ContactBond& law, const protocol::Step& step,
                     Assembly& assembly, Outcome& outcome) const {
  Particles& particles = assembly.particles;
  const Resultants resultants = resultants_of(particles);
  add_bond_forces(law, step.dt, block.seam, particles, assembly.bonds, resultants, outcome.contacts,
                  outcome.broken);
  kick(step, block.seam_swept, resultants, particles, assembly.gravity);
}

void Sweep::predict(protocol::Team& team, const protocol::Step& step, Particles& particles) const {
  team.run(blocks_.size(), [&](std::size_t b, std::size_t) {
    dem::kick(step, blocks_[b].kept, resultants_of(particles), particles);
  });
}

}  // namespace adit::dem
