#include "simplified/output/response.hpp"

#include <algorithm>
#include <cmath>

namespace adit::simplified {

Peak peak(const std::vector<double>& chainage, const Envelope& envelope) {
  Peak peak;
  for (std::size_t i = 0; i < chainage.size(); ++i) {
    const double value = std::max(std::abs(envelope.least[i]), std::abs(envelope.greatest[i]));
    if (value > peak.value) peak = {chainage[i], value};
  }
  return peak;
}

const Envelope* find(const Response& response, const std::string& name) {
  for (const Envelope& envelope : response.envelopes)
    if (envelope.name == name) return &envelope;
  return nullptr;
}

}  // namespace adit::simplified
