// Readers of recorded motions. Messages begin with the file and the line: "kobe.AT2:4: ...".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// What the scene says of a file that does not say it itself (MotionFile in ground_motion.proto).
struct RecordKeys {
  std::string column = {};  // name of the column, or number of the channel
  double time_step = 0;     // [s]; 0 where it is not given
  std::string unit = {};
};

// Reads a record, whose content tells its format:
// - PEER: a title, the unit ("... IN UNITS OF G"), a line with count and step in any of the styles
//     NPTS =   7500 , DT =   .020 SEC ,        DT= 20. MSEC, NPTS= 7500,        4096    0.0100    NPTS, DT
//   and then the values.
// - K-NET and KiK-net: 17 lines from `Origin Time` to `Memo.`, and counts, which `Scale Factor` turns into
// gal.
//   Their mean is taken off, because the instruments do not stand at zero.
// - COSMOS V1 and V2, and CSMIP before it: a line such as
//     2980 points of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.3)
//     9000 acceleration pts, approx  45 secs, units=cm/sec2(04),Format=(8F10.5)
//   before the values, which have the stated width. The step of the second stands in the real header, entry
//   34 [s] or 62 [ms]. Of several channels `column` gives the number.
// - ESM: lines such as `SAMPLING_INTERVAL_S: 0.005`, `UNITS: cm/s^2`, `NDATA: 9000`, and then the values.
// - A table: columns between commas, semicolons, tabs or blanks, below one line of names that end in their
//   units, after an underscore or in brackets: "time_s,acceleration_m/s^2", "t [s],a [gal]". `column` names
//   one of several accelerations, `unit` the unit that its name lacks. Empty lines and lines that begin with
//   `#` are skipped. Times begin at 0, or a step after, in equal steps (to 1 %).
// - Without names: values only, of the stated `time_step` and `unit`.
//
// Refused is a file that does not state a unit of acceleration, whose number of values differs from its
// count, or of which a value exceeds 10 g: that is more than twice the strongest motion ever recorded, so the
// unit must be wrong.
Motion parse_motion(const std::string& file, const std::string& content, const RecordKeys& keys = {});

// The value of one `unit` in m/s^2, of a unit of time in s. Units are written as in
// protocol/scene/fields/units.hpp, in capitals or not and between brackets or not: G, (G), CM/SEC/SEC, cm/s2.
double acceleration_unit(std::string_view unit);
double time_unit(std::string_view unit);

}  // namespace adit::motion
