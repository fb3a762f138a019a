// The hexagonal lattice: equal discs that touch, all joined by contact bonds of one law along three
// directions. Rows may differ by factors of the law.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Direction of a bond at rest, from its first to its second disc.
enum class Direction : std::uint8_t { kAlongRow, kUpRight, kUpLeft };

// From the first to the second of two touching discs [m].
std::array<double, 2> rest_vector(Direction direction, double radius);

// No value for a bond that follows none of the three, or is longer or shorter than two radii by more than a
// millionth.
std::optional<Direction> direction_of(const Model& model, const Bond& bond);

// Orders the bonds of discs that are numbered row by row: by row, then by direction, then from left to right,
// so that bonds which follow one another are parallel and join discs that follow one another.
void sort_by_rows(Model& model);

// In what the discs and bonds are no hexagonal lattice, as in "the particles differ in size"; no value for
// one.
std::optional<std::string> why_no_lattice(const Model& model);

// The same, and what beside bonds and contacts without friction acts on the particles: "there are walls".
std::optional<std::string> why_more_than_lattice(const Model& model);

}  // namespace adit::dem
