// How the report words its numbers and sets its lines.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace adit::coupler {

std::string grouped(std::uint64_t count);  // 1,234,567
std::string memory(double bytes);          // 45 MB
std::string clock_time(double seconds);    // 3.4 s, 12 min, 5.2 h

// "label              text", the text in the column where those of a run's summary stand.
void print_line(const std::string& label, const std::string& text);

// Rows of as many cells; the first cells are set to the left, the others to the right.
void print_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace adit::coupler
