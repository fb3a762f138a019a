// Helpers for text that the user reads or has written: numbers, names and one-line messages.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// `text` without blanks and tabs at both ends.
std::string_view trim(std::string_view text);

// `text` on one line of at most 60 bytes: control characters become spaces, a longer text ends with `...`.
std::string shorten(std::string_view text);

// `text`, shortened, between backticks.
std::string quote(std::string_view text);

// The shortest decimal that reads back to the same bits.
std::string shortest(double value);

// The word that scenes use for an enumerator, whose name is written in capitals.
std::string lower_case(std::string_view name);

}  // namespace adit::protocol
