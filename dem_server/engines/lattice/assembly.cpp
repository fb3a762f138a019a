#include "dem_server/engines/lattice/assembly.hpp"

#include <algorithm>
#include <atomic>

#include "dem_server/model/lattice.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {
namespace {

constexpr std::uint32_t kWord = 64;  // bits

// `next` is the run of the next bond alone.
void append_to_runs(std::vector<Run>& runs, const Run& next) {
  if (!runs.empty()) {
    Run& last = runs.back();
    if (last.count < kLongestRun && next.first == last.first + last.count &&
        next.second == last.second + last.count &&
        // Exact equality serves, because rest vectors come from a table of three directions and not from
        // places.
        next.rest_x == last.rest_x && next.rest_y == last.rest_y && next.factors == last.factors) {
      ++last.count;
      return;
    }
  }
  runs.push_back(next);
}

// Only where some bond bears a force at rest.
void set_initial_forces(const Model& model, Bonds& b) {
  if (std::ranges::all_of(model.bonds, [](const Bond& bond) { return bond.at_rest == PairForces{}; })) return;
  for (std::uint32_t k = 0; k < b.size(); ++k) {
    b.initial_normal_force.push_back(model.bonds[k].at_rest.normal);
    b.shear_force[k] = model.bonds[k].at_rest.shear;
  }
}

Bonds bonds_of(const Model& model) {
  Bonds b;
  const double radius = model.discs.radius.front();
  b.rest_length = 2 * radius;
  for (const Bond& bond : model.bonds) {
    const auto [rest_x, rest_y] = rest_vector(direction_of(model, bond).value(), radius);
    append_to_runs(b.runs, {static_cast<std::uint32_t>(b.size()), 1, bond.first, bond.second, rest_x, rest_y,
                            model.contact_bonds[bond.number].factors});
    b.first.push_back(bond.first);
    b.second.push_back(bond.second);
  }
  b.finish();
  for (std::uint32_t k = 0; k < b.size(); ++k) b.set_weight(k, model.bonds[k].weight);
  set_initial_forces(model, b);
  return b;
}

}  // namespace

void Bonds::finish() {
  weight.assign(size(), 1.0);
  intact.assign(size(), 1.0);
  normal_force.assign(size(), 0.0);
  shear_force.assign(size(), 0.0);
  state.assign(size(), BondState::kIntact);
  marked_.assign(size() / kWord + 1, 0);
}

bool Bonds::plain(const Run& run) const {
  const std::uint32_t end = run.begin + run.count;
  for (std::uint32_t bond = run.begin; bond < end;) {
    const std::uint32_t next = std::min(end, (bond / kWord + 1) * kWord);
    const std::uint64_t of_run = ~std::uint64_t{0} >> (kWord - (next - bond)) << bond % kWord;
    // Another thread may mark bonds of its own runs in this word while it is read.
    if (std::atomic_ref(marked_[bond / kWord]).load(std::memory_order_relaxed) & of_run) return false;
    bond = next;
  }
  return true;
}

void Bonds::mark(std::uint32_t bond) {
  std::atomic_ref(marked_[bond / kWord])
      .fetch_or(std::uint64_t{1} << bond % kWord, std::memory_order_relaxed);
}

void Bonds::set_weight(std::uint32_t bond, double value) {
  weight[bond] = value;
  if (value != 1) mark(bond);
}

void Bonds::break_bond(std::uint32_t bond, BondState to) {
  state[bond] = to;
  intact[bond] = 0;
  shear_force[bond] = 0;
  mark(bond);
}

void Bonds::exchange(state::Archive& archive) {
  std::vector<BondState> states = state;
  archive("bond_state", std::span(states));
  if (archive.reads())
    for (std::uint32_t k = 0; k < size(); ++k)
      if (states[k] != BondState::kIntact) break_bond(k, states[k]);
  archive("bond_shear", std::span(shear_force));
}

SplitRuns split(std::span<const Run> runs, const std::vector<bool>& chosen) {
  SplitRuns parts;
  for (const Run& run : runs)
    protocol::for_each_range(
        run.count, [&](std::uint32_t k) { return chosen[run.first + k] || chosen[run.second + k]; },
        [&](const protocol::IndexRange& range, bool touches) {
          Run part = run;
          part.count = range.end - range.begin;
          for (auto* number : {&part.begin, &part.first, &part.second}) *number += range.begin;
          (touches ? parts.touching : parts.others).push_back(part);
        });
  return parts;
}

Assembly assemble(const Model& model) {
  return {at_rest(model), bonds_of(model)};
}

}  // namespace adit::dem
