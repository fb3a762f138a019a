#include "fdm_server/meshing/mesh_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/excerpt.hpp"
#include "protocol/text.hpp"

namespace adit::fdm {

using protocol::excerpt;

namespace {

bool blank(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

}  // namespace

void MeshText::skip_blanks() {
  for (; next_ < text_.size() && blank(text_[next_]); ++next_)
    if (text_[next_] == '\n') ++line_;
}

bool MeshText::at_end() {
  skip_blanks();
  return next_ == text_.size();
}

std::string_view MeshText::word(const char* what) {
  skip_blanks();
  last_line_ = line_;
  const std::size_t begin = next_;
  while (next_ < text_.size() && !blank(text_[next_])) ++next_;
  if (next_ == begin) refuse(fmt::format("ends where {} was expected; the file is not complete", what));
  return text_.substr(begin, next_ - begin);
}

double MeshText::number(const char* what) {
  const auto text = word(what);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // from_chars() accepts `inf` and `nan`, which are no places.
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    refuse(fmt::format("has {} where {} was expected", excerpt(text), what));
  return value;
}

std::int64_t MeshText::whole(const char* what) {
  const auto text = word(what);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse(fmt::format("has {} where {} was expected", excerpt(text), what));
  return value;
}

std::size_t MeshText::count(const char* what) {
  const auto value = whole(what);
  if (value < 0 || static_cast<std::uint64_t>(value) > (text_.size() - next_) / 2)
    refuse(fmt::format("states {} as {}, more than the file can hold", value, what));
  return static_cast<std::size_t>(value);
}

std::string MeshText::quoted(const char* what) {
  skip_blanks();
  last_line_ = line_;
  const auto end =
      next_ < text_.size() && text_[next_] == '"' ? text_.find('"', next_ + 1) : std::string_view::npos;
  if (end == std::string_view::npos) refuse(fmt::format("lacks {} in quotation marks", what));
  const auto begin = next_ + 1;
  next_ = end + 1;
  const std::string text(text_.substr(begin, end - begin));
  if (protocol::one_line(text) != protocol::valid_utf8(text))
    refuse(fmt::format("has a character in {} that is not seen: {}; write it without", what, excerpt(text)));
  return text;
}

void MeshText::expect(std::string_view expected) {
  const auto found = word(expected.data());
  if (found != expected) refuse(fmt::format("has {} where {} was expected", excerpt(found), expected));
}

void MeshText::skip_past(std::string_view expected) {
  while (word(expected.data()) != expected) {
  }
}

void MeshText::refuse(const std::string& message) const {
  throw protocol::UserError(path_, fmt::format("{}:{}: {}", name_, last_line_, message));
}

}  // namespace adit::fdm
