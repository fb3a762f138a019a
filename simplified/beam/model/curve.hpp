// A monotone piecewise linear force law f(e) without memory: gaskets, cables, keys and linear springs.
#pragma once

#include <string>
#include <vector>

namespace adit::simplified::beam {

struct CurvePoint {
  double elongation = 0;  // [m], or per metre
  double force = 0;       // [N], or per metre; tension positive
  bool operator==(const CurvePoint&) const = default;
};

// The force of a nonlinear spring whose elongation changes linearly from e0 to e1.
struct SpringAnswer {
  double force = 0;    // the force in the equation of motion
  double tangent = 0;  // its derivative with respect to e1
};

// A straight piece of a curve, for elongations in [low, high): f = force + slope (e − anchor).
struct Piece {
  double low, high, anchor, force, slope;
  bool holds(double e) const { return e >= low && e < high; }
  double at(double e) const { return force + slope * (e - anchor); }
  SpringAnswer mean(double e0, double e1) const { return {at(0.5 * (e0 + e1)), 0.5 * slope}; }
};

// f is linear between the points and continues beyond the outer ones with the given end slopes.
struct Curve {
  std::vector<CurvePoint>
      points;               // strictly increasing elongations, forces that do not decrease; at least one
  double slope_before = 0;  // [N/m] below the first point, not negative
  double slope_after = 0;   // [N/m] above the last point, not negative

  Piece piece(double e) const;  // the piece that contains e
  double force(double e) const { return piece(e).at(e); }
  double tangent(double e) const { return piece(e).slope; }
  double work(double e0, double e1) const;  // ∫ f de from e0 to e1 [J], exact
  // Mean of f over [e0, e1], work/(e1 − e0), and its derivative by e1: the force that conserves energy.
  SpringAnswer mean(double e0, double e1) const;
  bool operator==(const Curve&) const = default;
};

Curve linear(double stiffness);                 // f = k e
Curve cable(double stiffness, double slack);    // f = k (e − slack) for e > slack, else 0
Curve key(double stiffness, double clearance);  // f = k (|e| − clearance) beyond the clearance, either way

// A gasket that carries compression only. `compression` is its load curve (compression [m] from 0, force [N]
// per metre of gasket, both positive here; the last slope continues beyond the last point). In the installed
// state it is compressed by the force `pre_compression` [N per metre of gasket], which balances the outside
// pressure. The elongation e and the force f count from this state: f(0) = 0, and f = +pre_compression,
// constant, once the gasket has lost contact.
Curve gasket(const std::vector<CurvePoint>& compression, double pre_compression);

// The compression [m] at which the load curve carries `force`.
double compression_under(const std::vector<CurvePoint>& compression, double force);

// Both throw UserError at path[i] if the table is not monotone. A load curve must also start at (0, 0) and
// rise everywhere.
void check(const Curve& curve, const std::string& path);
void check_load_curve(const std::vector<CurvePoint>& compression, const std::string& path);

}  // namespace adit::simplified::beam
