// A step of a facet that is worn, by the whole law (laws/facet.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dem_server/engines/general/facets/facet_motion.hpp"
#include "dem_server/engines/general/facets/facet_set.hpp"

namespace adit::dem {

class WornStep {
 public:
  WornStep(std::uint32_t facet, const FacetMotion& motion, const FacetSet& set)
      : set_(set),
        motion_(motion),
        k_(facet),
        law_(set.laws[set.law[facet]]),
        stiffness_(set.stiffness[facet]) {}

  // What the cells' areas add now, by their pressures.
  void add(double pressure_1, double pressure_2, WornFacet& worn) const {
    const double p_1 = set_.share_1[k_] * pressure_1, p_2 = set_.share_2[k_] * pressure_2,
                 share = 1 / set_.weight[k_];
    worn.added_n = 0.5 * share * (p_1 + p_2) + set_.rest_n[k_];
    worn.added_t = share * set_.skew[k_] * (p_1 - p_2) + set_.rest_t[k_];
  }

  // Tractions at both points; returns what was dissipated [J].
  double find(WornFacet& worn) const {
    const double jump_n = motion_.jump_n + worn.added_n / stiffness_,
                 jump_t = motion_.jump_t + worn.added_t / stiffness_;
    const double half = set_.length[k_] / 2;
    double dissipated = 0;
    for (int e = 0; e < 2; ++e) {
      WornFacet::End& end = worn.ends[e];
      const double at = (e == 0 ? 1 : -1) * kFacetPoint * set_.length[k_];
      const double n = jump_n - at * motion_.turn;
      if (law_.rate_exponent > 0 && end.point.wear == 0) raise(n, jump_t, worn.begun, end);
      const double kept_before = end.kept();
      const auto [sigma, tau] =
          worn.parted ? FacetTraction{0, 0} : facet_traction(law_, stiffness_, n, jump_t, end.point);
      if (!worn.begun) {
        if (end.point.wear == 0) end.point.raised = 1;
        end.normal = sigma;
        end.shear = tau;
      }
      const double lost_n = n - sigma / stiffness_, lost_t = jump_t - tau / stiffness_;
      const double work =
          (end.normal + sigma) * (lost_n - end.lost_n) + (end.shear + tau) * (lost_t - end.lost_t);
      end.normal = sigma;
      end.shear = tau;
      end.lost_n = lost_n;
      end.lost_t = lost_t;
      dissipated += half * 0.5 * (work - (end.kept() - kept_before));
    }
    worn.begun = true;
    return dissipated;
  }

  // As far as it is elastic, of tractions that are known, without what it does not bear of what is added.
  Spread spread(const WornFacet& worn) const {
    const double bears = 1 - worn.released();
    const double n = 0.5 * (worn.ends[0].normal + worn.ends[1].normal) - set_.rest_n[k_] -
                     bears * (worn.added_n - set_.rest_n[k_]),
                 t = 0.5 * (worn.ends[0].shear + worn.ends[1].shear) - worn.added_t;
    const auto [first, second] = spread_of(set_.length[k_], set_.skew[k_], n / stiffness_, t / stiffness_);
    return {set_.share_1[k_] * first, set_.share_2[k_] * second};
  }

  // By how much the cells' pressures differ [Pa], and what that stores, from its square, where this share of
  // them is not borne (facet_kernel.hpp) [J/m].
  double difference(double pressure_1, double pressure_2) const {
    return (set_.share_1[k_] * pressure_1 - set_.share_2[k_] * pressure_2) / set_.weight[k_];
  }
  double uneven_energy(double square, double released) const {
    return set_.length[k_] * released * square / (8 * stiffness_);
  }

  // s A / 2k for both cells.
  Spread released(const WornFacet& worn) const {
    const double released = worn.released() * set_.length[k_] / (2 * stiffness_ * set_.weight[k_]);
    return {set_.share_1[k_] * set_.share_1[k_] * released, set_.share_2[k_] * set_.share_2[k_] * released};
  }

  // One end has lost its strength: the other may be a hinge that is never beyond its own.
  bool parts(const WornFacet& worn) const {
    return !worn.parted && std::max(worn.ends[0].point.wear, worn.ends[1].point.wear) >= kCracked &&
           std::max(std::abs(motion_.jump_t), motion_.jump_n + std::abs(motion_.turn) * set_.length[k_] / 2) >
               set_.length[k_] / 2;
  }

  double normal(const WornFacet& worn) const {
    return set_.length[k_] / 2 * (worn.ends[0].normal + worn.ends[1].normal);
  }

  FacetAction act(const WornFacet& worn) const {
    const double length = set_.length[k_], half = length / 2;
    return action(normal(worn), half * (worn.ends[0].shear + worn.ends[1].shear),
                  half * kFacetPoint * length * (worn.ends[1].normal - worn.ends[0].normal));
  }

  // Of these forces and this moment, unweighted.
  FacetAction action(double normal, double shear, double moment) const {
    const FacetAction a =
        action_of(set_.half_distance[k_], set_.skew[k_], motion_.cosine,
                  0.5 * (motion_.turn + set_.start_turn[k_]), motion_.jump_n + set_.start_n[k_],
                  motion_.jump_t + set_.start_t[k_], normal, shear, moment, motion_.nx, motion_.ny);
    const double w = set_.weight[k_];
    return {w * a.x, w * a.y, w * a.moment_1, w * a.moment_2};
  }

 private:
  // By the largest rate since the point went beyond its strength in slow tests: where it turns back, it is
  // not weaker for that. The rate of the first step is not known: then, and only then, it is as if it were
  // fast.
  void raise(double jump_n, double jump_t, bool begun, WornFacet::End& end) const {
    if (set_.steps_per_second == 0) return;
    const double grown = std::hypot(jump_n - end.lost_n - end.normal / stiffness_,
                                    jump_t - end.lost_t - end.shear / stiffness_);
    const double rate = begun ? grown * set_.steps_per_second / (2 * set_.half_distance[k_]) : kFastRate;
    end.point.raised = std::max(end.point.raised, raised_by(law_, rate));
  }

  const FacetSet& set_;
  const FacetMotion motion_;
  std::uint32_t k_;
  const FacetLaw& law_;
  double stiffness_;
};

}  // namespace adit::dem
