// From the scene's foundations to the laws of their springs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocol/foundation/springs.hpp"
#include "protocol/messages/foundation.pb.h"

namespace adit::foundation {

struct DirectedLaw {
  Direction direction;
  SpringLaw law;
};

// The springs that a foundation has, in x and y. Throws UserError at `path` if it has none.
std::vector<DirectedLaw> read_laws(const scene::Foundation& foundation, const std::string& path);

// How its ground moves, by the table that was sent with the scene. Throws UserError at `path`.ground.path if
// it cannot be read, if its times or places do not ascend, or if the places of a time are others than those
// of the first.
std::shared_ptr<const GroundCourse> read_ground(const scene::Foundation& foundation, const std::string& path);

// The largest stiffness per area that foundations can have together in one direction [N/m^3].
template <class Foundations>
double largest_stiffness(const Foundations& foundations) {
  double x = 0, y = 0;
  for (const scene::Foundation& one : foundations) {
    x += one.x().stiffness();
    y += one.y().stiffness();
  }
  return x > y ? x : y;
}

}  // namespace adit::foundation
