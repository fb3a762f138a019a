// Tables as text: a header line of names that end in their units, then one line for each row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/results/disk/growing_file.hpp"

namespace adit::results {

// Every finished row is handed to the system as a whole, so that a killed run keeps all rows so far and never
// half a row. Numbers are the shortest decimals that read back to the same bits; text is quoted if CSV needs
// it. Throws as disk/write_error.hpp says if the file cannot be written, and std::logic_error if a row is not
// as long as the header.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, std::span<const std::string> columns,
          GrowingFile::Begin begin = GrowingFile::Begin::kAnew);
  // Goes on with a file of so many columns.
  CsvFile(std::filesystem::path path, std::size_t columns)
      : file_(std::move(path), GrowingFile::Begin::kGoOn), columns_(columns) {}

  // A whole row of numbers.
  void row(std::span<const double> values);

  // A row cell by cell.
  CsvFile& cell(double value);
  CsvFile& cell(std::uint64_t value);
  CsvFile& cell(std::string_view text);
  void end_row();

  std::size_t columns() const { return columns_; }
  void exchange(state::Archive& archive) { file_.exchange(archive); }

 private:
  void next_cell();

  GrowingFile file_;
  std::size_t columns_;
  std::size_t cells_ = 0;  // number of cells in the unfinished row
  std::string line_;       // the unfinished row
};

// As tables and summaries write it.
std::string_view name_of(wire::Crack::Mode mode);

// The columns of cracks.csv; `regions`: with the region of particles, as there are several.
std::vector<std::string> crack_columns(bool regions = false);

// One row of cracks.csv: a bond that broke at `time` [s]; `region` is empty where the file has no such
// column.
void write_crack(CsvFile& file, double time, const wire::Crack& crack, const std::string& region = "");

// The same of crack_paths.csv; paths are numbered from 1.
std::vector<std::string> crack_path_columns(bool regions = false);
void write_crack_path(CsvFile& file, std::uint64_t number, const wire::CrackPath& path,
                      const std::string& region = "");

}  // namespace adit::results
