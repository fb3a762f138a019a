// Helpers for text that the user reads or has written: numbers, names and one-line messages.
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// `text` without blanks and tabs at both ends.
std::string_view trim(std::string_view text);

// `text` in which U+FFFD stands for each byte that is not UTF-8.
std::string valid_utf8(std::string_view text);

// The same on one line, fit for logs and terminals whoever wrote it: control characters, and those that turn
// the direction of writing, become spaces.
std::string one_line(std::string_view text);

// The same with at most 60 characters: a longer text ends with `...`.
std::string shorten(std::string_view text);

// `text`, shortened, between backticks.
std::string quote(std::string_view text);

// The content of a text file without the byte order mark of UTF-8, with which Excel begins its tables.
std::string_view without_byte_order_mark(std::string_view content);

// The content begins with the byte order mark of UTF-16.
bool is_utf16(std::string_view content);

// The shortest decimal that reads back to the same bits.
std::string shortest(double value);

// ASCII capitals as small letters, which scenes use for enumerators.
std::string lower_case(std::string_view name);

}  // namespace adit::protocol
