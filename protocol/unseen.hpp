// Characters that a reader does not see, but that change what is seen.
#pragma once

#include <string_view>

namespace adit::protocol {

// Control characters (C0, DEL, C1), line and paragraph separators, and format characters (Unicode 15,
// category Cf): those that turn the direction of writing, those of no width, and tags.
bool is_unseen(char32_t character);

// Whether `text` is UTF-8 without these and without blanks of any width.
bool is_one_visible_word(std::string_view text);

}  // namespace adit::protocol
