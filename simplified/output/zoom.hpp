// From global to local: the places where the tunnel suffers most, and what a model of their surroundings
// needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/output/response.hpp"

namespace adit::simplified {

struct Place {
  std::string name;  // "opening", "moment", "shear", "strain"
  std::string unit;  // of the value
  double chainage;   // [m]
  double value;      // the largest magnitude
};

// Of the largest joint opening, lateral moment, lateral shear and strain; without those that the response
// lacks.
std::vector<Place> largest_responses(const Response& response);

// A window around a place and the tunnel's velocity at its two edges.
struct Window {
  double begin, end;  // [m]
  std::vector<double> time;
  std::vector<double> begin_axial, begin_lateral, end_axial, end_lateral;  // [m/s]
};

// `width` around the chainage, moved inside the tunnel where it would stand out; its edges are the nearest
// places of the fields, so that no joint lies between an edge and what is known of it. Throws UserError at
// "simplified.zoom.width" where it is wider than the tunnel.
Window window(const Fields& fields, double chainage, double width);

// The edges' motion as a scene of the coupled model, in plan: x the chainage, y to the left, the tunnel's
// axis at y = 0. The user adds material and models (`base: <this file>`).
scene::Scene fragment(const Window& window, double duration);

// Writes `<name>.csv` and `<name>.yaml` of each place into `directory`, which is created.
void write_zoom(const std::filesystem::path& directory, const Response& response, const scene::Zoom& zoom,
                double duration);

}  // namespace adit::simplified
