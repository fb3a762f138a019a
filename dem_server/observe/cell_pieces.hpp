// Cells, their cracks, and bars as pieces of a snapshot (wire.proto); of discs only the bars.
#pragma once

#include "dem_server/observe/observable.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

// Piece "cells": a polygon for each particle that is there, in their order, over its corners at rest;
// displacement_m of the corners, and what colours polygons of the piece "particles", which must be there:
// group, stress_Pa, fragment.
void add_cells(const Observable& observed, wire::Snapshot& snapshot);

// Piece "cracks", where there are any: lines over their own two ends at rest, displacement_m as the mean of
// both cells; state (1 tensile, 2 shear), opening_m, slip_m, path (from 1, the longest first,
// 0: none; crack_paths.hpp), debonded (1: between two groups, else 0).
void add_cracks(const Observable& observed, wire::Snapshot& snapshot);

// Piece "bars", where there are any: an element each between its ends at rest, displacement_m as for cracks
// of its particle; bar (its number in the scene), stress_Pa, strain, force_N, dowel_force_N, slip_m (mean of
// both ends).
void add_bars(const Observable& observed, wire::Snapshot& snapshot);

}  // namespace adit::dem
