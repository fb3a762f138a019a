#include "fdm_server/zones/laws/plastic_kernels.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

[[gnu::always_inline]] inline double smaller(double a, double b) {
  return a < b ? a : b;
}

// Within a stress of `rounding`.
[[gnu::always_inline]] inline bool within(const YieldCone& c, const PointStress& s, double rounding) {
  const double up = 1 + c.sin_friction, down = 1 - c.sin_friction;
  const double in_plane = 0.5 * c.twice_c_cos - s.mean * c.sin_friction;
  const double below = (c.twice_c_cos + down * s.across) * (1 / up) - s.mean;  // across is the smallest
  const double above = (c.twice_c_cos - up * s.across) * (1 / down) + s.mean;  // the largest
  const double most = smaller(smaller(in_plane, c.tension - s.mean), smaller(below, above)) + rounding;
  // The radius of Mohr's circle in the plane, squared, that the cone bears; negative where it bears none.
  const bool bears = s.difference * s.difference + s.shear * s.shear <= most * std::abs(most);
  return bears & (s.across <= c.tension + rounding);
}

[[gnu::always_inline]] inline bool within(const PlaneStrength& plane, const Traction& on, double rounding) {
  return (std::abs(on.shear) + on.normal * plane.tan_friction - plane.cohesion <= rounding) &
         (on.normal <= plane.tension + rounding);
}

[[gnu::always_inline]] inline double rounding_of(const PointStress& s) {
  return 1e-12 * (std::abs(s.mean) + std::abs(s.difference) + std::abs(s.shear) + std::abs(s.across));
}

// Whether a principal stress is larger than the cut-off.
[[gnu::always_inline]] inline bool torn(const YieldCone& c, const PointStress& s) {
  const double most = c.tension - s.mean;
  const bool in_plane = s.difference * s.difference + s.shear * s.shear > most * std::abs(most);
  return in_plane | (s.across > c.tension);
}

template <bool kSoftens, bool kPlane>
[[gnu::always_inline]] inline Outside outside_of(const Plasticity& law, std::uint32_t count,
                                                 const StressView& stresses, const ConeView& cones,
                                                 const DirectionView& directions, const double* strength,
                                                 BatchFlags& outside) {
  const double *mean = stresses.mean, *across = stresses.across;
  const auto difference = stresses.difference, shear = stresses.shear;
  // In the order of YieldCone; the dilation tells nothing here.
  const auto &friction = cones.fields[0], &cohesion = cones.fields[2], &tension = cones.fields[3];
  const double *cosine = directions.cosine, *sine = directions.sine;
  const YieldCone same = law.cone;
  const PlaneStrength plane = law.plane;
  std::int64_t any = 0;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    bool zone_holds = true, zone_torn = false;
    const YieldCone common = times(strength[i], same);
    const auto point = [&](std::size_t k) {
      const PointStress s{mean[i], difference[k][i], shear[k][i], across[i]};
      const YieldCone cone{kSoftens ? friction[k][i] : common.sin_friction, 0,
                           kSoftens ? cohesion[k][i] : common.twice_c_cos,
                           kSoftens ? tension[k][i] : common.tension};
      zone_holds = zone_holds & within(cone, s, 0);
      zone_torn = zone_torn | torn(cone, s);
      if constexpr (kPlane)
        zone_holds = zone_holds & within(times(strength[i], plane), traction({cosine[i], sine[i]}, s), 0);
    };
    point(0);
    point(1);
    point(2);
    point(3);
    outside[i] = zone_holds ? std::int64_t{kHolds} : zone_torn ? std::int64_t{kTorn} : std::int64_t{kSheared};
  }
  for (std::uint32_t i = 0; i < count; ++i) any |= outside[i];
  return static_cast<Outside>(any);
}

struct PointReturn {
  PointStress stress;
  double sheared;
  std::int64_t yields;
};

// What a return adds to the plastic shear strain: shear_measure() of the strain of the stress that is lost.
[[gnu::always_inline]] inline double sheared_by(const Elasticity& e, const PointStress& from,
                                                const PointStress& to) {
  const double p = from.mean - to.mean, t = from.difference - to.difference, s = from.shear - to.shear,
               deviator = (from.across - to.across - p) * (2.0 / 3);
  return std::sqrt((t * t + s * s) + 0.75 * deviator * deviator) * (1 / e.shear);
}

// Where all three principal stresses return to the cut-off (three_torn() of cone_return.hpp, of which this is
// the condition without roots; no other region overlaps it).
[[gnu::always_inline]] inline PointReturn to_cut_off_point(const Elasticity& e, const YieldCone& cone,
                                                           const PointStress& from) {
  const double over = 2 * from.mean + from.across - 3 * cone.tension;
  const double least = cone.tension + e.lame() * (1 / (3 * e.bulk)) * over, room = from.mean - least;
  const bool torn = (from.difference * from.difference + from.shear * from.shear <= room * std::abs(room)) &
                    (from.across >= least) & (over > 0);
  const bool stays = within(cone, from, 0);
  const PointStress to{cone.tension, 0, 0, cone.tension};
  return {{stays ? from.mean : to.mean, stays ? from.difference : 0, stays ? from.shear : 0,
           stays ? from.across : to.across},
          stays ? 0 : sheared_by(e, from, to),
          stays  ? std::int64_t{kElastic}
          : torn ? std::int64_t{kTensionNow}
                 : kOpen};
}

template <Regions kRegions>
[[gnu::always_inline]] inline PointReturn to_ground(const Elasticity& e, const YieldCone& cone,
                                                    const PointStress& from) {
  if constexpr (kRegions == Regions::kCutOffPoint) return to_cut_off_point(e, cone, from);
  const double radius = std::sqrt(from.difference * from.difference + from.shear * from.shear);
  const Principal principal = sorted(from.mean, radius, from.across);
  const ConeFlow flow = cone_flow(e, cone);
  const ConeReturn back =
      kRegions == Regions::kAll ? to_cone(flow, principal) : to_shear_plane(flow, principal);
  const PointStress to = turned_back(from, radius, back.stress);
  double sheared = (principal.s1 - back.stress.s1) * flow.sheared;
  if constexpr (kRegions == Regions::kAll) sheared = sheared_by(e, from, to);
  const bool moved = back.yields != kElastic;
  return {{moved ? to.mean : from.mean, moved ? to.difference : from.difference,
           moved ? to.shear : from.shear, moved ? to.across : from.across},
          moved ? sheared : 0,
          back.yields};
}

// With a weak plane the weaker alone takes the flow where that satisfies the other too, the plane first
// (admissible.hpp).
template <bool kPlane, Regions kRegions>
[[gnu::always_inline]] inline PointReturn to_strength(const Elasticity& e, const PlaneStrength& plane,
                                                      const YieldCone& cone, const PlaneDirection& direction,
                                                      const PointStress& from) {
  const PointReturn in_ground = to_ground<kRegions>(e, cone, from);
  if constexpr (!kPlane) return in_ground;
  const PlaneReturn on_plane = to_plane(e, plane, direction, from);
  const bool plane_alone = within(cone, on_plane.stress, rounding_of(on_plane.stress));
  const bool ground_alone =
      within(plane, traction(direction, in_ground.stress), rounding_of(in_ground.stress));
  const PointStress &a = on_plane.stress, &b = in_ground.stress;
  return {{plane_alone ? a.mean : b.mean, plane_alone ? a.difference : b.difference,
           plane_alone ? a.shear : b.shear, plane_alone ? a.across : b.across},
          plane_alone ? 0 : in_ground.sheared,
          plane_alone    ? on_plane.yields
          : ground_alone ? in_ground.yields
                         : kOpen};
}

template <bool kSoftens, bool kPlane, Regions kRegions>
[[gnu::always_inline]] inline bool returned(const Plasticity& law, Returning& z) {
  const double *mean = z.mean.data(), *across = z.across.data(), *cosine = z.cosine.data(),
               *sine = z.sine.data(), *strength = z.strength.data();
  const Elasticity elasticity = law.elasticity;
  const YieldCone same = law.cone;
  const PlaneStrength plane = law.plane;
  std::int64_t open = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double *difference = z.difference[k].data(), *shear = z.shear[k].data();
    const double *sin_friction = z.cones[0][k].data(), *sin_dilation = z.cones[1][k].data(),
                 *twice_c_cos = z.cones[2][k].data(), *tension = z.cones[3][k].data();
    double *to_mean = z.to_mean[k].data(), *to_difference = z.to_difference[k].data(),
           *to_shear = z.to_shear[k].data(), *to_across = z.to_across[k].data(),
           *sheared = z.sheared[k].data();
    std::int64_t* yields = z.yields[k].data();
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < z.count; ++i) {
      const PointStress from{mean[i], difference[i], shear[i], across[i]};
      const YieldCone common = times(strength[i], same);
      const YieldCone cone{
          kSoftens ? sin_friction[i] : common.sin_friction, kSoftens ? sin_dilation[i] : common.sin_dilation,
          kSoftens ? twice_c_cos[i] : common.twice_c_cos, kSoftens ? tension[i] : common.tension};
      const PointReturn back = to_strength<kPlane, kRegions>(elasticity, times(strength[i], plane), cone,
                                                             {cosine[i], sine[i]}, from);
      to_mean[i] = back.stress.mean;
      to_difference[i] = back.stress.difference;
      to_shear[i] = back.stress.shear;
      to_across[i] = back.stress.across;
      sheared[i] = back.sheared;
      yields[i] = back.yields;
    }
    for (std::uint32_t i = 0; i < z.count; ++i) open |= yields[i];
  }
  return open < 0;
}

template <bool kSoftens, bool kPlane>
[[gnu::always_inline]] inline bool returned(const Plasticity& law, Regions regions, Returning& zones) {
  if (regions == Regions::kAll) return returned<kSoftens, kPlane, Regions::kAll>(law, zones);
  if (regions == Regions::kShearPlane) return returned<kSoftens, kPlane, Regions::kShearPlane>(law, zones);
  return returned<kSoftens, kPlane, Regions::kCutOffPoint>(law, zones);
}

// Twice the elastic energy of a stress without shear in the plane.
[[gnu::always_inline]] inline double twice_energy(const Elasticity& e, double mean, double across) {
  const double pressure = (2 * mean + across) * (1.0 / 3), deviator = across - pressure;
  return pressure * pressure * (1 / e.bulk) + 0.75 * deviator * deviator * (1 / e.shear);
}

}  // namespace

ADIT_VECTOR_CLONES Outside find_outside(const Plasticity& law, std::uint32_t count,
                                        const StressView& stresses, const ConeView& cones,
                                        const DirectionView& directions, const double* strength,
                                        BatchFlags& outside) {
  if (law.softens)
    return law.has_plane
               ? outside_of<true, true>(law, count, stresses, cones, directions, strength, outside)
               : outside_of<true, false>(law, count, stresses, cones, directions, strength, outside);
  return law.has_plane ? outside_of<false, true>(law, count, stresses, cones, directions, strength, outside)
                       : outside_of<false, false>(law, count, stresses, cones, directions, strength, outside);
}

ADIT_VECTOR_CLONES bool return_points(const Plasticity& law, Regions regions, Returning& zones) {
  if (law.softens)
    return law.has_plane ? returned<true, true>(law, regions, zones)
                         : returned<true, false>(law, regions, zones);
  return law.has_plane ? returned<false, true>(law, regions, zones)
                       : returned<false, false>(law, regions, zones);
}

// Energy: nonlinear_zones.hpp.
ADIT_VECTOR_CLONES void average_and_dissipate(const Plasticity& law, Returning& z) {
  const Elasticity e = law.elasticity;
  const double lame = e.lame(), shear = e.shear, compliance = 1 / (2 * shear),
               bulk_compliance = 1 / (3 * e.bulk);
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < z.count; ++i) {
    double mean = 0, across = 0, area = 0, work = 0, left = 0;
    std::int64_t yields = 0;
    const double p = z.mean[i], zz = z.across[i], volume = z.volume[i];
    const auto add = [&](std::size_t k) {
      const double a = z.area[k][i];
      area += a;
      mean += a * z.to_mean[k][i];
      across += a * z.to_across[k][i];
      yields |= z.yields[k][i];
      const double p_lost = p - z.to_mean[k][i], zz_lost = zz - z.to_across[k][i];
      const double t_lost = z.difference[k][i] - z.to_difference[k][i],
                   s_lost = z.shear[k][i] - z.to_shear[k][i];
      const double pressure = (2 * p_lost + zz_lost) * (1.0 / 3);
      const double isotropic = pressure * bulk_compliance - pressure * compliance;
      // The sum of the stresses before and after the step on the plastic strain.
      const double p_sum = (p - (lame + shear) * volume) + z.to_mean[k][i];
      const double zz_sum = (zz - lame * volume) + z.to_across[k][i];
      const double t_sum = (z.difference[k][i] - shear * z.strain_difference[k][i]) + z.to_difference[k][i];
      const double s_sum = (z.shear[k][i] - shear * z.strain_shear[k][i]) + z.to_shear[k][i];
      work += a * (2 * p_sum * (isotropic + p_lost * compliance) + 2 * t_sum * t_lost * compliance +
                   zz_sum * (isotropic + zz_lost * compliance) + 2 * s_sum * s_lost * compliance);
    };
    add(0);
    add(1);
    add(2);
    add(3);
    const double share = 1 / area;
    mean *= share;
    across *= share;
    const auto average = [&](std::size_t k) {
      left += z.area[k][i] * twice_energy(e, z.to_mean[k][i] - mean, z.to_across[k][i] - across);
    };
    average(0);
    average(1);
    average(2);
    average(3);
    const bool moved = yields != 0;
    z.mean[i] = moved ? mean : p;
    z.across[i] = moved ? across : zz;
    z.dissipated[i] = moved ? 0.5 * (work + left) : 0;
  }
}

}  // namespace adit::fdm
