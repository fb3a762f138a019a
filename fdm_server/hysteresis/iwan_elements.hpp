// Strain-dependent shear modulus with hysteretic damping: Iwan's parallel elements (Iwan 1967, J. Appl. Mech.
// 34).
//
// The stress deviator is the sum of N elastic, perfectly plastic elements (von Mises) that all have the
// strain of the ground. Element i has the shear modulus G_i and yields at the shear strain x_i. In simple
// shear the sum is the polyline backbone of slopes H_k = sum over i > k of G_i; unloading and reloading from
// any reversal follow that backbone doubled, and meet earlier branches as Masing's extended rules say,
// because each element must be driven back twice its yield strain: the rules are a consequence, for every
// strain path in the plane and across it. Each element dissipates, hence so does the sum. The volume changes
// elastically.
//
// Elements are kept as what they flowed: q_i, so that element i has the stress G_i (e - q_i), e the deviator
// of strain since the start. Only elements that yield change. Their distance from yielding, x_i - |e - q_i|,
// shrinks by no more than the length of the strain path: elements sleep until the path could bring one of
// them to its limit, and a step without any awake adds G de to the stress (zones/laws/element_kernels.hpp).
#pragma once

#include <span>
#include <vector>

#include "fdm_server/hysteresis/modulus_reduction.hpp"

namespace adit::fdm {

struct IwanElements {
  std::vector<double> stiffness, limit;  // of each: G_i over the initial modulus, x_i
};
IwanElements iwan_elements(std::span<const BackbonePoint> backbone);

}  // namespace adit::fdm
