// A face that points slide along in large strain: sides of zones in order, with the other face on their left.
//
// The normal at a point of a side is between those at its ends, and these are the means of the sides' that
// meet there, by length, but at corners: a polygon that stands for a curve is then as smooth as the curve,
// and where points lie opposite each other the normal is that of small strain (contacts.hpp). A corner
// belongs to the nearest side.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace adit::fdm {

class Face {
 public:
  // At least one side, each from its first point to its second. They meet in a corner where the cosine of the
  // angle between their directions is not above this one.
  Face(std::vector<std::array<std::uint32_t, 2>> sides, double corner)
      : sides_(std::move(sides)), corner_(corner) {}

  // Present places of the grid's points [m].
  struct Places {
    std::span<const double> x, y, ux, uy;

    std::array<double, 2> operator()(std::uint32_t point) const {
      return {x[point] + ux[point], y[point] + uy[point]};
    }
  };
  // Where a point lies opposite the face.
  struct Foot {
    std::uint32_t side;
    double xi;      // share of the way along the side
    double nx, ny;  // the normal, to the left
    double height;  // of the point above the face along the normal [m], negative below it
  };
  // Nothing where the point is past an end of the face. Looks along the face from this side on, if one is
  // given, to where no neighbour is nearer; else at all sides.
  std::optional<Foot> foot(std::uint32_t point, std::optional<std::uint32_t> from,
                           const Places& places) const;

  std::size_t size() const { return sides_.size(); }
  const std::array<std::uint32_t, 2>& side(std::uint32_t number) const { return sides_[number]; }

 private:
  struct Projection {
    double xi, square;  // not within [0, 1] past the ends; square of the distance to the side [m^2]
  };
  std::array<double, 2> across(std::uint32_t side,
                               const Places& places) const;  // the left normal times length
  Projection project(const std::array<double, 2>& at, std::uint32_t side, const Places& places) const;
  bool has(std::uint32_t side, std::uint32_t point) const {
    return sides_[side][0] == point || sides_[side][1] == point;
  }
  // That which goes on at this end of a side.
  std::optional<std::uint32_t> neighbour(std::uint32_t side, std::size_t end) const;
  std::array<double, 2> normal_at(std::uint32_t side, std::size_t end, const Places& places) const;

  std::vector<std::array<std::uint32_t, 2>> sides_;
  double corner_;
};

}  // namespace adit::fdm
