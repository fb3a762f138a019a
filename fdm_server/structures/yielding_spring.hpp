// A spring that yields: a joint's moment over its rotation, a bolt's force over its elongation.
//
//   F(n+1) = F(n) + k d, held within +-F_y.
// What the spring takes up in a step is d (F(n) + F(n+1))/2, the form in which the ledger books work
// (continuum.hpp). Of it (F(n+1)^2 - F(n)^2)/2k is stored; the rest, (d - (F(n+1) - F(n))/k) times the mean
// force, is dissipated.
#pragma once

#include <algorithm>

#include "protocol/state/archive.hpp"

namespace adit::fdm {

class YieldingSpring {
 public:
  YieldingSpring(double stiffness, double yield) : stiffness_(stiffness), yield_(yield) {}

  // Returns what a further elongation d dissipates [J].
  double strain(double d) {
    const double before = force_, trial = force_ + stiffness_ * d;
    force_ = std::clamp(trial, -yield_, yield_);
    return trial == force_ ? 0 : (trial - force_) / stiffness_ * (before + force_) / 2;
  }

  double force() const { return force_; }
  double stiffness() const { return stiffness_; }
  double strain_energy() const { return force_ * force_ / stiffness_ / 2; }

  void exchange(state::Archive& archive) { archive("yielding_spring", force_); }

 private:
  double stiffness_, yield_, force_ = 0;
};

}  // namespace adit::fdm
