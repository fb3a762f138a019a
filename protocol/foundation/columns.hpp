// Tables of numbers in CSV.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace adit::foundation {

// The columns of a table whose first line holds exactly these names; empty lines and lines that begin with
// `#` are skipped. Throws UserError without a path, "file:line: ...", where the names or a row are others, a
// cell is not a finite number, or there is no row.
std::vector<std::vector<double>> read_columns(const std::string& file, const std::string& content,
                                              std::span<const std::string> names);

}  // namespace adit::foundation
