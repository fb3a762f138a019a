// The results of a step: deformations and forces of the hinges, and the envelopes.
#pragma once

#include "simplified/chain/envelopes.hpp"
#include "simplified/chain/joints/curved_hinges.hpp"
#include "simplified/chain/joints/joint_forces.hpp"

namespace adit::simplified::chain {

struct Results {
  explicit Results(std::size_t bodies);
  Components deformation, force;  // n + 1 hinges, in their own axes
  Envelopes envelopes;

  // Sets the envelopes to this state alone.
  void start(const Model& model, const CurvedHinges& curved, const Tracks& tracks);
  // Takes the results of the bodies first … last - 1 and of the hinges after them. With the first body of the
  // chain, it also takes those of the hinge before it.
  void take(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t first,
            std::size_t last);

 private:
  void set(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t begin,
           std::size_t end);
};

}  // namespace adit::simplified::chain
