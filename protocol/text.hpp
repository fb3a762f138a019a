// Text that the user reads or wrote: numbers, names, and what fits into a one-line message.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// Without blanks and tabs at both ends.
std::string_view trim(std::string_view text);

// On one line and at most 60 bytes long: control characters become spaces, the rest is cut with `...`.
std::string shorten(std::string_view text);

// `text`, shortened, between backticks.
std::string quote(std::string_view text);

// The shortest decimal that reads back to the same bits.
std::string shortest(double value);

// The scene's own word for an enumerator, whose name is in capitals.
std::string lower_case(std::string_view name);

}  // namespace adit::protocol
