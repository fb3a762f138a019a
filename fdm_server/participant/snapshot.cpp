#include "fdm_server/participant/snapshot.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace adit::fdm {
namespace {

// A field of `rows` rows of zeros, to be filled by place.
double* new_field(google::protobuf::RepeatedPtrField<wire::Field>& fields, const std::string& name,
                  int components, std::size_t rows) {
  auto& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  field.mutable_values()->Resize(components * static_cast<int>(rows), 0.0);
  return field.mutable_values()->mutable_data();
}

void fill_vectors(std::span<const double> x, std::span<const double> y, double* values) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    values[3 * i] = x[i];
    values[3 * i + 1] = y[i];
  }
}

// A piece along paths, whose points are its own: x, y, displacement.
wire::Piece& add_lines(const std::string& name, const Grid& grid, const Continuum& continuum,
                       std::span<const Path> paths, wire::Snapshot& snapshot) {
  auto& piece = *snapshot.add_pieces();
  piece.set_name(name);
  piece.set_shape(wire::Piece::LINES);
  std::vector<double> ux, uy;
  for (const auto& [points, closed] : paths) {
    const auto first = static_cast<std::uint32_t>(ux.size()),
               count = static_cast<std::uint32_t>(points.size());
    for (const auto point : points) {
      piece.add_points(grid.x[point]);
      piece.add_points(grid.y[point]);
      ux.push_back(continuum.ux()[point]);
      uy.push_back(continuum.uy()[point]);
    }
    for (std::uint32_t k = 0; k + (closed ? 0 : 1) < count; ++k) {
      piece.add_connectivity(first + k);
      piece.add_connectivity(first + (k + 1) % count);
    }
  }
  fill_vectors(ux, uy, new_field(*piece.mutable_point_fields(), "displacement_m", 3, ux.size()));
  return piece;
}

// What reinforced sections have; 0 in linings without.
void add_use(const Structures& structures, std::span<const Lining> linings, const PeakUse& peaks,
             wire::Piece& piece) {
  std::vector<SectionUse> now;
  std::vector<double> least, largest;  // ultimate moments at the thrust that the piece shows
  for (const Lining& lining : linings) {
    const std::vector<SectionUse> uses = section_uses(lining, structures);
    now.insert(now.end(), uses.begin(), uses.end());
    for (std::size_t node = 0; node < uses.size(); ++node) {
      const auto ultimate = [&](sections::Bending bending) {
        return lining.section ? moment_capacity(lining, structures, node, bending) : 0;
      };
      least.push_back(ultimate(sections::Bending::kInnerStretched));
      largest.push_back(ultimate(sections::Bending::kOuterStretched));
    }
  }
  const auto add = [&](const std::string& name, const auto& rows, auto value) {
    std::ranges::transform(rows, new_field(*piece.mutable_point_fields(), name, 1, rows.size()), value);
  };
  add("utilisation", now, std::mem_fn(&SectionUse::utilisation));
  add("shear_utilisation", now, std::mem_fn(&SectionUse::shear));
  add("curvature_per_m", now, std::mem_fn(&SectionUse::curvature));
  add("steel_strain", now, std::mem_fn(&SectionUse::steel_strain));
  add("crack_width_m", now, std::mem_fn(&SectionUse::crack_width));
  add("moment_ratio", now, std::mem_fn(&SectionUse::moment_ratio));
  add("hinge_rotation_rad", now, std::mem_fn(&SectionUse::hinge_rotation));
  add("least_moment_capacity_Nm", least, std::identity());
  add("largest_moment_capacity_Nm", largest, std::identity());
  if (peaks.empty()) return;
  const auto add_peak = [&](const std::string& name, const std::vector<PeakUse::Instant>& at,
                            double SectionUse::*of) {
    add(name, at, [of](const PeakUse::Instant& instant) { return instant.use.*of; });
  };
  add_peak("peak_utilisation", peaks.largest().utilisation, &SectionUse::utilisation);
  add_peak("peak_shear_utilisation", peaks.largest().shear, &SectionUse::shear);
  add_peak("peak_curvature_per_m", peaks.largest().curvature, &SectionUse::curvature);
  add_peak("peak_steel_strain", peaks.largest().steel_strain, &SectionUse::steel_strain);
  add_peak("peak_crack_width_m", peaks.largest().crack_width, &SectionUse::crack_width);
  add_peak("peak_moment_ratio", peaks.largest().moment_ratio, &SectionUse::moment_ratio);
  add_peak("peak_hinge_rotation_rad", peaks.largest().hinge_rotation, &SectionUse::hinge_rotation);
}

// What joints of segments do; 0 at nodes without.
void add_joints(const Structures& structures, std::span<const Lining> linings, const PeakJoints& peaks,
                wire::Piece& piece) {
  std::vector<std::size_t> first_node{0};
  for (const Lining& lining : linings) first_node.push_back(first_node.back() + lining.path.points.size());
  const auto add = [&](const std::string& name, const auto& value) {
    double* values = new_field(*piece.mutable_point_fields(), name, 1, first_node.back());
    for_each_segment_joint(linings, [&](const Lining& lining, const LiningJoint& joint, std::size_t number) {
      const auto row = first_node[static_cast<std::size_t>(&lining - linings.data())] + joint.node;
      values[row] = value(joint_use(lining, structures, joint), number);
    });
  };
  add("outer_opening_m", [](const JointUse& use, std::size_t) { return use.outer_opening; });
  add("inner_opening_m", [](const JointUse& use, std::size_t) { return use.inner_opening; });
  add("joint_rotation_rad", [](const JointUse& use, std::size_t) { return use.rotation; });
  if (!peaks.empty())
    add("peak_joint_opening_m", [&](const JointUse&, std::size_t number) {
      return peaks.extremes().opening[number].use.largest_opening();
    });
}

// What dowels between rings do, at the nodes of the ring that lies beside the other; 0 at nodes without.
void add_dowels(const Structures& structures, std::span<const Lining> linings, wire::Piece& piece) {
  std::size_t nodes = 0;
  for (const Lining& lining : linings) nodes += lining.path.points.size();
  double* forces = new_field(*piece.mutable_point_fields(), "dowel_force_N", 1, nodes);
  double* offsets = new_field(*piece.mutable_point_fields(), "ring_offset_m", 1, nodes);
  std::size_t first_node = 0;
  for (const Lining& lining : linings) {
    for (std::size_t k = 0; k < lining.dowels.size(); ++k) {
      const Dowel& dowel = structures.dowels()[lining.first_dowel + k];
      forces[first_node + lining.dowels[k]] = lining.ring_width * dowel.force();
      offsets[first_node + lining.dowels[k]] = dowel.offset();
    }
    first_node += lining.path.points.size();
  }
}

// `kind`: "lining" or "member".
void add_chains(const std::string& kind, const Grid& grid, const Continuum& continuum,
                std::span<const Lining> linings, const ChainPeaks& of_chains, wire::Snapshot& snapshot) {
  if (linings.empty()) return;
  const auto& [peaks, use, joints] = of_chains;
  std::vector<Path> paths;
  std::vector<double> number, thrust, moment, shear;
  for (const Lining& lining : linings) {
    number.insert(number.end(), lining.beams, static_cast<double>(paths.size()));
    paths.push_back(lining.path);
    for (std::size_t node = 0; node < lining.path.points.size(); ++node) {
      const auto forces = forces_at(lining, continuum.structures(), node);
      thrust.push_back(forces.thrust);
      moment.push_back(forces.moment);
      shear.push_back(forces.shear);
    }
  }
  auto& piece = add_lines(kind + "s", grid, continuum, paths, snapshot);
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    std::ranges::copy(values, new_field(*piece.mutable_point_fields(), name, 1, values.size()));
  };
  add("thrust_N", thrust);
  add("moment_Nm", moment);
  add("shear_N", shear);
  using Instant = PeakForces::Instant;
  const auto add_peaks = [&](const std::string& name, const std::vector<Instant>& at,
                             double Instant::*force) {
    std::ranges::transform(at, new_field(*piece.mutable_point_fields(), name, 1, at.size()),
                           std::mem_fn(force));
  };
  if (!peaks.empty()) {
    add_peaks("peak_largest_thrust_N", peaks.thrust().largest, &Instant::thrust);
    add_peaks("peak_least_thrust_N", peaks.thrust().least, &Instant::thrust);
    add_peaks("peak_largest_moment_Nm", peaks.moment().largest, &Instant::moment);
    add_peaks("peak_least_moment_Nm", peaks.moment().least, &Instant::moment);
    add_peaks("peak_largest_shear_N", peaks.shear().largest, &Instant::shear);
    add_peaks("peak_least_shear_N", peaks.shear().least, &Instant::shear);
    add_peaks("thrust_at_peak_largest_moment_N", peaks.moment().largest, &Instant::thrust);
    add_peaks("thrust_at_peak_least_moment_N", peaks.moment().least, &Instant::thrust);
  }
  std::ranges::copy(number, new_field(*piece.mutable_cell_fields(), kind, 1, number.size()));
  if (any_section(linings)) add_use(continuum.structures(), linings, use, piece);
  if (std::ranges::any_of(linings, [](const Lining& lining) { return !lining.dowels.empty(); }))
    add_dowels(continuum.structures(), linings, piece);
  if (any_segments(linings)) add_joints(continuum.structures(), linings, joints, piece);
}

void add_bolts(const Grid& grid, const Continuum& continuum, const std::vector<BoltBars>& bolts,
               wire::Snapshot& snapshot) {
  std::vector<Path> paths;
  std::vector<double> thrust;
  for (const BoltBars& bolt : bolts) {
    paths.push_back(bolt.path);
    for (const Bar& bar : continuum.structures().bars().subspan(bolt.first_bar, bolt.bars))
      thrust.push_back(bolt.spacing * bar.thrust());
  }
  auto& piece = add_lines("bolts", grid, continuum, paths, snapshot);
  std::ranges::copy(thrust, new_field(*piece.mutable_cell_fields(), "thrust_N", 1, thrust.size()));
}

}  // namespace

void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot) {
  snapshot.Clear();
  auto& piece = *snapshot.add_pieces();
  piece.set_name("grid");
  piece.set_shape(wire::Piece::QUADS);
  const std::size_t points = grid.own_points(), zones = grid.zones.size() - grid.own_corners.size();
  for (std::size_t i = 0; i < points; ++i) {
    piece.add_points(grid.x[i]);
    piece.add_points(grid.y[i]);
  }
  std::vector<std::size_t> present;
  for (std::size_t z = 0; z < zones; ++z)
    if (weights[z] > 0) present.push_back(z);
  for (const auto z : present)
    for (const auto point : grid.zones[z]) piece.add_connectivity(static_cast<std::uint32_t>(point));

  auto& at_points = *piece.mutable_point_fields();
  fill_vectors(continuum.ux().first(points), continuum.uy(),
               new_field(at_points, "displacement_m", 3, points));
  fill_vectors(continuum.vx().first(points), continuum.vy(),
               new_field(at_points, "velocity_m_per_s", 3, points));

  auto& in_zones = *piece.mutable_cell_fields();
  double* stress = new_field(in_zones, "stress_Pa", 3, present.size());
  double* weight = new_field(in_zones, "weight", 1, present.size());
  for (std::size_t i = 0; i < present.size(); ++i) {
    const auto [xx, yy, xy] = continuum.zones().stress(present[i]);
    stress[3 * i] = xx;
    stress[3 * i + 1] = yy;
    stress[3 * i + 2] = xy;
    weight[i] = weights[present[i]];
  }
}

void add_ground(const Grid& grid, const Ground& ground, const ZoneSet& zones, std::span<const double> weights,
                wire::Piece& piece) {
  std::vector<std::uint32_t> groups(grid.own_zones(), 0);
  for (std::uint32_t k = 0; k < grid.groups.size(); ++k)
    for (const auto zone : grid.groups[k].zones) groups[zone] = k + 1;
  const auto present = std::ranges::count_if(weights.first(grid.own_zones()), [](double w) { return w > 0; });
  const auto add = [&](const std::string& name, auto&& value_of) {
    double* values = new_field(*piece.mutable_cell_fields(), name, 1, static_cast<std::size_t>(present));
    for (std::size_t z = 0; z < grid.own_zones(); ++z)
      if (weights[z] > 0) *values++ = value_of(z);
  };
  add("material", [&](std::size_t z) { return ground.stated_of(z); });
  add("group", [&](std::size_t z) { return groups[z]; });
  if (!ground.stiffness_factor.empty())
    add("stiffness_factor", [&](std::size_t z) { return ground.stiffness_of(z); });
  if (!ground.strength_factor.empty())
    add("strength_factor", [&](std::size_t z) { return ground.strength_of(z); });
  if (ground.any_wet()) {
    add("pore_pressure_Pa", [&](std::size_t z) { return zones.pore_pressure(z); });
    add("pressure_ratio", [&](std::size_t z) { return zones.pressure_ratio(z); });
  }
  if (ground.states_strength()) add("demand", [&](std::size_t z) { return zones.demand(z); });
  if (std::ranges::all_of(ground.materials, &Material::linear)) return;
  add("yield_state", [&](std::size_t z) { return zones.field(z, ZoneField::kYieldState); });
  add("plastic_shear_strain", [&](std::size_t z) { return zones.field(z, ZoneField::kPlasticShearStrain); });
}

void add_supports(const Grid& grid, const Continuum& continuum, const Supports& supports,
                  const ChainPeaks& of_linings, const ChainPeaks& of_members, wire::Snapshot& snapshot) {
  add_chains("lining", grid, continuum, supports.linings, of_linings, snapshot);
  add_chains("member", grid, continuum, supports.members, of_members, snapshot);
  if (!supports.bolts.empty()) add_bolts(grid, continuum, supports.bolts, snapshot);
}

void add_interfaces(const Grid& grid, const Continuum& continuum, std::span<const Interface> interfaces,
                    const ContactPeaks& peaks, wire::Snapshot& snapshot) {
  if (interfaces.empty()) return;
  const Contacts& contacts = continuum.contacts();
  std::vector<Path> paths;
  std::vector<std::uint32_t> rows;
  std::vector<double> number;
  for (const Interface& interface : interfaces) {
    Path path{{}, interface.closed};
    for (std::uint32_t i = interface.first; i < interface.first + interface.count; ++i) {
      path.points.push_back(contacts.point(i));
      rows.push_back(i);
    }
    number.insert(number.end(), interface.count - (interface.closed ? 0 : 1),
                  static_cast<double>(paths.size()));
    paths.push_back(std::move(path));
  }
  auto& piece = add_lines("interfaces", grid, continuum, paths, snapshot);
  const auto add = [&](const std::string& name, const auto& value_of) {
    std::ranges::transform(rows, new_field(*piece.mutable_point_fields(), name, 1, rows.size()), value_of);
  };
  add("normal_stress_Pa", [&](auto i) { return contacts.read(i).normal_stress; });
  add("shear_stress_Pa", [&](auto i) { return contacts.read(i).shear_stress; });
  add("opening_m", [&](auto i) { return contacts.read(i).opening; });
  add("offset_m", [&](auto i) { return contacts.read(i).offset; });
  if (!peaks.empty()) {
    add("peak_offset_m", [&](auto i) { return peaks.offset()[i].value; });
    add("peak_opening_m", [&](auto i) { return peaks.opening()[i].value; });
  }
  std::ranges::copy(number, new_field(*piece.mutable_cell_fields(), "interface", 1, number.size()));
}

void add_peaks(const Peaks& peaks, std::span<const double> weights, wire::Piece& piece) {
  protocol::add_peak_fields(peaks.motion(), *piece.mutable_point_fields());
  const auto add = [&](const std::string& name, std::span<const double> values) {
    std::vector<double> present;
    for (std::size_t z = 0; z < values.size(); ++z)
      if (weights[z] > 0) present.push_back(values[z]);
    std::ranges::copy(present, new_field(*piece.mutable_cell_fields(), name, 1, present.size()));
  };
  add("peak_shear_strain", peaks.shear_strain());
  add("peak_largest_principal_stress_Pa", peaks.largest_principal());
  add("peak_smallest_principal_stress_Pa", peaks.smallest_principal());
  if (!peaks.pressure_ratio().empty()) add("peak_pressure_ratio", peaks.pressure_ratio());
  if (peaks.demand().empty()) return;
  add("peak_demand", peaks.demand());
  add("peak_demand_time_s", peaks.demand_time());
}

}  // namespace adit::fdm
