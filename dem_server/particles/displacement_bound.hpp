// How far particles may have moved since a list of neighbours was made: a bound that grows by dt max |v| at
// no cost, and is replaced by what it bounds only where a list wants to know.
#pragma once

#include <vector>

#include "dem_server/packing/discs.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class DisplacementBound {
 public:
  // Counts from the places where the particles are now; they are returned, as discs of these radii.
  Discs start(const Particles& particles, std::vector<double> radius);
  // Every particle moved by at most this since the last call [m].
  void add(double most) { most_ += most; }
  // The bound becomes the way of the particle that is the farthest.
  void measure(const Particles& particles);
  double most() const { return most_; }  // [m]
  void exchange(state::Archive& archive) {
    archive("listed_ux", std::span(ux_));
    archive("listed_uy", std::span(uy_));
    archive("moved", most_);
  }

 private:
  std::vector<double> ux_, uy_;  // displacements at the start
  double most_ = 0;
};

}  // namespace adit::dem
