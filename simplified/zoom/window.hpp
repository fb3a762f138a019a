// The tunnel around a place, moved at both edges as the whole tunnel moves there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/output/response.hpp"

namespace adit::simplified {

// The motion of the section at an edge, over the times of the fields.
struct Edge {
  double chainage;                           // [m]
  std::vector<double> axial, lateral, spin;  // [m/s], [m/s], [rad/s] counter-clockwise from above
};

struct Window {
  std::vector<double> time;
  Edge begin, end;
};

// The window of this width around the chainage, moved into the tunnel if it would reach beyond a portal. Its
// edges are the nearest places of the fields, so that no joint lies between an edge and the place whose
// motion it has. Throws UserError at "simplified.zoom.width" if the window is wider than the tunnel.
Window window(const Fields& fields, double chainage, double width);

// The edges' motion as a scene of the coupled model, in plan: x the chainage, y to the left, the tunnel's
// axis at y = 0. Both edges move and turn as rigid sections, by the tables that write_edges() writes for this
// name. The user adds material and models (`extends: <this file>`).
scene::Scene fragment(const Window& window, const std::string& name, double duration);

// Writes `<name>_begin.csv` and `<name>_end.csv`.
void write_edges(const std::filesystem::path& directory, const std::string& name, const Window& window);

}  // namespace adit::simplified
