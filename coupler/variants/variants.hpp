// What a scene becomes with other values, told for many of them by one program: `adit study` asks before its
// first run.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace adit::coupler {

// Which ground motion of a scene is measured.
struct Measured {
  bool asked = false;
  std::string key;              // its path; empty: the acceleration of the base, or of the excitation
  std::vector<double> periods;  // of the spectral accelerations [s]
};

// Reads lines of JSON, an object {path: text} of values as `--set` takes them each, and answers each with a
// line:
//   {"hash": of all that is computed, "statics": of what the state at rest depends on, "motion": …}
// or {"error": sentence} where the scene is refused. `motion` is there where it is asked for:
//   {"key", "pga" [m/s^2], "pgv" [m/s], "pgd" [m], "arias" [m/s], "cav" [m/s], "sa": [m/s^2] at 5 % of
//   damping}
// of the curve that acts during the run. Throws UserError where a line is no such object.
void tell_variants(const std::string& scene, const Measured& measured, std::istream& in, std::ostream& out);

}  // namespace adit::coupler
