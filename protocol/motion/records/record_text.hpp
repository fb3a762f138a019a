// What both readers need: the lines of a file, numbers in them, and messages that name the place.
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
  std::vector<std::string> lines;  // without their ends

  // Throws UserError "file:line: message"; lines count from 0 here and from 1 in the message.
  [[noreturn]] void refuse(std::size_t line, const std::string& message) const;

  // The finite number that is all of `text`, found in `line`.
  double number(std::size_t line, std::string_view text) const;
};

// What is wrong with the unit, of so many m/s^2, if the motion is stronger than any earthquake; else empty.
std::string doubt_of_unit(const Motion& motion, double factor, std::string_view unit);

RecordText split_text(const std::string& file, const std::string& content);
RecordText read_text(const std::filesystem::path& file);

// What records.hpp says of the formats.
Motion parse_at2(const RecordText& text);
Motion parse_csv(const RecordText& text);

}  // namespace adit::motion
