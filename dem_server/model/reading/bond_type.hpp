// What joins two discs, before their sizes are known.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "dem_server/model/calibration.hpp"
#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

struct BondType {
  // Lengths are shares: of a parallel bond its half width of the smaller radius, of a smooth joint its length
  // of the smaller diameter.
  std::variant<ContactBond, ParallelBond, SmoothJoint> law;
  double reach;  // discs are joined whose gap is at most this share of their mean radius
};

// `otherwise`: stiffnesses of a contact bond that the scene leaves out.
BondType read_bond_type(const scene::Bonds& bonds, const std::string& path,
                        const std::function<BondStiffness()>& otherwise);
BondType read_smooth_joint(const scene::SmoothJoint& joint, double reach);

// Between discs of two groups: stiffnesses in series, the smaller strengths, width and reach. No value for
// two laws of different kinds.
std::optional<BondType> between(const BondType& a, const BondType& b);

}  // namespace adit::dem
