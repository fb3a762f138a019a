// What the readers of all formats need: the lines of a file, the numbers in them, and errors that name the
// line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/motion.hpp"
#include "protocol/motion/records/records.hpp"

namespace adit::motion {

struct RecordText {
  std::string file;
  std::vector<std::string> lines;  // without line ends

  // Throws UserError "file:line: message"; lines count from 0 here, and from 1 in the message.
  [[noreturn]] void refuse(std::size_t line, const std::string& message) const;

  // The number that `text`, a part of `line`, consists of; refused unless it is finite. A Fortran `D` marks
  // an exponent, too.
  double number(std::size_t line, std::string_view text) const;

  // Appends the numbers of a line, between blanks. A sign begins a new number, because Fortran leaves no
  // blank between numbers that fill their width.
  void append_numbers(std::size_t line, std::vector<double>& numbers) const;

  // The line among the first ones, those of the header, that begins with a name, and what follows the name;
  // refused where there is none.
  struct Entry {
    std::size_t line;
    std::string_view value;
  };
  Entry entry(std::size_t header_lines, std::string_view name) const;

  // What `work` returns; what it refuses is refused of the line.
  template <class Work>
  auto at(std::size_t line, Work&& work) const {
    try {
      return work();
    } catch (const protocol::UserError& error) {
      refuse(line, error.what());
    }
  }
};

// The text up to the mark with which DOS ends a file (0x1A). Refuses UTF-16.
RecordText split_text(const std::string& file, const std::string& content);

// What is said where values, times `factor` in m/s^2, are stronger than any earthquake; empty where they are
// not.
std::string doubt_of_unit(std::span<const double> values, double factor, std::string_view unit);

// The values, in `unit` as the line says, as a motion. Refuses what is stronger than any earthquake: its unit
// must be wrong.
Motion in_unit(const RecordText& text, std::size_t line, std::string_view unit, double dt,
               std::vector<double> values);

// The formats, which are described in records.hpp: whether a text has the format, and its motion.
bool is_at2(const RecordText& text);
Motion parse_at2(const RecordText& text);
bool is_cosmos(const RecordText& text);
Motion parse_cosmos(const RecordText& text, const std::string& channel);
bool is_esm(const RecordText& text);
Motion parse_esm(const RecordText& text);
bool is_knet(const RecordText& text);
Motion parse_knet(const RecordText& text);
Motion parse_table(const RecordText& text, const RecordKeys& keys);

}  // namespace adit::motion
