// Cells that touch others than those to which a facet joins them: pieces of a broken body that meet, as the
// polygons that they are.
//
// The contact's normal spring stores k a^2 / 2 s^2, a being the common area (polygons/overlap.hpp), k the
// stiffness of the contact and s the side of a regular hexagon as large as the cells: two sides of this
// length that press on each other flatly are a spring k. In the terms of laws/linear_contact.hpp its gap is
// -a / b and its stiffness k b^2 / s^2, b being the chord. Shear, friction and dashpots are that law's, at
// the place where the normal force acts.
//
// Only cells of which some side is free can touch: on the outside, or beside a facet that has cracked. They
// are listed by pairs that are near each other, anew where one of them may have come so far that the list
// lacks a pair. What cells have in common as they are listed for the first time bears nothing. Two cells that
// slide along smooth joints are left to these, wherever they slide, unless a facet between them has parted.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/engines/general/facets/facet_set.hpp"
#include "dem_server/engines/general/forces/touch.hpp"
#include "dem_server/engines/general/polygons/cell_polygons.hpp"
#include "dem_server/engines/general/polygons/overlap.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class CellContacts {
 public:
  struct Contact {
    std::uint32_t first, second;  // ascending
    double free_area = 0;         // in common ever since they were listed, which bears nothing [m^2]
    Touch touch{};
  };

  CellContacts() = default;
  CellContacts(const Model& model, const FacetSet& facets, const Particles& particles);
  bool empty() const { return polygons_.empty(); }

  // A step moved the cells, and walls by at most `farthest_wall` [m]. Returns whether the list became another
  // one.
  bool update(double dt, double farthest_wall, const FacetSet& facets, const Particles& particles);
  // Facets have cracked or parted, so that more cells may touch.
  void expose_more() { stale_ = true; }
  void begin_stage(const Model& model, const std::vector<bool>& fresh, const FacetSet& facets,
                   const Particles& particles);

  // Adds the forces to the resultants, from velocities at n - 1/2, and accounts them.
  void add_forces(const protocol::Step& step, const FacetSet& facets, Particles& particles);

  std::span<const Contact> contacts() const { return contacts_; }  // that touch or may do so soon
  // None where the two have nothing in common that bears.
  std::optional<Encounter> encounter(const Contact& contact, const FacetSet& facets,
                                     const Particles& particles) const;
  double weight(const Contact& contact, const Particles& particles) const;
  const CellPolygons& polygons() const { return polygons_; }
  double skin() const { return skin_; }           // how near cells are that are listed [m]
  std::uint64_t lists() const { return lists_; }  // made so far

  double strain_energy(const Particles& particles) const;
  double friction() const { return friction_; }  // dissipated since the start, weighted [J]
  double dashpots() const { return dashpots_; }
  void start_over() { friction_ = dashpots_ = 0; }
  void exchange(state::Archive& archive);

 private:
  void take_stage(const Model& model);
  void expose(const FacetSet& facets, const Particles& particles);
  // Returns which contacts the earlier list had, too.
  std::vector<bool> list(const FacetSet& facets, const Particles& particles);
  void free_what_is_common(const std::vector<bool>& kept, const FacetSet& facets, const Particles& particles);
  std::optional<Encounter> encounter(const Contact& contact, const Overlap& common,
                                     const Particles& particles) const;
  Overlap overlap(const Contact& contact, const FacetSet& facets, const Particles& particles) const;
  const LinearContact& law(const Contact& contact) const;

  CellPolygons polygons_;
  std::vector<std::uint32_t> group_;
  std::uint32_t groups_ = 1;
  std::vector<LinearContact> laws_;     // of two groups each
  std::vector<bool> slides_;            // of each cell: a smooth joint joins it to another
  std::vector<std::uint32_t> exposed_;  // cells of which some side was free as the list was made, ascending
  std::vector<Contact> contacts_;
  double skin_ = 0;   // [m]
  double moved_ = 0;  // at most, by any corner of these or any wall since the list was made [m]
  bool stale_ = false;
  std::uint64_t lists_ = 0;
  double friction_ = 0, dashpots_ = 0;
};

}  // namespace adit::dem
