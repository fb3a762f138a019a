// What a step leaves behind: the hinges' deformations and forces, and the envelopes.
#pragma once

#include "simplified/chain/envelopes.hpp"
#include "simplified/chain/joints/curved_hinges.hpp"
#include "simplified/chain/joints/joint_forces.hpp"

namespace adit::simplified::chain {

struct Results {
  explicit Results(std::size_t bodies);
  Components deformation, force;  // n + 1 hinges, in their own axes
  Envelopes envelopes;

  // Envelopes of this state alone.
  void start(const Model& model, const CurvedHinges& curved, const Tracks& tracks);
  // Results of the bodies first … last - 1 and of the hinges after them, and of the hinge before the first
  // body of all.
  void take(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t first,
            std::size_t last);

 private:
  void set(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t begin,
           std::size_t end);
};

}  // namespace adit::simplified::chain
