// Readers of recorded motions. Messages begin with the file and the line: "kobe.AT2:4: ...".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// A file of the PEER strong motion database: a title, the unit ("... IN UNITS OF G"), a line with the count
// and the step in either style
//   NPTS =   7500 , DT =   .020 SEC ,        4096    0.0100    NPTS, DT
// and then the values. Refused are: no unit or none of acceleration; another count of values than stated; a
// value above 10 g, more than twice the strongest ever recorded, which betrays a wrong unit.
Motion read_at2(const std::filesystem::path& file);

// Two columns, time and acceleration, below one line of names that state the units, after an underscore or
// in brackets: "time_s,acceleration_m/s^2", "t [s],a [gal]". Empty lines and lines that begin with `#` are
// passed over. The times are at equal steps (to 1 % of a step); the motion begins at the first.
Motion read_csv(const std::filesystem::path& file);

// By the end of the name, in either case: .at2 or .csv.
Motion read_motion(const std::filesystem::path& file);
// The same of a file's content.
Motion parse_motion(const std::string& file, const std::string& content);

// What one of `unit` is in m/s^2. Understood: protocol/scene/fields/units.hpp, and as PEER writes them: G,
// GAL, CM/S/S, CM/SEC/SEC, CM/SEC^2, CM/S**2.
double acceleration_unit(std::string_view unit);

}  // namespace adit::motion
