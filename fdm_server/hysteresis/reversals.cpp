#include "fdm_server/hysteresis/reversals.hpp"

#include <algorithm>

namespace adit::fdm {
namespace {

double inner(const ZoneStrain& weights, const ZoneStrain& a, const ZoneStrain& b) {
  const auto term = [&](std::size_t i) { return weights[i] * (a[i] * b[i]); };
  std::array<double, 4> points;  // side by side, not one after the other
  for (std::size_t k = 0; k < 4; ++k) points[k] = term(k) + term(4 + k);
  return ((points[0] + points[2]) + (points[1] + points[3])) + term(8);
}

// a + factor b
ZoneStrain sum(const ZoneStrain& a, double factor, const ZoneStrain& b) {
  ZoneStrain result;
  for (std::size_t i = 0; i < kZoneStrains; ++i) result[i] = a[i] + factor * b[i];
  return result;
}

double radius_of(const ZoneStrain& weights, const ZoneStrain& strain, const ZoneStrain& drift) {
  return sphere_radius(inner(weights, strain, drift), 1 - inner(weights, drift, drift),
                       inner(weights, strain, strain));
}

ZoneStrain normal_of(const ZoneStrain& strain, const ZoneStrain& drift, double radius) {
  return radius > 0 ? sum(sum({}, -1, drift), 1 / radius, strain) : ZoneStrain{};
}

// The backbone at a radius.
struct Yielded {
  double slope, intercept, moment;
};
Yielded yielded(const PolylineView& line, double radius) {
  const auto piece = line.piece(radius);
  return {line.slope[piece], line.intercept[piece], line.moment[piece]};
}
Yielded operator-(const Yielded& a, const Yielded& b) {
  return {a.slope - b.slope, a.intercept - b.intercept, a.moment - b.moment};
}

double share_at(const PolylineView& line, double strain) {
  const auto piece = line.piece(strain);
  return line.share[piece] + line.share_slope[piece] * strain;
}

// A piece as a step sees it: the strain from its beginning, before and after.
struct Piece {
  ZoneStrain before, after;
  const ZoneStrain* drift;
  double end;
};
Piece beyond(const Piece& piece, const OuterPiece& outer) {
  const ZoneStrain between = sum(outer.drift, -1, *piece.drift);
  return {sum(piece.before, piece.end, between), sum(piece.after, piece.end, between), &outer.drift,
          outer.end};
}

// What narrower loops store in first loading beyond what the others do.
double stored_beyond(const Yielded& at, double share, double radius) {
  return (1 - share) * (at.intercept * radius - at.moment) / 2;
}

// A reversal begins a new piece. Pieces that meet where no element is are one, so that there are at most
// about two for each element.
void turn_back(const PolylineView& line, const ZoneStrain& normal, ZoneMemory& memory) {
  InnerPiece& in = memory.inner;
  auto& outer = memory.outer;
  if (in.end == kNoEnd) {
    const Yielded at = yielded(line, in.radius);
    in.share = share_at(line, in.radius);
    in.spring = (1 - in.share) * (at.slope + at.intercept / in.radius);
  }
  if (in.end != kNoEnd && !outer.empty() && outer.back().end != kNoEnd &&
      line.piece(in.radius) == line.piece(outer.back().end)) {
    auto& [drift, end] = outer.back();
    const double own = (in.end - in.radius) / (end - in.radius);
    drift = sum(sum({}, 1 - own, drift), own, in.drift);
  } else {
    outer.push_back({in.drift, in.end});
  }
  in = {{}, sum({}, -1, normal), 0, in.radius, in.share, in.spring};
}

}  // namespace

HystereticStep advance(const PolylineView& line, const ZoneStrain& weights, const ZoneStrain& step,
                       ZoneMemory& memory) {
  InnerPiece& in = memory.inner;
  const ZoneStrain normal = normal_of(in.strain, in.drift, in.radius);
  const bool turns = radius_of(weights, sum(in.strain, 1, step), in.drift) < in.radius &&
                     in.radius > line.end[0];  // elastic inside the first sphere: nothing to remember
  const Yielded touching = yielded(line, turns ? 0 : in.radius);
  const double stored =
      !turns && in.end == kNoEnd ? stored_beyond(touching, share_at(line, in.radius), in.radius) : 0;
  if (turns) turn_back(line, normal, memory);

  const Piece first{in.strain, sum(in.strain, 1, step), &in.drift, in.end};
  Piece last = first;
  std::size_t left = memory.outer.size();
  double radius = radius_of(weights, last.after, *last.drift);
  while (radius > last.end && left > 0) {
    last = beyond(last, memory.outer[--left]);
    radius = radius_of(weights, last.after, *last.drift);
  }
  const ZoneStrain to = normal_of(last.after, *last.drift, radius);
  const Yielded goal = yielded(line, radius);

  // Elements that touch before and after; then those of each piece that is left behind, from its centres.
  const ZoneStrain turned = sum(to, -1, normal);
  HystereticStep result{sum(sum({}, goal.slope, step), touching.intercept, turned),
                        touching.intercept * inner(weights, sum(to, 1, normal), step)};
  Yielded at = touching;
  Piece piece = first;
  for (std::size_t next = memory.outer.size();; piece = beyond(piece, memory.outer[--next])) {
    const auto [slope, intercept, moment] = (next == left ? goal : yielded(line, piece.end)) - at;
    const ZoneStrain &f1 = piece.before, &f2 = piece.after, &u = *piece.drift;
    result.stress = sum(sum(result.stress, intercept, sum(to, 1, u)), slope, f1);
    result.dissipated +=
        intercept * (inner(weights, sum(to, -1, u), f2) - inner(weights, sum(to, 1, u), f1)) -
        slope * inner(weights, f1, f2) - moment * (1 - inner(weights, u, u));
    if (next == left) break;
    at = yielded(line, piece.end);
  }
  result.dissipated *= in.share / 2;
  const ZoneStrain drift = *last.drift;  // of a piece that may be left behind
  memory.outer.resize(left);

  if (last.end != kNoEnd) {
    result.stress = sum(sum({}, in.share, result.stress), in.spring, step);
    in = {last.after, drift, radius, last.end, in.share, in.spring};
    return result;
  }
  // First loading from here on: the stress is the backbone's, the strain `last.after` counts from the start.
  const double secant = (1 - in.share) * (goal.slope + (radius > 0 ? goal.intercept / radius : 0));
  result.stress = sum(sum(sum({}, in.share, result.stress), secant, last.after), -in.spring, last.before);
  result.dissipated +=
      (secant * radius * radius + (in.spring - secant) * inner(weights, last.before, last.after) -
       (1 - in.share) * (goal.moment + goal.slope * radius * radius)) /
          2 +
      stored - stored_beyond(goal, share_at(line, radius), radius);
  in = {last.after, drift, radius, kNoEnd, 1, 0};
  return result;
}

OuterSum sum_of(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& in,
                std::span<const OuterPiece> outer) {
  OuterSum result{};
  ZoneStrain& o = result.offset;
  const ZoneStrain* u = &in.drift;
  double end = in.end;
  for (std::size_t next = outer.size(); next > 0;) {
    const OuterPiece& piece = outer[--next];
    const auto [slope, intercept, moment] = yielded(line, piece.end) - yielded(line, end);
    o = sum(o, end, sum(piece.drift, -1, *u));
    u = &piece.drift;
    end = piece.end;
    result.stress = sum(sum(result.stress, slope, o), intercept, *u);
    result.slope += slope;
    result.energy += (moment * inner(weights, *u, *u) - slope * inner(weights, o, o)) / 2 -
                     intercept * inner(weights, o, *u);
  }
  return result;
}

Held held(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& in, const OuterSum& outer) {
  const ZoneStrain &f = in.strain, &u = in.drift;
  const Yielded at = yielded(line, in.radius);
  const auto [slope, intercept, moment] = yielded(line, in.end) - at;
  const double beyond_masing = in.end == kNoEnd ? stored_beyond(at, share_at(line, in.radius), in.radius) : 0;
  const double size = inner(weights, f, f);
  const ZoneStrain strain = sum(f, 1, outer.offset);
  ZoneStrain stress = sum({}, at.intercept, normal_of(f, u, in.radius));
  stress = sum(sum(sum(stress, -(slope + outer.slope), f), -intercept, u), -1, outer.stress);
  const double energy = (at.moment + moment * inner(weights, u, u) - (slope + outer.slope) * size) / 2 -
                        intercept * inner(weights, f, u) - inner(weights, f, outer.stress) + outer.energy;
  return {strain, sum(sum({}, in.share, stress), in.spring, strain),
          in.share * energy + in.spring * inner(weights, strain, strain) / 2 + beyond_masing};
}

Held held(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& in,
          std::span<const OuterPiece> outer) {
  return held(line, weights, in, sum_of(line, weights, in, outer));
}

}  // namespace adit::fdm
