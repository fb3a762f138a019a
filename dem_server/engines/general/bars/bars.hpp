// The bars of a model, step by step, as a part of the solver beside pairs, joints and springs.
//
// A node lies at a place P of its particle and moves and turns with it. Between two nodes P_1 and P_2, L_0
// apart at rest, d = P_2 - P_1 now, the bar (bar_chain.hpp) pulls both along d with N; its growth is g = |d|
// - L_0. Across, it is a dowel: with a the turn of d since rest less the mean of the particles' turns,
//   D = L_0 a,   V = K (D - D_p),   |V| <= V_u sqrt(1 - (sigma / f_y)^2),
// D being the shift of the two particles' faces in the middle between the nodes. V does work on D: the force
// V L_0 / |d| on P_1 along the left normal of d, the opposite on P_2, and the moment V L_0 / 2 on both
// particles. So neither linear nor angular momentum is lost, and a motion as of one body makes no force.
#pragma once

#include <span>
#include <vector>

#include "dem_server/engines/general/bars/bar_chain.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

// An element as it is now: forces on its first particle.
struct BarElement {
  std::uint32_t first, second;
  double x_1, y_1, x_2, y_2;  // its nodes [m]
  double nx, ny;              // unit vector from the first to the second
  double pull, dowel;         // along it and its left normal, at the middle [N]
};

class Bars {
 public:
  Bars() = default;
  Bars(const std::vector<Bar>& bars, const Particles& particles);

  // As of springs (forces/spring_forces.hpp).
  void begin_stage(std::uint32_t before, std::uint32_t stage, const Particles& particles);
  // The team finds what each bar bears, which depends on no other.
  void add_forces(double dt, protocol::Team& team, Particles& particles);

  bool empty() const { return bars_.empty(); }
  std::size_t size() const { return bars_.size(); }
  const BarChain& chain(std::size_t bar) const { return bars_[bar].chain; }
  bool installed(std::size_t bar) const { return bars_[bar].installed; }
  BarElement element(std::size_t bar, std::size_t element, const Particles& particles) const;

  double internal_force() const;  // sum of |force| [N]
  double strain_energy() const;   // [J]
  double yielded() const;         // taken by yielding since the start [J]
  double slipped() const;         // by bond
  double dowels() const;
  double dissipated() const { return yielded() + slipped() + dowels(); }
  void start_over();

  void exchange(state::Archive& archive);

 private:
  struct Dowel {
    double shift = 0, plastic = 0, force = 0;  // D, D_p [m], V [N]
  };
  // A node on its particle: the lever arm from the centre now, and how far it has moved since rest [m].
  struct NodeMotion {
    PlaneVector arm, moved;
  };
  struct Shape {
    std::uint32_t first, second;
    PlaneVector arm_1, arm_2;
    double x_1, y_1;        // of the first node now [m]
    double dx, dy, length;  // d, |d|
    double rest_length;     // L_0
    double growth, shift;   // g, D
  };
  struct Installed {
    double growth = 0, shift = 0;  // since rest, with which it began [m]
  };
  struct OneBar {
    BarChain chain;
    bool installed;
    std::vector<double> turn;  // of each node's particle since rest [rad]
    std::vector<Dowel> dowels;
    std::vector<Installed> begun;
    double lost_by_dowels = 0;
    // In work.
    std::vector<double> growths;
    std::vector<NodeMotion> motions;
    std::vector<Shape> shapes;
  };
  static NodeMotion motion_of(const BarNode& node, double turn, const Particles& particles);
  static Shape shape_of(const OneBar& bar, std::size_t element, const NodeMotion& first,
                        const NodeMotion& second);
  static Shape shape_of(const OneBar& bar, std::size_t element, const Particles& particles);
  static void install(const Particles& particles, OneBar& bar);
  static void let_go(const Particles& particles, OneBar& bar);
  static void follow(double dt, const Particles& particles, OneBar& bar);
  static void shear(std::size_t element, double shift, OneBar& bar);
  static void pull(const Shape& shape, double force, double dowel, Particles& particles);

  std::vector<OneBar> bars_;
};

}  // namespace adit::dem
