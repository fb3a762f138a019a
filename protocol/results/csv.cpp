#include "protocol/results/csv.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace adit::results {
namespace {

template <class T>
void append_number(std::string& line, T value) {
  std::array<char, 32> text{};  // the longest double takes 24
  // Streams would follow the locale, which may write a comma for the decimal point.
  line.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

}  // namespace

CsvFile::CsvFile(std::filesystem::path path, std::span<const std::string> columns, GrowingFile::Begin begin)
    : file_(std::move(path), begin), columns_(columns.size()) {
  if (begin == GrowingFile::Begin::kGoOn) return;  // it has its header
  for (const std::string& column : columns) cell(std::string_view(column));
  end_row();
}

void CsvFile::row(std::span<const double> values) {
  for (const double value : values) cell(value);
  end_row();
}

void CsvFile::next_cell() {
  if (cells_++ > 0) line_ += ',';
}

CsvFile& CsvFile::cell(double value) {
  next_cell();
  append_number(line_, value);
  return *this;
}

CsvFile& CsvFile::cell(std::uint64_t value) {
  next_cell();
  append_number(line_, value);
  return *this;
}

CsvFile& CsvFile::cell(std::string_view text) {
  next_cell();
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line_ += text;
    return *this;
  }
  line_ += '"';
  // Within quotation marks a quotation mark is written twice (RFC 4180).
  for (const char c : text) line_.append(c == '"' ? 2 : 1, c);
  line_ += '"';
  return *this;
}

void CsvFile::end_row() {
  // A row with a missing cell would shift all later columns without anyone noticing.
  if (cells_ != columns_) {
    throw std::logic_error(file_.path().string() + ": a row of " + std::to_string(cells_) + " cells under " +
                           std::to_string(columns_) + " columns");
  }
  line_ += '\n';
  file_.append(line_);
  line_.clear();
  cells_ = 0;
}

std::vector<std::string> crack_columns(bool regions) {
  std::vector<std::string> columns = {"time_s",          "step",     "mode",     "x_m",   "y_m",  "length_m",
                                      "orientation_rad", "parent_a", "parent_b", "group", "stage"};
  if (regions) columns.emplace_back("region");
  return columns;
}

std::string_view name_of(wire::Crack::Mode mode) {
  return mode == wire::Crack::TENSILE ? "tensile" : "shear";
}

void write_crack(CsvFile& file, double time, const wire::Crack& crack, const std::string& region) {
  file.cell(time).cell(std::uint64_t{crack.step()});
  file.cell(name_of(crack.mode()));
  file.cell(crack.x()).cell(crack.y()).cell(crack.length()).cell(crack.orientation());
  file.cell(std::uint64_t{crack.parent_a()}).cell(std::uint64_t{crack.parent_b()});
  file.cell(std::string_view(crack.group())).cell(std::uint64_t{crack.stage()});
  if (!region.empty()) file.cell(std::string_view(region));
  file.end_row();
}

std::vector<std::string> crack_path_columns(bool regions) {
  std::vector<std::string> columns = {"path",      "cracks", "mode", "length_m",
                                      "opening_m", "slip_m", "x_m",  "y_m"};
  if (regions) columns.emplace_back("region");
  return columns;
}

void write_crack_path(CsvFile& file, std::uint64_t number, const wire::CrackPath& path,
                      const std::string& region) {
  file.cell(number).cell(std::uint64_t{path.cracks()}).cell(name_of(path.mode())).cell(path.length());
  file.cell(path.opening()).cell(path.slip()).cell(path.x()).cell(path.y());
  if (!region.empty()) file.cell(std::string_view(region));
  file.end_row();
}

}  // namespace adit::results
