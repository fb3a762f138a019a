// The places of the whole tunnel that are worth a closer look.
#pragma once

#include <string>
#include <vector>

#include "simplified/output/response.hpp"

namespace adit::simplified {

struct Place {
  std::string name;  // "opening", "moment", "shear", "strain"
  std::string unit;  // unit of the value
  double chainage;   // [m]
  double value;      // the largest magnitude
};

// The places of the largest joint opening, lateral moment, lateral shear and strain, as far as the response
// has these.
std::vector<Place> largest_responses(const Response& response);

}  // namespace adit::simplified
