// Cells and their cracks as pieces of a snapshot (wire.proto); none where particles are discs.
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

}  // namespace adit::dem
