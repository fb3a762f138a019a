// Linear interpolation along the chainage, constant beyond the ends.
#pragma once

namespace adit::simplified {

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

}  // namespace adit::simplified
