// The words of a mesh file, with the lines on which they stand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace adit::fdm {

class MeshText {
 public:
  // `name`: of the file; `path`: of the scene field that names it. Both for messages.
  MeshText(std::string_view text, std::string name, std::string path)
      : text_(text), name_(std::move(name)), path_(std::move(path)) {}

  bool at_end();
  // The next word; `what` says in a message what was expected.
  std::string_view word(const char* what);
  double number(const char* what);  // finite
  std::int64_t whole(const char* what);
  // A number of things of which each takes at least two characters: never more than the text can hold.
  std::size_t count(const char* what);
  std::string quoted(const char* what);  // "any text" that is seen as it is (protocol/unseen.hpp)
  void expect(std::string_view word);
  void skip_past(std::string_view word);

  // Throws UserError: "tunnel.msh:12: …" at the line of the last word.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  void skip_blanks();

  std::string_view text_;
  std::size_t next_ = 0, line_ = 1, last_line_ = 1;
  std::string name_, path_;
};

}  // namespace adit::fdm
