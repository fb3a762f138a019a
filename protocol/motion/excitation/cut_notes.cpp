#include "protocol/motion/excitation/cut_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/motion/measures.hpp"
#include "protocol/motion/processing/part.hpp"

namespace adit::motion {
namespace {

constexpr double kNegligible = 0.01;
constexpr double kJump = 0.05;  // of the peak, that a motion may have at once

// The whole motion at a time, its shares of the Arias intensity before and after.
struct State {
  double before, after, velocity;
  State(const Motion& whole, double time) {
    const auto last = static_cast<double>(whole.acceleration.size() - 1);
    const auto at = static_cast<std::size_t>(std::min(std::round(time / whole.dt), last));
    before = husid(whole)[at];
    after = husid(whole).back() - before;
    velocity = integrate(whole).velocity[at];
  }
};

}  // namespace

std::vector<std::string> notes_on_cut(const Motion& whole, const Cut& cut) {
  std::vector<std::string> notes;
  const State first(whole, cut.from);
  if (first.before > kNegligible)
    notes.push_back(
        fmt::format("the motion is used from {:g} s on, inside its shaking: {:.1f} % of its Arias intensity "
                    "come before, and "
                    "its velocity is then {:.2g} m/s; begin earlier to leave out less",
                    cut.from, 100 * first.before, first.velocity));
  const double peak = peaks(whole).acceleration, at_once = std::abs(whole.acceleration.front());
  if (cut.from <= 0 && at_once > kJump * peak)
    notes.push_back(
        fmt::format("the motion begins at once with {:.2g} m/s^2, {:.0f} % of its peak: what lies before its "
                    "first value is lost; let it begin later, or lead it in by a `taper`",
                    at_once, 100 * at_once / peak));
  const double end = std::min(cut.until, cut.from + cut.duration);
  const State last(whole, end);
  if (last.after > kNegligible)
    notes.push_back(
        fmt::format("the motion is used up to {:g} s, inside its shaking: {:.1f} % of its Arias intensity "
                    "come afterwards, and "
                    "its velocity is then {:.2g} m/s; {} to leave out less",
                    end, 100 * last.after, last.velocity,
                    cut.until < cut.from + cut.duration ? "end later" : "lengthen time.duration"));
  const double added = added_by_window(whole, cut.from, cut.until);
  if (added > kNegligible * peak)
    notes.push_back(
        fmt::format("where the motion is cut it is led from rest or to rest, which raises its acceleration "
                    "there by up to "
                    "{:.2g} m/s^2, {:.1f} % of its peak; cut where the ground moves less",
                    added, 100 * added / peak));
  return notes;
}

}  // namespace adit::motion
