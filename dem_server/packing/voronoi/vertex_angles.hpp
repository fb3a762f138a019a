// The nuclei about a vertex, a point from which faces leave along rays.
//
// If all nuclei around the vertex have the same distance from it and lie in pairs, each pair mirrored about a
// ray, the vertex is a corner of cells, and a facet lies on each ray. A sector between two rays has two
// nuclei, or one, which belongs to the pairs of both rays.
//
// Sectors are given by their angles, which sum to two pi: sector k lies between rays k and k + 1, the last
// one between the last ray and the first. All angles are in radians.
#pragma once

#include <vector>

namespace adit::dem {

// The sectors that have one nucleus: those of less than 1.4 times the narrowest and less than 150 degrees; or
// none, where this leaves the nuclei farther apart.
std::vector<bool> sectors_with_one_nucleus(const std::vector<double>& sectors);

// The angle between each ray and the nuclei of its pair. In a sector with one nucleus, those of its two rays
// sum to the sector. If all sectors of an even number have one, this leaves a rest in the last unless they
// alternate to zero.
std::vector<double> angles_beside_rays(const std::vector<double>& sectors, const std::vector<bool>& with_one);

// The least angle between two nuclei that follow each other around the vertex; negative if they overlap.
double least_between_nuclei(const std::vector<double>& sectors, const std::vector<double>& beside);

}  // namespace adit::dem
