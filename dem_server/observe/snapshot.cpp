#include "dem_server/observe/snapshot.hpp"

#include <string>
#include <vector>

#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/fragments.hpp"

namespace adit::dem {
namespace {

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

void add_line(std::uint32_t first, std::uint32_t second, wire::Piece& piece) {
  piece.add_connectivity(first);
  piece.add_connectivity(second);
}

// Values go into the fields at once: lists of them beside these would take as much memory again.
void add_bonds(const Observable& observed, wire::Snapshot& snapshot) {
  wire::Piece& piece = add_piece("bonds", wire::Piece::LINES, observed.particles(), snapshot);
  Fields& fields = *piece.mutable_cell_fields();
  auto& normal = add_field(fields, "normal_force_N", 1);
  auto& shear = add_field(fields, "shear_force_N", 1);
  auto& moment = add_field(fields, "moment_Nm", 1);
  auto& state = add_field(fields, "state", 1);
  auto& weight = add_field(fields, "weight", 1);
  google::protobuf::RepeatedField<double>*opening = nullptr, *slip = nullptr;  // where facets join cells
  observed.for_each_bond([&](const ObservedPair& bond) {
    add_line(bond.first, bond.second, piece);
    normal.Add(bond.normal);
    shear.Add(bond.shear);
    moment.Add(bond.moment);
    state.Add(static_cast<double>(bond.state));
    weight.Add(bond.weight);
    if (!bond.place) return;
    if (!opening) {
      opening = &add_field(fields, "opening_m", 1);
      slip = &add_field(fields, "slip_m", 1);
    }
    opening->Add(bond.opening);
    slip->Add(bond.slip);
  });
}

void add_contacts(const Observable& observed, wire::Snapshot& snapshot) {
  wire::Piece& piece = add_piece("contacts", wire::Piece::LINES, observed.particles(), snapshot);
  auto& normal = add_field(*piece.mutable_cell_fields(), "normal_force_N", 1);
  auto& shear = add_field(*piece.mutable_cell_fields(), "shear_force_N", 1);
  observed.for_each_contact([&](const ObservedPair& contact) {
    add_line(contact.first, contact.second, piece);
    normal.Add(contact.normal);
    shear.Add(contact.shear);
  });
}

void add_springs(const Observable& observed, wire::Snapshot& snapshot) {
  const auto springs = observed.springs();
  if (springs.empty()) return;
  wire::Piece& piece = add_piece("springs", wire::Piece::LINES, observed.particles(), snapshot);
  std::vector<double> force, opening;
  std::vector<std::uint32_t> broken;
  for (const SpringForce& spring : springs) {
    add_line(spring.first, spring.second, piece);
    force.push_back(spring.force);
    opening.push_back(spring.opening);
    broken.push_back(spring.broken);
  }
  add_scalars(*piece.mutable_cell_fields(), "force_N", force);
  add_scalars(*piece.mutable_cell_fields(), "opening_m", opening);
  add_scalars(*piece.mutable_cell_fields(), "broken", broken);
}

void add_particles(const Observable& observed, wire::Snapshot& snapshot) {
  const Particles& p = observed.particles();
  wire::Piece& piece = add_piece("particles", wire::Piece::VERTICES, p, snapshot);
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (p.is_there(i)) piece.add_connectivity(i);
  Fields& fields = *piece.mutable_point_fields();
  add_vectors(fields, "velocity_m_per_s", p.vx, p.vy);
  add_scalars(fields, "spin_rad_per_s", p.spin);
  add_scalars(fields, "radius_m", p.radius);
  add_scalars(fields, "weight", p.weight);
  add_scalars(fields, "id", p.id);
  add_scalars(fields, "group", observed.group());
  auto& stress = add_field(fields, "stress_Pa", 3);
  stress.Reserve(static_cast<int>(3 * p.size()));
  for (const auto& [xx, yy, xy] : particle_stress(observed))
    for (const double component : {xx, yy, xy}) stress.Add(component);
  add_scalars(fields, "coordination", coordination_of(p.size(), touching_particles(observed)));
  add_scalars(fields, "fragment", fragments_of(p.size(), whole_bonds(observed)).number);
}

void add_envelope(const Envelope& envelope, Fields& fields) {
  const auto add = [&fields](const std::string& name, std::span<const Extreme> extremes) {
    std::vector<double> values;
    for (const Extreme& extreme : extremes) values.push_back(extreme.value);
    if (!values.empty()) add_scalars(fields, name, values);
  };
  for (const auto& [force, name, unit] : kForceNames) {
    add(std::string("largest_") + name + "_" + unit, envelope.largest(force));
    add(std::string("smallest_") + name + "_" + unit, envelope.smallest(force));
  }
}

void add_use(std::span<const Cut> cuts, std::span<const SectionForces> forces, const UsePeaks& peaks,
             Fields& fields) {
  if (!any_strength(cuts)) return;
  std::vector<double> utilisation, shear, moment_ratio;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const sections::Use use = use_of(cuts[k], forces[k]);
    utilisation.push_back(use.utilisation);
    shear.push_back(use.shear);
    moment_ratio.push_back(use.moment_ratio);
  }
  add_scalars(fields, "utilisation", utilisation);
  add_scalars(fields, "shear_utilisation", shear);
  add_scalars(fields, "moment_ratio", moment_ratio);
  const auto add_peak = [&](const char* name, std::span<const UsePeaks::Instant> instants) {
    std::vector<double> values;
    for (const UsePeaks::Instant& instant : instants) values.push_back(instant.value);
    if (!values.empty()) add_scalars(fields, name, values);
  };
  add_peak("peak_utilisation", peaks.utilisation());
  add_peak("peak_shear_utilisation", peaks.shear());
  add_peak("peak_moment_ratio", peaks.moment_ratio());
}

}  // namespace

google::protobuf::RepeatedField<double>& add_field(Fields& fields, const std::string& name,
                                                   unsigned components) {
  wire::Field& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  return *field.mutable_values();
}

void add_vectors(Fields& fields, const std::string& name, const std::vector<double>& x,
                 const std::vector<double>& y) {
  auto& to = add_field(fields, name, 3);
  to.Reserve(static_cast<int>(3 * x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    to.Add(x[i]);
    to.Add(y[i]);
    to.Add(0.0);
  }
}

wire::Piece& add_piece(const std::string& name, wire::Piece::Shape shape, const Particles& p,
                       wire::Snapshot& snapshot) {
  wire::Piece& piece = *snapshot.add_pieces();
  piece.set_name(name);
  piece.set_shape(shape);
  piece.mutable_points()->Reserve(static_cast<int>(2 * p.size()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    piece.add_points(p.x[i]);
    piece.add_points(p.y[i]);
  }
  add_vectors(*piece.mutable_point_fields(), "displacement_m", difference(p.ux, p.settled_x),
              difference(p.uy, p.settled_y));
  return piece;
}

void write_snapshot(const Observable& observed, wire::Snapshot& snapshot) {
  snapshot.Clear();
  add_particles(observed, snapshot);
  add_bonds(observed, snapshot);
  add_contacts(observed, snapshot);
  add_springs(observed, snapshot);
}

void add_sections(const Observable& observed, const Sections& sections, const Envelope& envelope,
                  const UsePeaks& peaks, wire::Snapshot& snapshot) {
  const auto forces = section_forces(observed, sections);
  if (forces.empty()) return;
  wire::Piece& piece = *snapshot.add_pieces();
  piece.set_name("sections");
  piece.set_shape(wire::Piece::VERTICES);
  std::vector<double> ux, uy, thrust, moment, shear;
  for (std::uint32_t k = 0; k < forces.size(); ++k) {
    const geometry::Point place = sections.middle(k), moved = sections.displacement(k, observed.particles());
    piece.add_points(place.x);
    piece.add_points(place.y);
    piece.add_connectivity(k);
    ux.push_back(moved.x);
    uy.push_back(moved.y);
    thrust.push_back(forces[k].thrust);
    moment.push_back(forces[k].moment);
    shear.push_back(forces[k].shear);
  }
  Fields& fields = *piece.mutable_point_fields();
  add_vectors(fields, "displacement_m", ux, uy);
  add_scalars(fields, "thrust_N", thrust);
  add_scalars(fields, "moment_Nm", moment);
  add_scalars(fields, "shear_N", shear);
  add_envelope(envelope, fields);
  add_use(sections.cuts(), forces, peaks, fields);
}

void add_joints(const Observable& observed, const JointPeaks& peaks, wire::Snapshot& snapshot) {
  const auto joints = observed.joints();
  if (joints.empty()) return;
  wire::Piece& piece = add_piece("joints", wire::Piece::LINES, observed.particles(), snapshot);
  std::vector<double> normal, shear, slip, opening;
  for (const JointForce& joint : joints) {
    add_line(joint.first, joint.second, piece);
    normal.push_back(joint.normal);
    shear.push_back(joint.shear);
    slip.push_back(joint.slip);
    opening.push_back(joint.opening);
  }
  Fields& fields = *piece.mutable_cell_fields();
  add_scalars(fields, "normal_force_N", normal);
  add_scalars(fields, "shear_force_N", shear);
  add_scalars(fields, "slip_m", slip);
  add_scalars(fields, "opening_m", opening);
  if (peaks.slip().empty()) return;
  add_scalars(fields, "peak_slip_m", peaks.slip());
  add_scalars(fields, "peak_opening_m", peaks.opening());
}

}  // namespace adit::dem
