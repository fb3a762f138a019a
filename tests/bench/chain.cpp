// The cost of the chain's step over its size: chain STEPS prints one JSON object a size, from 100 to 100,000
// bodies: {"bodies", "sweep_ns", "direct_ns", "difference"}; nanoseconds for each body and step of the
// Riccati sweep and of Eigen's sparse LDL^T.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/support/chain/sweep_cost.hpp"

int main(int argc, char** argv) {
  const long steps = argc == 2 ? std::atol(argv[1]) : 0;
  if (steps < 1) {
    std::fprintf(stderr, "usage: chain STEPS\n");
    return 2;
  }
  for (const std::size_t bodies : {100, 300, 1000, 3000, 10'000, 30'000, 100'000}) {
    const auto cost = adit::simplified::chain::test::sweep_cost(bodies, steps);
    std::cout << nlohmann::json{{"bodies", cost.bodies},
                                {"sweep_ns", cost.sweep_ns()},
                                {"direct_ns", cost.direct_ns()},
                                {"difference", cost.relative_difference}}
              << std::endl;
  }
}
