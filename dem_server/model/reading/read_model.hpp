// A scene's particles as a model of discs.
//
// Mass: density times the area of solid that a disc stands for: its cell, 2 sqrt(3) R^2 in hexagonal and 4
// R^2 in square packing; in random packing the box, shared in proportion to the discs' own areas; its own
// area where it is placed. Moment of inertia: m R^2 / 2.
//
// Bonds: where neither `bonds` nor `contacts` are given, unbreakable ones calibrated from the material; with
// `contacts` alone, none. Stiffnesses that are left out are those of the hexagonal lattice of the material
// (calibration.hpp), whatever the packing.
#pragma once

#include "dem_server/model/model.hpp"
#include "protocol/log/progress.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// UserError for whatever cannot be computed. `progress` hears how far a random packing is, whose growth the
// threads share (0: as many as pay); the model does not depend on their number.
Model read_model(
    const scene::Scene& scene, const protocol::Progress& progress = [](const std::string&) {},
    std::size_t threads = 1);

}  // namespace adit::dem
