// An interface of the model: where two participants overlap, how they share the energy there, and at which
// points their velocities are tied.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coupler/bridging/overlap.hpp"
#include "coupler/participants/members.hpp"
#include "coupler/participants/participant.hpp"

namespace adit::coupler {

BoundingBox bounds(const wire::Model& model);

struct Interface {
  std::string path;          // in the scene
  std::size_t outer, inner;  // participants
  Overlap overlap;
  scene::Interface given;
  // Each coupling point is a point of the fine side; the coarse side interpolates.
  std::size_t coarse = 0, fine = 0;
  std::size_t begin = 0, end = 0;  // its share of the model's coupling points

  explicit Interface(const Join& join)
      : path(join.path),
        outer(join.outer),
        inner(join.inner),
        overlap(*join.interface, join.path),
        given(*join.interface) {}
};

// Weight of participant `s` at points x0 y0 x1 y1 …: the product of its weights in all its interfaces.
std::vector<double> weights_of(std::size_t s, const std::vector<Participant>& participants,
                               const std::vector<Interface>& interfaces, std::span<const double> points);

// Throws protocol::UserError where the overlaps of two interfaces meet: at every sample point of a
// participant that exists there, the weights of all participants must sum to 1.
void require_one_owner(const std::vector<Participant>& participants,
                       const std::vector<Interface>& interfaces);

// A box around the overlaps of the participant, inside its own model.
BoundingBox overlap_bounds(std::size_t participant, const std::vector<Participant>& participants,
                           const std::vector<Interface>& interfaces);

// Chooses the fine side of every interface, the particles or else the participant with more candidates, and
// makes its candidates inside the overlap the coupling points, which are returned, x0 y0 x1 y1 … Throws
// protocol::UserError for an overlap without any, and for a point that two interfaces would tie.
std::vector<double> choose_coupling_points(const std::vector<Participant>& participants,
                                           std::vector<Interface>& interfaces);

}  // namespace adit::coupler
