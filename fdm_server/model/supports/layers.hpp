// Linings that lie on others, such as concrete on shotcrete: along the same path or a part of it, on its
// left.
//
// A layer without interface is bonded: it has the points and rotations of the one below, and its axis lies
// beside the path by half of both thicknesses, so that both bend as one section. With an interface it has
// points of its own, and contacts join them to those below; shear between the layers then acts at their axes.
#pragma once

#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

using SceneLinings = google::protobuf::RepeatedPtrField<scene::Lining>;

// Of each lining the number of the one that it lies on; -1: none. UserError at `continuum.linings[i].on`
// where no such lining is there in time.
std::vector<int> read_layers(const SceneLinings& linings);

// The numbers of linings, with each after the one that it lies on.
std::vector<std::size_t> from_the_ground(const std::vector<int>& below);

// A path of grid points by the points of the lining below. UserError at `path` where it leaves that.
Path on_points_of(const LiningPlan& below, const Path& wanted, const Grid& grid, const std::string& path);

// From the axis of one lining to that of the layer on it [m]. UserError at `path` where a thickness is open.
double between_axes(const scene::Lining& below, const scene::Lining& layer, const std::string& path);

}  // namespace adit::fdm
