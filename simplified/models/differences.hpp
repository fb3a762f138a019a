// Rates of recorded values.
#pragma once

#include <vector>

namespace adit::simplified {

// Time derivatives of a table, a row of `places` values a time, at equal distances in time: central
// differences of fourth order, of second next to the ends; the first and last row are the differences to
// their neighbours.
std::vector<double> rates(const std::vector<double>& table, const std::vector<double>& time,
                          std::size_t places);

}  // namespace adit::simplified
