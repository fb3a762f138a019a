// Interpolates values that are known at places along the tunnel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace adit::simplified {

// The natural cubic spline through the values at the places. A tunnel that follows the ground has the
// curvature of the ground, which must therefore be continuous; straight lines would have curvature at the
// places only. For a wave of wave number q [rad/m] and places h apart, the relative error of the curvature is
// at most (q h)^2/12, that of the displacement 5/384 (q h)^4 (Hall and Meyer 1976).
class AlongChainage {
 public:
  // `places` ascend, and there are at least two. Beyond them the values of the first and the last place hold.
  AlongChainage(const std::vector<double>& places, const std::vector<double>& chainages);

  // Sets to[i] to the value at chainage i, from one value for each place.
  void interpolate(const double* values, double* to);
  // The same along straight lines, for values that must not leave the range of those at the places.
  void interpolate_linearly(const double* values, double* to) const;

 private:
  // The value between the places k and k + 1 is a v_k + b v_k+1 + c v''_k + d v''_k+1.
  struct Point {
    std::size_t before;
    double a, b, c, d;
  };
  void find_curvatures(const double* values);

  std::vector<double> gaps_;    // distances between the places [m]
  std::vector<double> pivots_;  // inverse pivots of the equations for the curvatures
  std::vector<double> curvatures_;
  std::vector<Point> points_;
};

// Linear interpolation along the chainage, constant beyond the ends.
// The two elements of a list between which a chainage lies, and its position between them, from 0 to 1.
struct Bracket {
  int before;
  int after;
  double share;  // in [0, 1]
  double blend(double a, double b) const { return a + share * (b - a); }
};

// `list` holds at least one message; their chainages ascend.
template <class List>
Bracket bracket(const List& list, double chainage) {
  int after = 0;
  while (after < static_cast<int>(list.size()) && list[after].chainage() < chainage) ++after;
  if (after == 0) return {0, 0, 0};
  if (after == static_cast<int>(list.size())) return {after - 1, after - 1, 0};
  const double begin = list[after - 1].chainage(), end = list[after].chainage();
  return {after - 1, after, (chainage - begin) / (end - begin)};
}

// The number of the nearest place; there is at least one, and they may stand in any order.
inline std::size_t nearest(const std::vector<double>& places, double chainage) {
  const auto closer = [chainage](double a, double b) {
    return std::abs(a - chainage) < std::abs(b - chainage);
  };
  return static_cast<std::size_t>(std::ranges::min_element(places, closer) - places.begin());
}

}  // namespace adit::simplified
