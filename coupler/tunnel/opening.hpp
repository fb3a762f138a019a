// The zones around a tunnel's opening and in it, which lead from a rectangle of equal zones to its outline.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupler/tunnel/contour.hpp"
#include "coupler/tunnel/host_block.hpp"

namespace adit::coupler {

// Every side of a zone on the rectangle faces one on the outline. Those of a circle are equal; walls and arch
// of a horseshoe share theirs by length; a box has as many over its width and height as the rectangle.
// Offsets are those of Contour.
class Opening {
 public:
  // The rectangle is what the zones hold; it lies around the outline at every offset in use.
  Opening(const scene::LinedTunnel& tunnel, const Contour& contour, const HostBlock& host,
          const ZoneRange& zones);

  geometry::BoundingBox extent() const;       // of the rectangle
  std::size_t size() const { return size_; }  // nodes on an outline, and sides of zones between them
  double side(double offset) const;           // their mean length [m]

  // On the outline, counter-clockwise.
  std::vector<geometry::Point> nodes(double offset) const;
  // The outline as a closed path along sides of zones, counter-clockwise.
  scene::LiningPath path(double offset) const;

  // Between two outlines.
  std::vector<scene::GridBlock> ring(double inner, double outer, std::uint32_t across) const;
  // From an outline to the rectangle, in zones that grow to those of the block.
  std::vector<scene::GridBlock> surroundings(double offset) const;
  // Inside an outline: of a circle or a horseshoe a core, and a ring around it.
  std::vector<scene::GridBlock> inside(double offset) const;

 private:
  struct End {
    bool on_arc;
    double angle = 0;       // from x
    int right = 0, up = 0;  // if it is not on the arc: Contour::wall_end
  };
  // A part of the outline, straight or an arc, that faces some of the zones along one side of the rectangle,
  // counter-clockwise. The rectangle's sides count from the right one, and so do their first corners.
  struct Part {
    End from, to;
    std::size_t facing;
    std::uint32_t first, zones;
    bool is_arc() const { return from.on_arc && to.on_arc; }
  };
  using Corners = std::array<geometry::Point, 4>;

  std::uint32_t along(std::size_t side) const;  // zones along a side of the rectangle
  std::vector<Part> parts_of(const scene::LinedTunnel& tunnel) const;
  std::vector<Part> parts_of_circle() const;
  std::vector<Part> parts_of_horseshoe() const;
  std::vector<Part> parts_of_box() const;

  geometry::Point place(const End& end, double offset) const;
  // The ends of a part on the side that it faces of a quadrilateral.
  std::array<geometry::Point, 2> faced(const Part& part, const Corners& corners) const;
  // From the outline to a quadrilateral around it or inside it, in the mean [m].
  double distance(const Corners& corners, double offset) const;
  Corners core(double offset) const;
  void add_arc(const Part& part, scene::Arc::Side side, scene::Quadrilateral& shape) const;

  Contour contour_;
  ZoneRange zones_;
  Corners rectangle_;
  double zone_width_, zone_height_;  // of the block [m]
  std::vector<Part> parts_;
  std::size_t size_ = 0;
};

}  // namespace adit::coupler
