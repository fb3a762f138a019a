// Where a value lies among ascending ones.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace adit::foundation {

// Two elements and how far between them; both are the first or the last one for a value beyond these.
struct Bracket {
  std::size_t before, after;
  double share;  // in [0, 1]
};
Bracket bracket(std::span<const double> ascending, double value);

// Throws UserError without a path, "file: ...", for values that do not increase; `what` is their name, such
// as "time".
void require_ascending(std::span<const double> values, const char* what, const char* unit,
                       const std::string& file);

}  // namespace adit::foundation
