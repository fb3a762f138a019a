// Linear interpolation along the chainage, constant beyond the ends.
#pragma once

namespace adit::simplified {

// Between which two elements of a list a chainage lies, and how far it is from the first to the second.
struct Bracket {
  int before;
  int after;
  double share;  // in [0, 1]
  double blend(double a, double b) const { return a + share * (b - a); }
};

// `list`: messages with a chainage, ascending, at least one.
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
