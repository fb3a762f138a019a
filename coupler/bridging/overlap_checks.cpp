#include "coupler/bridging/overlap_checks.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "coupler/bridging/presence.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;
using Condition = std::function<bool(double, double)>;

constexpr double kSlack = 0.15;  // of the overlap's width

std::string reach(const BoundingBox& box) {
  return fmt::format("reaches from ({:g}, {:g}) to ({:g}, {:g}) m", box.x_min, box.y_min, box.x_max,
                     box.y_max);
}

std::vector<double> those(std::span<const double> samples, const Condition& wanted) {
  std::vector<double> chosen;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2)
    if (wanted(samples[i], samples[i + 1])) chosen.insert(chosen.end(), {samples[i], samples[i + 1]});
  return chosen;
}

struct Gap {
  double x = 0, y = 0, distance = 0;  // [m]
};

// The one of the places that lies farthest from where the model is.
Gap widest_gap(std::span<const double> places, const Presence& model, double slack) {
  Gap widest;
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    if (const double gap = model.gap(places[i], places[i + 1], slack); gap > widest.distance)
      widest = {places[i], places[i + 1], gap};
  return widest;
}

// The two edges are parallel lines. Both run through the box if one of its corners lies before both of them
// and another behind both.
void require_edges_inside(const Overlap& overlap, const std::string& model, const BoundingBox& box) {
  const auto [lowest, highest] =
      std::minmax({overlap.depth(box.x_min, box.y_min), overlap.depth(box.x_max, box.y_min),
                   overlap.depth(box.x_min, box.y_max), overlap.depth(box.x_max, box.y_max)});
  constexpr double kTouching = 1e-9;
  const auto refuse = [&](const char* field, const scene::Point& point) {
    throw UserError(fmt::format("{}.overlap.{}", overlap.path(), field),
                    fmt::format("is ({:g}, {:g}) m, which puts this edge of the overlap outside `{}`, which "
                                "{}; both models must exist over the whole overlap",
                                point.x(), point.y(), model, reach(box)));
  };
  const scene::Overlap& given = overlap.interface().overlap();
  if (highest < 1 - kTouching) refuse("particles_begin", given.particles_begin());
  if (lowest > kTouching) refuse("continuum_ends", given.continuum_ends());
}

// What to do about a gap; where zones are larger than the overlap is wide, their places say little of it.
std::string remedy_of(const Overlap& overlap, const Presence& absent, const Gap& gap) {
  std::string remedy = overlap.is_ring()
                           ? "let it reach over the ring and what that lies around, or let both end together"
                           : "both must fill the overlap's cross-section";
  if (absent.is_nowhere()) return remedy;
  if (const double size = absent.size(gap.x, gap.y); size > overlap.width())
    remedy += fmt::format(
        "; if it does, its zones of about {:.2g} m are too large for an overlap {:.2g} m wide: make "
        "them smaller or the overlap wider",
        size, overlap.width());
  return remedy;
}

[[noreturn]] void refuse_gap(const Overlap& overlap, const Gap& gap, const Presence& model,
                             const std::string& absent, const std::string& present) {
  throw UserError(
      overlap.path() + ".overlap",
      fmt::format("is not filled by `{}` at ({:g}, {:g}) m, where `{}` is: its nearest place is {:.3g} m "
                  "away; {}",
                  absent, gap.x, gap.y, present, gap.distance, remedy_of(overlap, model, gap)));
}

void require_filled(const Overlap& overlap, std::span<const double> outer, std::span<const double> inner) {
  const std::string &outer_name = overlap.interface().outer(), &inner_name = overlap.interface().inner();
  const double slack = kSlack * overlap.width();
  const Condition within = [&](double x, double y) { return overlap.contains(x, y); };
  const Presence inner_model(inner), outer_model(outer);
  if (const Gap gap = widest_gap(those(outer, within), inner_model, slack); gap.distance > 0)
    refuse_gap(overlap, gap, inner_model, inner_name, outer_name);
  if (const Gap gap = widest_gap(those(inner, within), outer_model, slack); gap.distance > 0)
    refuse_gap(overlap, gap, outer_model, outer_name, inner_name);
  if (!overlap.is_ring()) return;
  const Condition lost = [&](double x, double y) {
    return overlap.core().distance(x, y) < 0 && !inner_model.surrounds(x, y);
  };
  if (const Gap gap = widest_gap(those(outer, lost), inner_model, slack); gap.distance > 0)
    refuse_gap(overlap, gap, inner_model, inner_name, outer_name);
}

void require_ring_meets(const Overlap& overlap, const Filled& outer) {
  const auto refuse = [&](const char* what, const char* remedy) {
    throw UserError(
        overlap.path() + ".overlap",
        fmt::format("{} `{}`, which {}; {}", what, overlap.interface().outer(), reach(outer.box), remedy));
  };
  bool meets = false, leaves = false;
  for (std::size_t i = 0; i + 1 < outer.samples.size(); i += 2) {
    const double x = outer.samples[i], y = outer.samples[i + 1];
    meets = meets || overlap.depth(x, y) < 1;
    leaves = leaves || overlap.outer_weight(x, y) > 0;
  }
  if (!meets) refuse("lies outside", "move it inside");
  if (!leaves) refuse("leaves nothing of", "give a smaller shape");
}

}  // namespace

// Only samples in the overlap, in its core and near them matter.
void require_inside(const Overlap& overlap, const Filled& outer, const Filled& inner) {
  if (overlap.is_ring()) {
    require_ring_meets(overlap, outer);
  } else {
    require_edges_inside(overlap, overlap.interface().outer(), outer.box);
    require_edges_inside(overlap, overlap.interface().inner(), inner.box);
  }
  const Condition near = [&](double x, double y) {
    return overlap.core().distance(x, y) <= 2 * overlap.width();
  };
  require_filled(overlap, those(outer.samples, near), those(inner.samples, near));
}

}  // namespace adit::coupler
