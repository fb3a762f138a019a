#include "dem_server/engines/general/bars/bar_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace adit::dem {
namespace {

constexpr int kRounds = 60, kTangentRounds = 30;
constexpr double kBalanced = 1e-13;       // unbalanced force over the largest
constexpr double kLeastStiffness = 1e-6;  // of what yields or slides, over the elastic one

}  // namespace

BarChain::BarChain(const Bar& bar)
    : bar_(bar),
      slip_(bar.nodes.size()),
      strain_(bar.elements()),
      steel_(bar.elements()),
      bond_(bar.nodes.size()),
      whole_(bar.elements(), true),
      bonded_(bar.nodes.size(), true),
      bond_law_(bar.nodes.size()),
      next_slip_(slip_),
      next_strain_(strain_),
      unbalanced_(slip_),
      next_steel_(steel_),
      next_bond_(bond_) {
  for (std::size_t k = 0; k < bar.elements(); ++k) {
    const BarNode &a = bar.nodes[k], &b = bar.nodes[bar.after(k)];
    length_.push_back(std::hypot(b.x - a.x, b.y - a.y));
  }
  for (std::size_t k = 0; k < bar.nodes.size(); ++k) bond_law_[k] = bar.nodes[k].bond;
  system_.diagonal.resize(bar.nodes.size());
  system_.off.resize(bar.elements());
}

double BarChain::find(std::span<const double> growths, bool elastic) {
  double largest = 0;
  for (std::size_t k = 0; k < slip_.size(); ++k) {
    const BarNode& node = bar_.nodes[k];
    const double bonds = bonded_[k] ? bar_.perimeter() * node.length : 0;
    const auto [state, stiffness] = slip_to(bond_law_[k], next_slip_[k], bond_[k]);
    next_bond_[k] = state;
    unbalanced_[k] = bonds * next_bond_[k].stress;
    // A node that nothing holds stays where it is.
    system_.diagonal[k] =
        (bonded_[k] ? bonds : 1) *
        (elastic ? node.bond.stiffness : std::max(stiffness, kLeastStiffness * node.bond.stiffness));
    largest = std::max(largest, std::abs(unbalanced_[k]));
  }
  for (std::size_t k = 0; k < strain_.size(); ++k) {
    system_.off[k] = 0;
    if (!whole_[k]) continue;
    const std::size_t after = bar_.after(k);
    next_strain_[k] = (growths[k] + next_slip_[after] - next_slip_[k]) / length_[k];
    next_steel_[k] = steel_[k];
    const double slope = strain_to(bar_.steel, next_strain_[k], next_steel_[k]);
    const double modulus =
        elastic ? bar_.steel.modulus : std::max(slope, kLeastStiffness * bar_.steel.modulus);
    const double stiffness = modulus * bar_.area / length_[k];
    const double force = bar_.area * next_steel_[k].stress;
    unbalanced_[k] -= force;
    unbalanced_[after] += force;
    system_.diagonal[k] += stiffness;
    system_.diagonal[after] += stiffness;
    system_.off[k] = -stiffness;
    largest = std::max(largest, std::abs(force));
  }
  double worst = 0;
  for (const double force : unbalanced_) worst = std::max(worst, std::abs(force));
  return largest > 0 ? worst / largest : 0;
}

void BarChain::stretch(std::span<const double> growths) {
  weaken();
  break_steel();
  next_slip_ = slip_;
  double unbalanced = find(growths, false);
  for (int round = 0; round < kRounds && unbalanced > kBalanced; ++round)
    unbalanced = approach(growths, round >= kTangentRounds);
  take();
}

// One round: along the direction of Newton, or less far where the energy would rise again there: to where it
// rises or falls by less than half as steeply as at first.
double BarChain::approach(std::span<const double> growths, bool elastic) {
  constexpr int kTries = 40;
  way_ = unbalanced_;
  system_.solve(way_);
  from_ = next_slip_;
  const auto slope = [&] { return std::inner_product(way_.begin(), way_.end(), unbalanced_.begin(), 0.0); };
  const double first = slope();
  double falls = 0, steepness = first, rises = 0, share = 1;  // brackets, once it rises
  for (int tries = 0;; ++tries) {
    for (std::size_t k = 0; k < from_.size(); ++k) next_slip_[k] = from_[k] - share * way_[k];
    const double unbalanced = find(growths, elastic), now = slope();
    if (tries == kTries || std::abs(now) <= first / 2 || (now > 0 && rises == 0)) return unbalanced;
    if (now > 0) {
      falls = share;
      steepness = now;
      share = (falls + rises) / 2;
    } else {
      rises = share;
      share = falls + (rises - falls) * std::clamp(steepness / (steepness - now), 0.1, 0.9);
    }
  }
}

// Bonds beside elements that yielded before this step.
void BarChain::weaken() {
  const double yield = bar_.steel.yield / bar_.steel.modulus;
  std::vector<double>& beyond = unbalanced_;
  std::ranges::fill(beyond, 0.0);
  for (std::size_t k = 0; k < strain_.size(); ++k) {
    const double share = (std::abs(strain_[k]) - yield) / (bar_.limit_strain - yield);
    for (const std::size_t node : {k, bar_.after(k)}) beyond[node] = std::max(beyond[node], share);
  }
  for (std::size_t k = 0; k < slip_.size(); ++k)
    bond_law_[k].strength = bar_.nodes[k].bond.strength * (beyond[k] > 0 ? bond_after_yield(beyond[k]) : 1);
}

// Elements that were strained too far before this step.
void BarChain::break_steel() {
  for (std::size_t k = 0; k < strain_.size(); ++k)
    if (whole_[k]) break_beyond(bar_.steel, strain_[k], steel_[k]);
}

// Losses are the trapezoids of the ledger, less what is stored.
void BarChain::take() {
  for (std::size_t k = 0; k < strain_.size(); ++k) {
    if (!whole_[k]) continue;
    const double work = (steel_[k].stress + next_steel_[k].stress) / 2 * (next_strain_[k] - strain_[k]);
    yielded_ +=
        bar_.area * length_[k] *
        (work - (protocol::stored(bar_.steel, next_steel_[k]) - protocol::stored(bar_.steel, steel_[k])));
  }
  for (std::size_t k = 0; k < slip_.size(); ++k)
    if (bonded_[k])
      slipped_ += bar_.perimeter() * bar_.nodes[k].length * (bond_[k].stress + next_bond_[k].stress) / 2 *
                  (next_bond_[k].plastic - bond_[k].plastic);
  slip_ = next_slip_;
  strain_ = next_strain_;
  steel_ = next_steel_;
  bond_ = next_bond_;
}

double BarChain::stored() const {
  double sum = 0;
  for (std::size_t k = 0; k < strain_.size(); ++k)
    if (whole_[k]) sum += bar_.area * length_[k] * protocol::stored(bar_.steel, steel_[k]);
  for (std::size_t k = 0; k < slip_.size(); ++k)
    if (bonded_[k])
      sum += bar_.perimeter() * bar_.nodes[k].length * bond_[k].stress * bond_[k].stress /
             (2 * bar_.nodes[k].bond.stiffness);
  return sum;
}

void BarChain::cut(std::size_t element) {
  whole_[element] = false;
  steel_[element] = next_steel_[element] = {};
  strain_[element] = next_strain_[element] = 0;
}

void BarChain::loosen(std::size_t node) {
  bonded_[node] = false;
  bond_[node] = next_bond_[node] = {};
}

}  // namespace adit::dem
