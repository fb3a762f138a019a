// How messages quote what lies in a file that a scene names.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// `content` between backticks, with at most 40 characters: a longer one ends with `...`. A scene may name any
// file that its user can read, and messages travel further than files: they show a word, not a line.
std::string excerpt(std::string_view content);

}  // namespace adit::protocol
