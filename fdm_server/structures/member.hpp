// The beams of a member fail together: in shear, then under their thrust; or by crushing.
//
// Shear: the beam whose shear force first exceeds the strength V of its section with its thrust
// (sections/shear_capacity.hpp) slides from the next step on. What it passes falls with the slip d,
//   V (1 - (1 - r) min(d/d_r, 1)).
// Axial failure, once it slides: the drift of the member, how far one end has moved across the other over its
// length, reaches that of Elwood and Moehle (2005, Earthquake Spectra 21, 71-89, eq. 9), shear friction on a
// plane at 65 degrees between stirrups,
//   (4/100) (1 + tan^2 t)/(tan t + P s/(A_st f_yt d_c tan t)),   t = 65 degrees,
// with P the compression of that instant, d_c the depth of the core. Crushing: the concrete is strained
// beyond the end of its curve (concrete_law.hpp) throughout a section; bars alone would buckle. In both cases
// this beam is lost.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "fdm_server/structures/beam.hpp"
#include "fdm_server/structures/member_beam.hpp"
#include "protocol/sections/shear_capacity.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// Per metre of thickness of the plane, as the section's shape.
struct MemberStrength {
  sections::ShearMaterials shear;
  double residual, sliding;  // r, d_r [m]
  double core;               // d_c [m]
};

// The drift at which a member that slides fails under this thrust.
double axial_failure_drift(const MemberStrength& strength, double thrust);

class Member {
 public:
  Member(std::uint32_t first_beam, std::uint32_t beams, const MemberStrength& strength)
      : first_(first_beam), count_(beams), strength_(strength) {}

  std::uint32_t first_beam() const { return first_; }
  std::uint32_t count() const { return count_; }

  // When [s] it failed in each way, negative: it did not.
  struct Times {
    double shear = -1, axial = -1, crushed = -1;
  };
  const Times& failed() const { return failed_; }
  // What shear force it still passes, once it has failed [N per metre].
  std::optional<double> left() const;

  // After the forces of a step are known; of its own beams.
  void look(std::span<const Beam> beams, std::span<MemberBeam> member_beams, double time);

  void exchange(state::Archive& archive) {
    archive("member_failed", failed_);
    archive("member_sliding_beam", sliding_);
    archive("member_shear_strength", shear_strength_);
    archive("member_left", left_);
  }

 private:
  void slide(std::span<const Beam> beams, std::span<MemberBeam> member_beams, double time);

  std::uint32_t first_, count_;
  MemberStrength strength_;
  Times failed_{};
  std::uint32_t sliding_ = 0;             // its number among them, once it has failed in shear
  double shear_strength_ = 0, left_ = 0;  // V, what is left of it [N]
};

}  // namespace adit::fdm
