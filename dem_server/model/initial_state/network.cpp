#include "dem_server/model/initial_state/network.hpp"

#include <cmath>

#include "dem_server/model/bond_springs.hpp"

namespace adit::dem {
namespace {

Link link_between(const Discs& d, std::uint32_t i, std::uint32_t j) {
  const double x = d.x[j] - d.x[i], y = d.y[j] - d.y[i], length = std::hypot(x, y);
  const Arms arms = arms_of(length, (d.radius[i] - d.radius[j]) / 2);
  const double ex = x / length, ey = y / length;
  return {i,  j, x, y, (d.x[i] + d.x[j]) / 2, (d.y[i] + d.y[j]) / 2, ex, ey, arms.first, arms.second, ex,
          ey, 1, 1, 0};
}

// Of kn: what is less is what rounding left of none.
constexpr double kNoShearStiffness = 1e-9;

// Mean of ks / kn; a smooth joint's ratio is that of a plane, and counts nothing.
class MeanRatio {
 public:
  void add(double kn, double ks) {
    sum_ += ks / kn;
    ++count_;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : 1; }

 private:
  double sum_ = 0;
  double count_ = 0;
};

}  // namespace

std::vector<Link> links_of(const Model& model, std::span<const Pair> touching) {
  std::vector<Link> links;
  links.reserve(model.bonds.size() + touching.size());
  MeanRatio ratio;
  for (const Bond& bond : model.bonds) {
    Link& link = links.emplace_back(link_between(model.discs, bond.first, bond.second));
    const BondSprings springs = whole_springs(model, bond);
    link.km = springs.km / springs.kn;
    if (bond.law == Bond::Law::kSmoothJoint) {
      link.nx = bond.nx;
      link.ny = bond.ny;
    } else {
      ratio.add(springs.kn, springs.ks);
      link.ks = springs.ks > kNoShearStiffness * springs.kn;
    }
  }
  for (const auto [i, j] : touching) {
    Link& link = links.emplace_back(link_between(model.discs, i, j));
    const LinearContact& law = model.contacts[model.contact_number(model.group[i], model.group[j])];
    ratio.add(law.normal_stiffness, law.shear_stiffness);
    link.ks = law.shear_stiffness > kNoShearStiffness * law.normal_stiffness;
  }
  for (Link& link : links) link.ks *= ratio.value();
  return links;
}

PairForces forces_under(const Strain& strain, const Link& link) {
  const double ux = strain.xx * link.x + strain.xy * link.y, uy = strain.xy * link.x + strain.yy * link.y;
  return {link.kn * along(link.nx, link.ny, ux, uy), link.ks * across(link.nx, link.ny, ux, uy), 0};
}

Stretching stretching(const Link& link) {
  // r by one unit of both rotations is arm (ey, -ex)
  const double along_n = along(link.nx, link.ny, link.ey, -link.ex),
               along_t = across(link.nx, link.ny, link.ey, -link.ex);
  return {{{-link.nx, -link.ny, along_n * link.arm_1, link.nx, link.ny, along_n * link.arm_2},
           {link.ny, -link.nx, along_t * link.arm_1, -link.ny, link.nx, along_t * link.arm_2},
           {0, 0, -1, 0, 0, 1}}};
}

}  // namespace adit::dem
