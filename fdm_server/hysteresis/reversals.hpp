// Hysteresis whose cost does not grow with the number of elements: what the ground remembers is where its
// strain turned back.
//
// The backbone is that of elastic, perfectly plastic elements in parallel (polyline.hpp). Element x yields on
// the sphere of radius x about its plastic strain c(x), in the space of the deviators of strain e, whose
// length |e| is the engineering shear strain. The spheres are nested, and those that yield touch one another
// at e (Mroz 1967, J. Mech. Phys. Solids 15; with infinitely many of them Mroz, Norris & Zienkiewicz 1978,
// Int. J. Numer. Anal. Methods Geomech. 2, and Chu 1984, J. Mech. Phys. Solids 32): the memory is a curve of
// centres c(x) with |c'| <= 1. It begins at e, for strain is what it must hold, and ends at 0.
//
// A step to e2 finds the largest sphere of the curve on which e2 lies, |e2 - c(r)| = r. All elements x <= r
// yield and touch there, c(x) = e2 - x n with the normal n = (e2 - c(r))/r; the curve beyond r stays. As long
// as r grows, that is one straight piece of the curve; where the strain turns back into the sphere, the piece
// is left behind as part of the curve, and a new one begins. On a straight piece, c(x) = a + u x,
//   f = e - a,  r = f.f / (f.u + sqrt((f.u)^2 + (1 - u.u) f.f)),   n + u = f/r,
// and the stress has grown since its beginning by the secant, (S/r + H) f with the backbone's S(r) and H(r).
// First loading has u = 0 and r = |e|; after reversals u.u = 1 and r = -f.f/(2 f.n) with the normal n of the
// reversal, where f is 0.
//
// In simple shear, and on any path along one line through the origin, r is |e| at first and |f|/2 then:
// Masing's extended rules, and the stress of Iwan's elements to rounding (iwan_elements.hpp). Where
// the direction turns, Iwan's elements each go their own way and dissipate even on a circle |e| = constant,
// where these only turn: they are stiffer against turning, and dissipate less.
//
// Energy: in a step from e1 to e2 an element that moves its centre by dc dissipates (s1 + s2)/2 . dc over its
// stresses s = G (e - c). Its sum over a piece is in closed form, so that work = stored + dissipated to
// rounding. For those that touch before and after, it is G x (n1 + n2).de/2, not negative as long as the
// normal turns by less than a right angle in a step that loads.
//
// Narrower loops (polyline.hpp): F times the stress above and (1 - F) times the secant line to the largest
// strain g = |e| ever, F = F(g), so that tips stay where they are. While g grows both are one: first loading
// is the backbone. The energy stored is F and 1 - F times those of both; first loading dissipates (1 + F) S/2
// + F' (S g - Q)/2 for a unit of g.
//
// The vector is that of a whole zone: the in-plane deviators of its four sampling points, weighed by their
// areas, and the deviator across, which they share. All stresses are over the initial shear modulus.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "fdm_server/hysteresis/polyline.hpp"

namespace adit::fdm {

// Strains xx - yy of four points, xy of four, zz doubled; stresses (xx - yy)/2, xy, zz of the deviator.
inline constexpr std::size_t kZoneStrains = 9;
using ZoneStrain = std::array<double, kZoneStrains>;

struct OuterPiece {
  ZoneStrain drift;  // u
  double end;        // radius
};

// What a zone remembers, apart from outer pieces: the straight piece on which it is, from the last reversal.
struct InnerPiece {
  ZoneStrain strain, drift;  // f, u
  double radius, end;        // r, and where the piece ends
  double share, spring;      // F, and (1 - F) (S/g + H), of the largest strain; 1 and 0 in first loading
};
inline constexpr double kNoEnd = std::numeric_limits<double>::infinity();
inline constexpr InnerPiece kVirgin{{}, {}, 0, kNoEnd, 1, 0};

struct ZoneMemory {
  InnerPiece inner = kVirgin;
  std::vector<OuterPiece> outer;  // the last is the next
};

// The radius r, from f.u, 1 - u.u and f.f, or from a multiple of all three; infinite where f lies outside the
// spheres.
[[gnu::always_inline]] inline double sphere_radius(double along, double slack, double size) {
  const double rest = slack > 0 ? slack : 0;
  const double root = along + std::sqrt(along * along + rest * size);
  return size > 0 ? size / root : 0;
}

struct HystereticStep {
  ZoneStrain stress;  // by which it grows
  double dissipated;  // energy per volume
};

// Strains the zone by `step`. The weights, whose first four sum to 1, as the second four do, and the last is
// 3/4, make the inner product of two stresses, or of a stress and a strain.
HystereticStep advance(const PolylineView& line, const ZoneStrain& weights, const ZoneStrain& step,
                       ZoneMemory& memory);

// What the memory holds.
struct Held {
  ZoneStrain strain, stress;
  double energy;  // per volume
};
Held held(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& inner,
          std::span<const OuterPiece> outer);

// What the outer pieces hold of it, while the zone stays on its inner piece. The strain f on that is f + o on
// an outer piece, whose elements are those from where the one before ends to its own end: with their slope H,
// intercept S and moment Q
//   stress  -H (f + o) - S u,  energy  Q u.u/2 - H (f + o).(f + o)/2 - S (f + o).u,
// so that all together are quadratic in f.
struct OuterSum {
  ZoneStrain offset;  // o of the last: f + o is the strain of the zone
  ZoneStrain stress;  // sum of H o + S u
  double slope;       // sum of H
  double energy;      // sum of (Q u.u - H o.o)/2 - S o.u
};
OuterSum sum_of(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& inner,
                std::span<const OuterPiece> outer);
Held held(const PolylineView& line, const ZoneStrain& weights, const InnerPiece& inner,
          const OuterSum& outer);

}  // namespace adit::fdm
