#include "protocol/text.hpp"

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <cctype>
#include <charconv>
#include <iterator>

#include "protocol/excerpt.hpp"
#include "protocol/unseen.hpp"

namespace adit::protocol {
namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

// The first characters of a text. A byte that begins no character stands for itself, so that one wrong byte
// costs no more than itself.
std::u32string characters(std::string_view text, std::size_t at_most) {
  constexpr char32_t kReplacement = 0xfffd;
  std::u32string found;
  for (auto at = text.begin(); at != text.end() && found.size() < at_most;) {
    const auto begin = at;
    const auto c = Utf8::decode(at, text.end());
    const bool valid = c != boost::locale::utf::illegal && c != boost::locale::utf::incomplete;
    if (!valid) at = begin + 1;
    found += valid ? static_cast<char32_t>(c) : kReplacement;
  }
  return found;
}

std::string encode(std::u32string_view text) {
  std::string bytes;
  for (const char32_t c : text) Utf8::encode(c, std::back_inserter(bytes));
  return bytes;
}

std::string encode_one_line(std::u32string text) {
  std::ranges::replace_if(text, is_unseen, U' ');
  return encode(text);
}

// On one line, a longer text with `...` as its last characters.
std::string cut(std::string_view text, std::size_t longest) {
  std::u32string line = characters(text, longest + 1);
  if (line.size() > longest) line.replace(longest - 3, line.npos, U"...");
  return encode_one_line(std::move(line));
}

}  // namespace

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string valid_utf8(std::string_view text) {
  return encode(characters(text, text.size()));
}

std::string one_line(std::string_view text) {
  return encode_one_line(characters(text, text.size()));
}

std::string shorten(std::string_view text) {
  return cut(text, 60);
}

std::string quote(std::string_view text) {
  return "`" + shorten(text) + "`";
}

std::string excerpt(std::string_view content) {
  return "`" + cut(content, 40) + "`";
}

std::string_view without_byte_order_mark(std::string_view content) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return content.starts_with(kMark) ? content.substr(kMark.size()) : content;
}

bool is_utf16(std::string_view content) {
  return content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff");
}

std::string shortest(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

std::string lower_case(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace adit::protocol
