#include "protocol/unseen.hpp"

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>

namespace adit::protocol {
namespace {

struct Range {
  char32_t first, last;
  bool holds(char32_t c) const { return first <= c && c <= last; }
};

constexpr std::array kUnseen = {
    Range{0, 0x1f},           // C0
    Range{0x7f, 0x9f},        // DEL and C1
    Range{0xad, 0xad},        // soft hyphen
    Range{0x600, 0x605},      // Arabic signs before numbers
    Range{0x61c, 0x61c},      // Arabic letter mark
    Range{0x6dd, 0x6dd},      // Arabic end of ayah
    Range{0x70f, 0x70f},      // Syriac abbreviation mark
    Range{0x890, 0x891},      // Arabic marks above
    Range{0x8e2, 0x8e2},      // Arabic disputed end of ayah
    Range{0x180e, 0x180e},    // Mongolian vowel separator
    Range{0x200b, 0x200f},    // zero width, left-to-right and right-to-left marks
    Range{0x2028, 0x202e},    // line and paragraph separators, embeddings and overrides
    Range{0x2060, 0x206f},    // word joiner, invisible operators, isolates
    Range{0xfeff, 0xfeff},    // byte order mark
    Range{0xfff9, 0xfffb},    // interlinear annotation
    Range{0x110bd, 0x110bd},  // Kaithi number signs
    Range{0x110cd, 0x110cd}, Range{0x13430, 0x1343f},  // Egyptian hieroglyph joiners
    Range{0x1bca0, 0x1bca3},                           // shorthand controls
    Range{0x1d173, 0x1d17a},                           // musical beams and slurs
    Range{0xe0001, 0xe0001},                           // tags
    Range{0xe0020, 0xe007f},
};

constexpr std::array kBlanks = {
    Range{0x20, 0x20},     Range{0xa0, 0xa0},     Range{0x1680, 0x1680}, Range{0x2000, 0x200a},
    Range{0x202f, 0x202f}, Range{0x205f, 0x205f}, Range{0x3000, 0x3000},
};

template <class Ranges>
bool any_holds(const Ranges& ranges, char32_t c) {
  return std::ranges::any_of(ranges, [c](const Range& range) { return range.holds(c); });
}

}  // namespace

bool is_unseen(char32_t character) {
  return any_holds(kUnseen, character);
}

bool is_one_visible_word(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  for (auto at = text.begin(); at != text.end();) {
    const auto c = Utf8::decode(at, text.end());
    if (c == boost::locale::utf::illegal || c == boost::locale::utf::incomplete) return false;
    if (is_unseen(c) || any_holds(kBlanks, c)) return false;
  }
  return true;
}

}  // namespace adit::protocol
