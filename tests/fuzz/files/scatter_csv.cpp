// Factors from place to place, as a table: none of them is 0 anywhere.
#include <stdexcept>

#include "protocol/scatter/factor_field.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kScatterCsv("scatter_csv", [](std::string_view input) {
  read_or_refuse([&] {
    const protocol::FactorField field("field.csv", std::string(input));
    for (const double at : {-1.0, 0.3, 1e9})
      if (!(field.at(at, at) > 0)) throw std::logic_error("a factor is not above 0");
  });
});

}  // namespace
}  // namespace adit::fuzz
