#include "coupler/bridging/overlap_notes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "coupler/bridging/presence.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::coupler {
namespace {

constexpr double kContrast = 3;

// The eighth nearest sample of a grid of squares lies half a diagonal of a zone away (presence.hpp).
constexpr double kZoneOverSpacing = std::numbers::sqrt2;

// Young's modulus of a model by place; none where the scene does not tell it.
class Stiffness {
 public:
  explicit Stiffness(const scene::Scene& part) : part_(part) {
    for (const auto& area : part.continuum().materials()) add(area.where(), &area.material());
    for (const auto& group : part.particles().groups()) {
      if (!group.has_where()) continue;
      add(group.where(), given_by_bonds(group.has_bonds() ? group.bonds() : part.particles().bonds())
                             ? nullptr
                         : group.has_material() ? &group.material()
                                                : own());
    }
  }

  std::optional<double> at(double x, double y) const {
    const scene::Material* material = given_by_bonds(part_.particles().bonds()) ? nullptr : own();
    for (const auto& [places, other] : others_)
      if (places.hold(x, y)) material = other;
    return material ? std::optional(material->young_modulus()) : std::nullopt;
  }

 private:
  static bool given_by_bonds(const scene::Bonds& bonds) {
    return bonds.has_normal_stiffness() || bonds.has_parallel();
  }

  const scene::Material* own() const {
    if (part_.continuum().has_material()) return &part_.continuum().material();
    return part_.particles().has_material() ? &part_.particles().material() : &part_.material();
  }

  void add(const scene::Area& where, const scene::Material* material) {
    if (!where.has_group()) others_.emplace_back(protocol::Places(where, "where", 0), material);
  }

  const scene::Scene& part_;
  std::vector<std::pair<protocol::Places, const scene::Material*>> others_;
};

std::string narrow_note(const Overlap& overlap, const Side& side) {
  if (!side.part.has_continuum()) return {};
  const Presence model(side.samples);
  double zone = 0;
  for (std::size_t i = 0; i + 1 < side.samples.size(); i += 2)
    if (const double x = side.samples[i], y = side.samples[i + 1]; overlap.contains(x, y)) {
      const double size = kZoneOverSpacing * model.spacing(x, y);
      if (zone == 0 || size < zone) zone = size;
    }
  if (overlap.width() >= (1 - 1e-6) * zone) return {};
  return fmt::format(
      "{}.overlap is {:.3g} m wide, less than a zone of `{}` there ({:.3g} m); two zones or more carry "
      "waves better",
      overlap.path(), overlap.width(), side.name, zone);
}

std::string contrast_note(const Overlap& overlap, const Side& outer, const Side& inner) {
  const Stiffness outside(outer.part), inside(inner.part);
  double largest = kContrast;
  std::string note;
  for (std::size_t i = 0; i + 1 < inner.samples.size(); i += 2) {
    const double x = inner.samples[i], y = inner.samples[i + 1];
    if (!overlap.contains(x, y)) continue;
    const auto one = outside.at(x, y), other = inside.at(x, y);
    if (!one || !other) continue;
    const double contrast = std::max(*one / *other, *other / *one);
    if (contrast <= largest) continue;
    largest = contrast;
    note = fmt::format(
        "{}.overlap lies at ({:.4g}, {:.4g}) m between {:.4g} GPa of `{}` and {:.4g} GPa of `{}`; lay "
        "it through ground that both model alike, outside a lining",
        overlap.path(), x, y, *one / 1e9, outer.name, *other / 1e9, inner.name);
  }
  return note;
}

}  // namespace

std::vector<std::string> overlap_notes(const Overlap& overlap, const Side& outer, const Side& inner) {
  std::vector<std::string> notes{narrow_note(overlap, outer), narrow_note(overlap, inner),
                                 contrast_note(overlap, outer, inner)};
  std::erase(notes, "");
  return notes;
}

}  // namespace adit::coupler
