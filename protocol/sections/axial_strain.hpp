// The strain at the axis for which a section carries a given thrust at a given curvature.
#pragma once

namespace adit::sections {

// `thrust(strain)`: rises with the strain, at least on the whole. Looks around `guess` first; after bisection
// the strain is known to rounding.
template <class Thrust>
double axial_strain(Thrust&& thrust, double wanted, double guess) {
  double low = guess, high = guess;
  for (double reach = 1e-5; thrust(low) > wanted && reach < 1; reach *= 2) low = guess - reach;
  for (double reach = 1e-5; thrust(high) < wanted && reach < 1; reach *= 2) high = guess + reach;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (thrust(middle) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace adit::sections
