#include "simplified/benchmark.hpp"

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "simplified/chain/benchmark.hpp"

namespace adit::simplified {

void time_chain(long steps) {
  for (const std::size_t bodies : {100, 300, 1000, 3000, 10'000, 30'000, 100'000}) {
    const chain::BenchmarkResult result = chain::benchmark(bodies, steps);
    std::cout << nlohmann::json{{"bodies", result.bodies},
                                {"sweep_ns", result.sweep_ns()},
                                {"direct_ns", result.direct_ns()},
                                {"difference", result.relative_difference}}
              << std::endl;
  }
}

}  // namespace adit::simplified
