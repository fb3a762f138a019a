// What the readers of both formats need: the lines of a file, the numbers in them, and errors that name the
// line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

struct RecordText {
  std::string file;
  std::vector<std::string> lines;  // without line ends

  // Throws UserError "file:line: message"; lines count from 0 here, and from 1 in the message.
  [[noreturn]] void refuse(std::size_t line, const std::string& message) const;

  // The number that `text`, a part of `line`, consists of; refused unless it is finite.
  double number(std::size_t line, std::string_view text) const;
};

// A sentence that doubts the unit (`factor` m/s^2) if the motion is stronger than any earthquake; else empty.
std::string doubt_of_unit(const Motion& motion, double factor, std::string_view unit);

RecordText split_text(const std::string& file, const std::string& content);
RecordText read_text(const std::filesystem::path& file);

// The formats are described in records.hpp.
Motion parse_at2(const RecordText& text);
Motion parse_csv(const RecordText& text);

}  // namespace adit::motion
