// The tunnel around a place, moved at both edges as the whole tunnel moves there.
#pragma once

#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/output/response.hpp"

namespace adit::simplified {

// A window around a place and the tunnel's velocity at its two edges.
struct Window {
  double begin, end;  // [m]
  std::vector<double> time;
  std::vector<double> begin_axial, begin_lateral, end_axial, end_lateral;  // [m/s]
};

// The window of this width around the chainage, moved into the tunnel if it would reach beyond a portal. Its
// edges are the nearest places of the fields, so that no joint lies between an edge and the place whose
// motion it has. Throws UserError at "simplified.zoom.width" if the window is wider than the tunnel.
Window window(const Fields& fields, double chainage, double width);

// The edges' motion as a scene of the coupled model, in plan: x the chainage, y to the left, the tunnel's
// axis at y = 0. The user adds material and models (`extends: <this file>`).
scene::Scene fragment(const Window& window, double duration);

}  // namespace adit::simplified
