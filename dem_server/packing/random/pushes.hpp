// Loops of the relaxation of pressed discs (pressed_discs.hpp), in vector code, over some of the discs or
// pairs. Lengths are the discs', kn is 1, and so a push is the overlap.
#pragma once

#include <cstdint>
#include <span>

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

// A place, a velocity or a force: both components lie together, because a pair wants both.
struct Vector {
  double x, y;
};

// Of contacts that push: the sum of the pushes and the number.
struct Pushes {
  double sum = 0, count = 0;
  void add(const Pushes& others) {
    sum += others.sum;
    count += others.count;
  }
};

// How far a disc sticks out of each wall.
struct Overlaps {
  double left, right, below, above;
  double sum() const { return left + right + below + above; }
  std::uint32_t count() const { return (left > 0) + (right > 0) + (below > 0) + (above > 0); }
};
Overlaps overlaps_of(const Vector& place, double radius, const geometry::BoundingBox& box);

// Adds the forces of pairs, which touch at the distances `touch`, to the forces on their discs.
Pushes push_each_other(std::span<const Pair> pairs, const double* touch, const Vector* place, Vector* force);

// Sums over discs: power of the forces, squares of velocities and of forces, sizes of forces.
struct Descent {
  double power = 0, speed = 0, force = 0, unbalanced = 0;
  void add(const Descent& others) {
    power += others.power;
    speed += others.speed;
    force += others.force;
    unbalanced += others.unbalanced;
  }
};
Descent descent_of(std::span<const Vector> force, std::span<const Vector> velocity);

// Velocities become `keep` v + (`turn` + `dt`) f and move the discs (semi-implicit Euler, which stays stable
// where the explicit rule gains energy). Returns the square of the longest way from `listed`.
struct Motion {
  double keep, turn, dt;
};
double move(const Motion& motion, std::span<const Vector> force, std::span<const Vector> listed,
            std::span<Vector> velocity, std::span<Vector> place);

}  // namespace adit::dem
