// The known name that the user most likely meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace adit::protocol {

// Number of insertions, deletions, replacements and exchanges of neighbours that turn `a` into `b`
// (optimal string alignment distance); upper and lower case are the same letter.
int edit_distance(std::string_view a, std::string_view b);

// The known name at the smallest distance, the first one among equals. Empty if that name differs from `name`
// in more than one letter and in more than a third of its letters.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

// "; did you mean `radius`?", or an empty text if no known name is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

}  // namespace adit::protocol
