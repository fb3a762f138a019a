// Discs centred on a face, which keep all nuclei out but those beside the face.
#pragma once

#include <vector>

#include "protocol/geometry/cells.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

struct CoverDisc {
  geometry::Point centre;
  double radius;  // [m]
};

// The discs that cover a face, in order along it; consecutive ones overlap. In a closed cover the first
// follows the last.
struct FaceCover {
  std::vector<CoverDisc> discs;
  bool closed;
};

// Discs sorted by place. A nucleus on the edge of a disc, within rounding, does not lie in it.
class DiscField {
 public:
  explicit DiscField(std::vector<CoverDisc> discs);
  bool hold(const geometry::Point& point) const;
  // Whether one of the discs holds the whole box.
  bool cover(const geometry::BoundingBox& box) const;

 private:
  std::vector<CoverDisc> discs_;
  protocol::Cells cells_;
};

}  // namespace adit::dem
