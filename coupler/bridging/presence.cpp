#include "coupler/bridging/presence.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

namespace adit::coupler {
namespace {

namespace index = boost::geometry::index;
using Place = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Place>;

constexpr double kReach = 1.5;  // of the local spacing
constexpr unsigned kNeighbours = 8;
constexpr unsigned kAround = 32;  // samples, one of which belongs to the zone around a place, if one does
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Place> places_of(std::span<const double> samples) {
  std::vector<Place> places;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2) places.emplace_back(samples[i], samples[i + 1]);
  return places;
}

}  // namespace

struct Presence::Tree : index::rtree<Place, index::quadratic<16>> {
  using rtree::rtree;

  Place nearest(const Place& place) const {
    Place found;
    query(index::nearest(place, 1), &found);
    return found;
  }

  // The sample itself is the first of those that are found.
  double spacing_at(const Place& sample) const {
    std::vector<Place> found;
    query(index::nearest(sample, kNeighbours + 1), std::back_inserter(found));
    double farthest = 0;
    for (const Place& other : found) farthest = std::max(farthest, boost::geometry::distance(sample, other));
    return farthest;
  }

  bool reaches(const Place& sample, const Place& place) const {
    return boost::geometry::distance(place, sample) <= kReach * spacing_at(sample);
  }

  // Not always by the nearest sample, which in a graded grid may belong to a smaller zone beside that of the
  // place.
  bool is_reached(const Place& place) const {
    if (reaches(nearest(place), place)) return true;
    std::vector<Place> around;
    query(index::nearest(place, kAround), std::back_inserter(around));
    return std::ranges::any_of(around, [&](const Place& sample) { return reaches(sample, place); });
  }

  bool is_in(const Box& box) const { return qbegin(index::intersects(box)) != qend(); }
};

Presence::Presence(std::span<const double> samples)
    : tree_(std::make_unique<const Tree>(places_of(samples))) {}

Presence::~Presence() = default;

bool Presence::is_nowhere() const {
  return tree_->empty();
}

double Presence::gap(double x, double y, double slack) const {
  if (is_nowhere()) return kInfinity;
  const Place place(x, y), nearest = tree_->nearest(place);
  const double distance = boost::geometry::distance(place, nearest);
  return distance <= slack || tree_->is_reached(place) ? 0 : distance;
}

bool Presence::surrounds(double x, double y) const {
  if (is_nowhere()) return false;
  const double half = kReach * spacing(x, y);  // of a strip that no row or column of samples slips through
  return tree_->is_in({{-kInfinity, y - half}, {x, y + half}}) &&
         tree_->is_in({{x, y - half}, {kInfinity, y + half}}) &&
         tree_->is_in({{x - half, -kInfinity}, {x + half, y}}) &&
         tree_->is_in({{x - half, y}, {x + half, kInfinity}});
}

double Presence::size(double x, double y) const {
  return std::numbers::sqrt2 * spacing(x, y);
}

double Presence::spacing(double x, double y) const {
  return tree_->spacing_at(tree_->nearest({x, y}));
}

}  // namespace adit::coupler
