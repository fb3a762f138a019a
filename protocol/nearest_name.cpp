#include "protocol/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace adit::protocol {
namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// The largest distance at which a name still counts as a slip of `name`. A name of a single letter allows
// none, because one replacement would turn it into any other.
int tolerated(std::string_view name) {
  return name.size() < 2 ? 0 : std::max(1, static_cast<int>(name.size()) / 3);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table distance(first i letters of a, first j letters of b): i - 2, i - 1 and i.
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest_name(std::string_view name, std::span<const std::string> known) {
  std::string nearest;
  int smallest = 0;
  for (const std::string& candidate : known) {
    const int limit = tolerated(candidate);
    // The distance is at least the difference in length, so long input is skipped before the table is filled.
    if (std::abs(static_cast<long>(name.size()) - static_cast<long>(candidate.size())) > limit) continue;
    const int distance = edit_distance(name, candidate);
    if (distance > limit || (!nearest.empty() && distance >= smallest)) continue;
    nearest = candidate;
    smallest = distance;
  }
  return nearest;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : "; did you mean `" + nearest + "`?";
}

}  // namespace adit::protocol
