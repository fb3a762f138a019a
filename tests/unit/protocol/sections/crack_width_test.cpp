// Requirements on crack widths: EN 1992-1-1, 7.3.4, worked by hand.
#include "protocol/sections/crack_width.hpp"

#include <gtest/gtest.h>

namespace adit::sections::test::crack_width_test {
namespace {

// b = 400, h = 600, d = 548 mm, 6 bars of 24 mm (2714 mm^2), c = 40 mm, C30/37: the section of example 7.3 of
// the Eurocode 2 Worked Examples (European Concrete Platform, 2008).
const CrackedFace kFace{0.6, 0.4, 2714e-6, 0.024, 0.04, 0.548, 200e9, 33e9, 2.9e6};

// x = 200 mm: h_c,eff = min(130, 133.3, 300) = 130 mm, rho = 2714/(400 x 130) = 0.05219,
// s_r,max = 136 + 0.17 x 24/0.05219 = 214.2 mm; sigma_s = 240 MPa, alpha_e = 6.0606:
// 240 - 0.6 x 2.9/0.05219 x (1 + 0.31631) = 196.1 MPa, w = 214.2 x 196.1/200000 = 0.2100 mm.
TEST(CrackWidth, InBending) {
  EXPECT_NEAR(crack_width(kFace, 240e6, 2e-3, -1e-3), 0.2100e-3, 0.0002e-3);
}

// All in tension, uniformly: k_2 = 1, h - x = h: h_c,eff = 130 mm; s_r,max = 136 + 0.34 x 24/0.05219 = 292.4
// mm.
TEST(CrackWidth, InTension) {
  EXPECT_NEAR(crack_width(kFace, 240e6, 1e-3, 1e-3), 0.2924 * 196.1 / 200e3, 0.0003e-3);
}

// The less stretched face of a section all in tension: eps_1 is that of the other face, k_2 = 3/4.
TEST(CrackWidth, AtTheLessStretchedFace) {
  EXPECT_NEAR(crack_width(kFace, 240e6, 1e-3, 2e-3), (0.136 + 0.255 * 0.024 / 0.05219) * 196.1 / 200e3,
              0.0003e-3);
}

// Small stresses: at least 0.6 sigma_s/E_s. Bars far apart: 1.3 (h - x). Compression, or no crack yet: none.
TEST(CrackWidth, Limits) {
  EXPECT_NEAR(crack_width(kFace, 50e6, 2e-3, -1e-3), 0.2142 * 0.6 * 50 / 200e3, 0.0001e-3);
  CrackedFace sparse = kFace;
  sparse.area = 452e-6;  // one bar in 400 mm
  EXPECT_NEAR(crack_width(sparse, 400e6, 2e-3, -1e-3), 1.3 * 0.4 * 0.6 * 400 / 200e3, 0.3e-3);
  EXPECT_EQ(crack_width(kFace, -1e6, -1e-3, 1e-3), 0);
  EXPECT_EQ(crack_width(kFace, 1e6, -1e-3, -2e-3), 0);
  EXPECT_EQ(crack_width(kFace, 10e6, 0.05e-3, -1e-3), 0);  // not cracked
}

}  // namespace
}  // namespace adit::sections::test::crack_width_test
