// Discs from a file of the user's: a table (CSV) or points (VTP).
#pragma once

#include <optional>
#include <string>

#include "dem_server/packing/discs.hpp"

namespace adit::dem {

struct PlacedDiscs {
  Discs discs;
  std::vector<std::uint32_t> number;  // of each disc's group; empty where the file has none
  // Half a unit of the last digit that the file holds [m].
  double x_rounding = 0, y_rounding = 0, radius_rounding = 0;
};

// Why a disc cannot be computed, in words that go on from its row; none where it can.
std::optional<std::string> wrong_with_disc(double x, double y, double radius);

// Columns `x_m`, `y_m`, `radius_m` and perhaps `group` in any order, named by the first line. UserError at
// `path` names the line.
PlacedDiscs read_csv(const std::string& content, const std::string& path);

// Poly data whose points have a field `radius_m` and perhaps `group`: as text, or as base64 without
// compression, which is how results are written. UserError at `path`.
PlacedDiscs read_vtp(const std::string& content, const std::string& path);

}  // namespace adit::dem
