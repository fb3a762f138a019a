#include "simplified/models/differences.hpp"

namespace adit::simplified {

std::vector<double> rates(const std::vector<double>& table, const std::vector<double>& time,
                          std::size_t places) {
  std::vector<double> rates(table.size());
  const std::size_t rows = time.size();
  if (rows < 2) return rates;
  const double dt = time[1] - time[0];
  for (std::size_t n = 0; n < rows; ++n)
    for (std::size_t i = 0; i < places; ++i) {
      const auto at = [&](std::size_t row) { return table[row * places + i]; };
      double& rate = rates[n * places + i];
      if (n == 0)
        rate = (at(1) - at(0)) / dt;
      else if (n + 1 == rows)
        rate = (at(n) - at(n - 1)) / dt;
      else if (n == 1 || n + 2 == rows)
        rate = (at(n + 1) - at(n - 1)) / (2 * dt);
      else
        rate = (8 * (at(n + 1) - at(n - 1)) - (at(n + 2) - at(n - 2))) / (12 * dt);
    }
  return rates;
}

}  // namespace adit::simplified
