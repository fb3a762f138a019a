#include "protocol/foundation/bracket.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/errors.hpp"

namespace adit::foundation {

Bracket bracket(std::span<const double> ascending, double value) {
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(ascending, value) - ascending.begin());
  if (after == 0) return {0, 0, 0};
  if (after == ascending.size()) return {after - 1, after - 1, 0};
  const double low = ascending[after - 1], high = ascending[after];
  return {after - 1, after, (value - low) / (high - low)};
}

void require_ascending(std::span<const double> values, const char* what, const char* unit,
                       const std::string& file) {
  for (std::size_t n = 1; n < values.size(); ++n)
    if (!(values[n] > values[n - 1]))
      throw protocol::UserError(
          "", fmt::format("{}: the {} {:g} {} follows {:g} {}; give values that increase", file, what,
                          values[n], unit, values[n - 1], unit));
}

}  // namespace adit::foundation
