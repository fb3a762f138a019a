// The backbone as straight pieces, and where a strain lies on it.
//
// Piece j ends at vertex x_j. By elements that yield at the vertices (iwan_elements.hpp), of the
// stiffnesses G_i over the initial modulus, a strain g on it leaves
//   slope      H = sum of G_i that have not yielded,
//   intercept  S = sum of G_i x_i that have,     so that the stress is S + H g,
//   moment     Q = sum of G_i x_i^2 that have,   so that the energy that they store is Q/2.
// The damping ratio of a closed loop between -g and g is by Masing's rules 2 (S g - Q)/(pi g (S + H g)).
//
// A loop that is narrower by a share F keeps its tips: F times the loop and 1 - F times the line between them
// (Phillips & Hashash 2009, Soil Dyn. Earthq. Eng. 29). F is a straight line of g on each piece.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/hysteresis/modulus_reduction.hpp"

namespace adit::fdm {

// Tables of a polyline, for kernels.
struct PolylineView {
  // Where a strain lies follows from the leading bits of its number, which divide every octave of strains
  // into equal cells; no cell holds two vertices.
  const std::int64_t* first_piece;  // of each cell
  std::int64_t first_cell, last_cell;
  std::int32_t shift;
  const double *end, *slope, *intercept, *moment;  // of each piece
  const double *share, *share_slope;               // F = share + share_slope g

  // Of a strain >= 0.
  [[gnu::always_inline]] std::int64_t piece(double strain) const {
    auto cell = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(strain) >> shift) - first_cell;
    cell = cell < 0 ? 0 : cell;
    cell = cell > last_cell ? last_cell : cell;
    const std::int64_t first = first_piece[cell];
    return first + (strain > end[first] ? 1 : 0);
  }
};

class Polyline {
 public:
  explicit Polyline(std::vector<BackbonePoint> backbone);

  std::span<const BackbonePoint> backbone() const { return backbone_; }
  double stress(double shear_strain) const;  // over the initial modulus
  double masing_damping(double shear_strain) const;
  double damping(double shear_strain) const { return share(shear_strain) * masing_damping(shear_strain); }

  // The share of Masing's damping that loops of an amplitude keep, 0 < share <= 1, at the vertices. Throws
  // protocol::UserError with `path` where it falls so fast that first loading would give back energy.
  void narrow(const std::function<double(double shear_strain)>& share, const std::string& path);
  bool narrowed() const { return narrowed_; }
  double share(double shear_strain) const;

  PolylineView view() const {
    return {first_piece_.data(), first_cell_,       last_cell_,     shift_,        end_.data(),
            slope_.data(),       intercept_.data(), moment_.data(), share_.data(), share_slope_.data()};
  }

 private:
  void divide_into_cells();

  std::vector<BackbonePoint> backbone_;
  std::vector<double> end_, slope_, intercept_, moment_, share_, share_slope_;
  std::vector<std::int64_t> first_piece_;
  std::int64_t first_cell_ = 0, last_cell_ = 0;
  std::int32_t shift_ = 0;
  bool narrowed_ = false;
};

}  // namespace adit::fdm
