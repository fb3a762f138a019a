// Requirements on curves of modulus reduction: tables are followed, also uneven ones.
#include "fdm_server/hysteresis/modulus_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fdm_server/hysteresis/polyline.hpp"

namespace adit::fdm::test::modulus_reduction_test {
namespace {

// A measured table: monotone between its points, through them, and followed by the backbone within 1 % of the
// strength where the curve itself does not stiffen.
TEST(ModulusReduction, TableIsFollowed) {
  const std::vector<double> strain{1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
  const std::vector<double> ratio{1, 0.985, 0.945, 0.83, 0.61, 0.33, 0.15, 0.06};
  const auto curve = smooth_table(strain, ratio);
  for (std::size_t i = 0; i < strain.size(); ++i) EXPECT_NEAR(curve(strain[i]), ratio[i], 1e-12);
  double last = 1;
  for (double x = 1e-6; x < 1e-2; x *= 1.01) {
    EXPECT_LE(curve(x), last + 1e-12);
    last = curve(x);
  }
  const Polyline line(backbone(curve, 1e-6, 1e-2, 32));
  for (const double x : {2e-5, 1e-4, 2e-4, 1e-3, 3e-3, 1e-2})
    EXPECT_NEAR(line.stress(x) / x, curve(x), 0.012 * curve(x)) << x;
}

// The largest error of a table of a hyperbola whose points lie unevenly over the logarithm of the strain.
double error_of_uneven_table(double step) {
  const auto exact = hyperbola(1e-3, 1);
  std::vector<double> strain{1e-5}, ratio{exact(1e-5)};
  for (bool wide = true; strain.back() < 0.1; wide = !wide) {
    strain.push_back(strain.back() * std::exp(wide ? step : step / 4));
    ratio.push_back(exact(strain.back()));
  }
  const auto curve = smooth_table(strain, ratio);
  double largest = 0;
  for (double x = 2e-4; x < 5e-3; x *= 1.01) largest = std::max(largest, std::abs(curve(x) - exact(x)));
  return largest;
}

// Uneven points leave the table as accurate as its slopes are: at most half of what chords that are weighed
// the wrong way round would give, which is 1.5e-3 and 3.8e-4.
TEST(ModulusReduction, UnevenTableFollowsItsCurve) {
  EXPECT_LT(error_of_uneven_table(0.5), 8e-4);
  EXPECT_LT(error_of_uneven_table(0.25), 2e-4);
}

}  // namespace
}  // namespace adit::fdm::test::modulus_reduction_test
