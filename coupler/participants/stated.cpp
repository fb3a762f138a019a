#include "coupler/participants/stated.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <utility>

namespace adit::coupler {
namespace {

constexpr double kNegligible = 0.01, kLittle = 0.05;  // shares of what is stated

bool differs(const Stated& one, double share) {
  return std::abs(one.acted - one.stated) > share * std::abs(one.stated);
}

}  // namespace

void add_where_it_differs(std::vector<Stated>& list, Stated one) {
  if (differs(one, kNegligible)) list.push_back(std::move(one));
}

std::vector<std::string> warnings_of(const std::vector<Stated>& list) {
  std::vector<std::string> warnings;
  for (const auto& one : list) {
    const std::string unit = one.unit.empty() ? "" : " " + one.unit;
    if (!one.why.empty() && differs(one, kLittle))
      warnings.push_back(fmt::format("`{}` is stated as {:.6g}{}, but {:.6g}{} acts: {}", one.key, one.stated,
                                     unit, one.acted, unit, one.why));
  }
  return warnings;
}

}  // namespace adit::coupler
