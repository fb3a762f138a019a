// The contacts of a grid: pairs of faces that share a place, each between points of zones or linings. In
// small strain they keep their partners.
//
// A contact is the sum of halves, the ends of sides at its place, each between two zones or between a lining
// and a zone, because zones may be taken away later. Its normal is the mean of its halves', by length: on a
// polygon that stands for a curve slip then neither opens nor closes the faces, while the normals of the
// sides would lock it.
//
// Where they can, contacts move by mean acceleration (structures/mean_acceleration.hpp), so that their
// stiffness does not shorten the step. Their law moves from half step to half step, from the mean of u(n-1)
// and u(n) to that of u(n) and u(n+1), and its mean stresses of this stroke act at step n: for faces that
// stick these are the mean of three steps, and faces that meet, slide and part make no energy. The end of the
// stroke is ahead of u(n) by dt v(n+1/2)/2, which the acceleration decides; from rest, when v(-1/2) =
// -v(1/2), the stroke begins where it ends, and the stresses are those of its end. What a contact bears
// depends on the acceleration, and this on what it bears. Newton's method finds both: for a pair of points
// that has no other such contact by itself,
//   q + c B(q) = c f,   c = dt^2/4 (1/m_1 + 1/m_2),
// with the lead q = dt^2/4 a, what the contact bears, B, and f/m the acceleration without it; for all others
// together (solver/contact_balance.hpp).
//
// Ledger (solver/continuum.hpp): as the work of step n is that of its stresses over the stroke, what is
// stored at step n is what is stored at the end less the stresses times the way ahead; of faces that slide it
// is what is dissipated that is less.
//
// Water in the pores of the zones beside fills the gap: it pushes the faces apart with its pressure p, and
// the law is that of the effective stress, which is the stress plus p. As p grows by dp between two steps,
// faces that touch go on bearing the same stress: the closure of the law grows by dp/k_n. So p acts on
// friction and on parting, and the springs of the faces alone answer their motion: forces of a lining that
// follow the volume of the zone beside it, but not the other way round, would derive from no energy. The work
// of p on the gap and what dp stores are work from outside. In large strain p is that of the zones that lay
// there at the start.
//
// In large strain a contact is between a point of one face and the side of the other, the guide, that lies
// opposite now (face.hpp): with the share xi of the way along it, the motion is v - (1 - xi) v_a - xi v_b
// along the present normal and tangent, and the forces are shared alike, so that they make no couple. Shares
// and normal hold over the stroke of a step, whose work stays that of the stresses; from one step to the next
// the way ahead turns with them, from B(n-1) dt v/2 to B(n) dt v/2. The closure is what strokes add up to. Of
// open faces it is the gap between their present places, from what they bore at the start on and what dp
// added, but never one that has closed already: what differs ends with each opening. A point past the end of
// the guide is free, and what it stored is dissipated. Lengths are those before deformation.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "fdm_server/interfaces/contact.hpp"
#include "fdm_server/interfaces/face.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/structures/strain_form.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

inline constexpr std::uint32_t kNoZone = std::numeric_limits<std::uint32_t>::max();

class Contacts {
 public:
  // Between zones, or a lining (kNoZone) and a zone. (nx, ny): the normal towards the first face times half
  // the length of the side, weighted [m].
  struct Half {
    std::uint32_t first_zone, second_zone;
    double nx, ny;
    double side;  // its length [m]
  };
  // Adds a contact of these halves, at most two, between two points at one place, which stands from this
  // stage on. Returns its number.
  std::uint32_t add(const std::array<std::uint32_t, 2>& points, std::span<const Half> halves,
                    const ContactLaw& law, std::uint32_t stage);

  // In large strain: the points of the contacts from the first on, of the first faces or of the second ones,
  // slide along this guide, which has the first faces on its left. `x`, `y`: the grid's points [m].
  void slide(std::uint32_t first, std::uint32_t count, bool of_first, Face guide, std::span<const double> x,
             std::span<const double> y);
  bool slides() const { return !guides_.empty(); }
  // Brings shares, normals and gaps to the places of this step, before its forces.
  void find_feet(const protocol::Step& step, std::span<const double> ux, std::span<const double> uy,
                 std::span<const double> vx, std::span<const double> vy);

  bool empty() const { return contacts_.empty(); }
  std::size_t size() const { return contacts_.size(); }

  // Contacts of the stages up to this one stand from now on; halves of zones that are gone fall away.
  void install(std::uint32_t stage, const std::vector<bool>& gone);
  void mark_points(std::vector<bool>& touched) const;
  using Part = std::vector<std::uint32_t>;  // numbers
  Part standing() const;
  // Moves out of a part what touches a chosen point.
  Part take(Part& part, const std::vector<bool>& chosen) const;

  // Masses that make this step [s] the critical one of every contact that stands, for statics: no frequency
  // of the whole is then above the largest of one element (zones/critical_step.hpp).
  void add_masses(std::span<double> of_points, double step) const;
  // A bound of the square of the frequencies [1/s^2] of contacts that touch a chosen point, whether they
  // stand or not, between points of these masses; and the contact that it is of. By Gershgorin's circles: the
  // sum over both points of the stiffness of all their contacts over the mass.
  struct Stiffest {
    double square = 0;
    std::uint32_t point = 0;
  };
  Stiffest stiffest(std::span<const double> masses, const std::vector<bool>& chosen) const;

  // Of water in the pores of a zone [Pa]; nothing of dry ones.
  using PressureOf = std::function<std::optional<double>(std::uint32_t zone)>;
  // The tractions at the start: of the mean stress of the zones on both sides. Linings start without.
  void take_stress(const std::function<Stress(std::uint32_t zone)>& stress_of, const PressureOf& pressure_of);
  // Water of the pressures of this step comes between the faces, before their forces. Returns its work since
  // the last step [J].
  double push_apart(const Part& part, const protocol::Step& step, const PressureOf& pressure_of,
                    const PointView& points);

  // Moves these contacts to the present places of their faces and adds their forces.
  void add_forces(const Part& part, double dt, const PointView& points);
  // The same in parts, for contacts by mean acceleration. The faces come to their places of this step:
  void move(const Part& part, double dt, bool from_rest, const PointView& points);
  // What a contact will bear if dt^2/4 times its relative acceleration are these leads along normal and
  // tangent [m], and its slopes.
  struct Bearing {
    double normal, shear;                        // [N], tension positive
    Stroke::Slopes normal_slopes, shear_slopes;  // against leads [N/m]
  };
  Bearing bear(std::uint32_t contact, const std::array<double, 2>& lead) const;
  // The contact follows its law, and its forces are added.
  void follow(std::uint32_t contact, const std::array<double, 2>& lead, const PointView& points);
  // Both for contacts whose points nothing else by mean acceleration acts on, from the other forces and the
  // points' inverse masses, which are those of x and y alike.
  void settle_pairs(const Part& part, const protocol::Step& step, std::span<const double> inverse_masses,
                    const PointView& points);
  // Moves out of a part the contacts whose points no other one of it touches, nor what chose a point.
  Part take_pairs(Part& part, const std::vector<bool>& chosen) const;
  // The leads of the last step.
  const std::array<double, 2>& lead(std::uint32_t contact) const { return contacts_[contact].lead; }
  // The forces of halves of the zones that have such a share to be held back, on their points.
  void add_held(const std::function<double(std::uint32_t zone)>& share_of, std::span<double> fx,
                std::span<double> fy) const;

  // Two forms each, along the normal and along the tangent, of faces that stick.
  std::vector<StrainForm> strains(const Part& part) const;
  double strain_energy() const;
  double dissipated() const;
  // Displacements and dissipation count from now on.
  void start_over() { dissipated_ = 0; }
  void reset_offsets();
  void exchange(state::Archive& archive);

  // What acts between the faces of one that stands, and how they lie; zeros where it does not stand.
  struct Reading {
    double normal_stress, shear_stress;  // [Pa], tension positive; with the pressure of water
    double opening, offset;              // [m]
  };
  Reading read(std::uint32_t contact) const;
  std::uint32_t point(std::uint32_t contact) const {
    const Contact& one = contacts_[contact];
    return one.sliding ? one.sliding->point : one.points[0];
  }
  double side(std::uint32_t contact) const;  // length of the longest side at it [m]

 private:
  struct Share {  // of the motion of the first face against the second
    std::uint32_t point;
    double factor;
  };
  struct Sliding {
    std::uint32_t guide, point;
    double sense;                  // 1 where the point is of the first face, -1 of the second
    std::array<double, 2> turned;  // the way ahead, by shares and normal of this step [m]
  };
  struct Contact {
    std::array<std::uint32_t, 2> points;
    std::vector<Half> halves;
    double nx, ny, length;  // unit normal; length 0 where it does not stand
    ContactLaw law;
    std::uint32_t stage;
    ContactState state;
    double offset = 0;               // along the tangent, since displacements were 0 [m]
    std::array<double, 2> stress{};  // at this step, along normal and tangent, less the water's [Pa]
    double water = 0;                // pressure in the gap [Pa]
    bool filled = false;             // water has come into it
    std::array<double, 2> lead{};    // [m]
    std::array<double, 2> ahead{};   // the state's place, of that of the faces [m]
    std::array<double, 2> motion{};  // of the faces in this step [m]
    bool from_rest = false;          // this step
    std::array<Share, 3> shares{};
    std::uint32_t share_count = 2;  // 0: free
    std::uint32_t side = 0;         // of the guide
    double xi = 0;                  // the share of the way along it
    double preload = 0;             // closure where faces are drawn in touch: of the start and by water [m]
    std::optional<Sliding> sliding{};

    std::span<const Share> shared() const { return std::span(shares).first(share_count); }
    bool free() const { return share_count == 0; }
  };
  static std::array<double, 2> moved(const Contact& contact, double dt, const double* vx, const double* vy);
  void share(Contact& contact) const;  // by its side and xi
  void release(Contact& contact);
  void exchange_feet(state::Archive& archive);
  static std::array<double, 2> place_ahead(const Contact& contact, const std::array<double, 2>& lead);
  struct Trial {
    ContactState state;  // at the end of the stroke
    Stroke stroke;
  };
  static void move(Contact& contact, double dt, bool from_rest, const PointView& points);
  static Trial attempt(const Contact& contact, const std::array<double, 2>& lead);
  static Bearing bearing(const Contact& contact, const Stroke& stroke);
  void settle(Contact& contact, double c, const std::array<double, 2>& free, const PointView& points);
  void follow(Contact& contact, const std::array<double, 2>& lead, const Trial& trial,
              const PointView& points);
  static void pull(const Contact& contact, const std::array<double, 2>& stress, const PointView& points);
  static std::optional<double> pressure_in_gap(const Contact& contact, const PressureOf& pressure_of);
  // Whether it has a chosen point, now or wherever it may slide.
  bool touches(const Contact& contact, const std::vector<bool>& chosen) const;

  std::vector<Contact> contacts_;
  std::vector<Face> guides_;
  std::vector<double> x_, y_;  // of the grid's points, in large strain [m]
  double dissipated_ = 0;      // up to the ends of the strokes [J]
};

}  // namespace adit::fdm
