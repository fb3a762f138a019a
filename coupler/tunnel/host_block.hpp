// A rectangle of equal zones of the continuum in which tunnels lie, and what remains of it around them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Zones between lines of the block, which count from its left and lower sides.
struct ZoneRange {
  std::uint32_t left, right, lower, upper;
};

class HostBlock {
 public:
  // The `block` of the continuum, or the first of its `blocks` that is a rectangle of equal zones around the
  // box. Throws protocol::UserError at `path`, of the tunnel, where there is none.
  static HostBlock around(const geometry::BoundingBox& box, const scene::Continuum& continuum,
                          const std::string& path);

  int number() const { return number_; }  // of the `blocks`; -1: it is the `block`
  double x(std::uint32_t line) const;     // [m]
  double y(std::uint32_t line) const;
  double zone_width() const { return (box_.x_max - box_.x_min) / columns_; }
  double zone_height() const { return (box_.y_max - box_.y_min) / rows_; }

  // The zones that hold the box, or the part of it that lies in the block.
  ZoneRange zones_around(const geometry::BoundingBox& box) const;

  // Takes zones out of it. Throws protocol::UserError at `path` if some were taken out for another tunnel,
  // whose path it tells.
  void take(const ZoneRange& zones, const std::string& path);

  // Rectangles of what remains, which share the lines of all that was taken.
  std::vector<scene::GridBlock> remains() const;

  const std::string& group() const { return group_; }

 private:
  HostBlock(int number, std::string group, const geometry::BoundingBox& box, std::uint32_t columns,
            std::uint32_t rows)
      : number_(number), group_(std::move(group)), box_(box), columns_(columns), rows_(rows) {}

  scene::GridBlock rectangle(const ZoneRange& zones) const;

  int number_;
  std::string group_;
  geometry::BoundingBox box_;
  std::uint32_t columns_, rows_;
  struct Taken {
    ZoneRange zones;
    std::string path;
  };
  std::vector<Taken> taken_;
};

}  // namespace adit::coupler
