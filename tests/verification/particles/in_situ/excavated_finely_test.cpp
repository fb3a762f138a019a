// Requirement: the finer the lattice, the nearer the tunnel to Kirsch's; with 33 discs in its radius within 3
// %.
#include <gtest/gtest.h>

#include "tests/verification/particles/in_situ/excavated.hpp"

namespace adit::excavated_finely_test {
namespace {

TEST(FinelyExcavatedParticles, DeformAsKirschFound) {
  constexpr double kDisc = 0.045;
  test::Settled settled(test::tunnel_in_lattice(kDisc, test::excavation("", 1) + test::kHoop));
  test::expect_kirsch(settled, kDisc, 0.03, 0.03);
}

}  // namespace
}  // namespace adit::excavated_finely_test
