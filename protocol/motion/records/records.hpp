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
// and then the values. A file is refused if it gives no unit of acceleration, if the number of values differs
// from the count, or if a value exceeds 10 g: that is more than twice the strongest motion ever recorded, so
// the unit must be wrong.
Motion read_at2(const std::filesystem::path& file);

// Two columns, time and acceleration, below one line of names with units, after an underscore or in brackets:
// "time_s,acceleration_m/s^2", "t [s],a [gal]". Empty lines and lines that begin with `#` are skipped. The
// time steps must be equal (to 1 %); the motion begins at the first time.
Motion read_csv(const std::filesystem::path& file);

// Reads the format that the ending of the name tells, .at2 or .csv, in capitals or not.
Motion read_motion(const std::filesystem::path& file);
// The same for the content of a file.
Motion parse_motion(const std::string& file, const std::string& content);

// The value of one `unit` in m/s^2. Units are written as in protocol/scene/fields/units.hpp, or as PEER
// writes them: G, GAL, CM/S/S, CM/SEC/SEC, CM/SEC^2, CM/S**2.
double acceleration_unit(std::string_view unit);

}  // namespace adit::motion
