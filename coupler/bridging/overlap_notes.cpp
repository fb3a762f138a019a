#include "coupler/bridging/overlap_notes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/bridging/presence.hpp"

namespace adit::coupler {
namespace {

std::string narrow_note(const Overlap& overlap, const Side& side) {
  if (!side.part.has_continuum()) return {};
  const Presence model(side.samples);
  double zone = 0;
  for (std::size_t i = 0; i + 1 < side.samples.size(); i += 2)
    if (const double x = side.samples[i], y = side.samples[i + 1]; overlap.contains(x, y)) {
      const double size = model.size(x, y);
      if (zone == 0 || size < zone) zone = size;
    }
  if (overlap.width() >= (1 - 1e-6) * zone) return {};
  return fmt::format(
      "{}.overlap is {:.3g} m wide, less than a zone of `{}` there ({:.3g} m); two zones or more carry "
      "waves better",
      overlap.path(), overlap.width(), side.name, zone);
}

}  // namespace

std::vector<std::string> overlap_notes(const Overlap& overlap, const Side& outer, const Side& inner) {
  std::vector<std::string> notes{narrow_note(overlap, outer), narrow_note(overlap, inner)};
  std::erase(notes, "");
  return notes;
}

}  // namespace adit::coupler
