#include "fdm_server/hysteresis/polyline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::fdm {

Polyline::Polyline(std::vector<BackbonePoint> backbone)
    : backbone_(std::move(backbone)), share_(backbone_.size() + 1, 1.0), share_slope_(share_.size(), 0.0) {
  double slope = 1, intercept = 0, moment = 0;
  for (std::size_t k = 0; k <= backbone_.size(); ++k) {
    const bool last = k == backbone_.size();
    end_.push_back(last ? std::numeric_limits<double>::infinity() : backbone_[k].strain);
    slope_.push_back(slope);
    intercept_.push_back(intercept);
    moment_.push_back(moment);
    if (last) break;
    const auto& [strain, stress] = backbone_[k];
    const double next = k + 1 < backbone_.size()
                            ? (backbone_[k + 1].stress - stress) / (backbone_[k + 1].strain - strain)
                            : 0;
    const double stiffness = slope - next;  // of the element that yields here
    intercept += stiffness * strain;
    moment += stiffness * strain * strain;
    slope = next;
  }
  divide_into_cells();
}

void Polyline::divide_into_cells() {
  const auto cell = [&](double strain) { return std::bit_cast<std::int64_t>(strain) >> shift_; };
  const auto shared = [&](const BackbonePoint& a, const BackbonePoint& b) {
    return cell(a.strain) == cell(b.strain);
  };
  constexpr int kMantissa = 52;
  for (shift_ = kMantissa; shift_ > 0 && std::ranges::adjacent_find(backbone_, shared) != backbone_.end();)
    --shift_;
  first_cell_ = cell(backbone_.front().strain);
  last_cell_ = cell(backbone_.back().strain) - first_cell_;
  first_piece_.clear();
  std::int64_t piece = 0;
  for (std::int64_t c = 0; c <= last_cell_; ++c) {
    first_piece_.push_back(piece);
    const bool holds_one = cell(backbone_[static_cast<std::size_t>(piece)].strain) == first_cell_ + c;
    piece += holds_one ? 1 : 0;
  }
}

double Polyline::stress(double strain) const {
  const auto piece = static_cast<std::size_t>(view().piece(strain));
  return intercept_[piece] + slope_[piece] * strain;
}

double Polyline::masing_damping(double strain) const {
  const auto piece = static_cast<std::size_t>(view().piece(strain));
  return 2 / std::numbers::pi * (intercept_[piece] * strain - moment_[piece]) / (strain * stress(strain));
}

double Polyline::share(double strain) const {
  const auto piece = static_cast<std::size_t>(view().piece(strain));
  return share_[piece] + share_slope_[piece] * strain;
}

void Polyline::narrow(const std::function<double(double)>& share, const std::string& path) {
  narrowed_ = true;
  // Below the second vertex there are no loops that could tell.
  std::vector<double> at;
  for (std::size_t k = 0; k < backbone_.size(); ++k)
    at.push_back(share(backbone_[k == 0 && backbone_.size() > 1 ? 1 : k].strain));
  share_[0] = at[0];
  for (std::size_t j = 1; j < backbone_.size(); ++j) {
    const double from = backbone_[j - 1].strain, to = backbone_[j].strain;
    share_slope_[j] = (at[j] - at[j - 1]) / (to - from);
    share_[j] = at[j - 1] - share_slope_[j] * from;
    // First loading dissipates ((1 + F) S + F' (S g - Q))/2 for a unit of strain (reversals.hpp).
    for (const double strain : {from, to})
      if ((1 + share_[j] + share_slope_[j] * strain) * intercept_[j] +
              share_slope_[j] * (intercept_[j] * strain - moment_[j]) <
          0)
        throw protocol::UserError(
            path,
            fmt::format("falls so fast at the strain {:.3g} that the ground would give back more energy "
                        "than it took; let it fall over a wider range of strains",
                        strain));
  }
  share_.back() = at.back();
}

}  // namespace adit::fdm
