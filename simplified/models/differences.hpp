// Rates of recorded values.
#pragma once

#include <vector>

namespace adit::simplified {

// Time derivatives of a table with a row of `places` values for each of the equally spaced times. They are
// central differences of fourth order, of second order next to the ends, and one-sided in the first and the
// last row.
std::vector<double> rates(const std::vector<double>& table, const std::vector<double>& time,
                          std::size_t places);

}  // namespace adit::simplified
