// Thin strips of a hexagonal lattice that stretch and bend like the solid that they stand for.
//
// A strip of n rows has n rows of bonds along it, but only n - 1 layers of slanting ones. Of the axial
// stiffness of the solid the rows have the share f_r, the slanting layers the rest f_d, with k = ks / kn
//   f_r = (3 + k) / (3 (1 + k)),    f_d = 1 - f_r,    a = f_d / f_r = 2k / (3 + k).
// Relative to the solid of height n sqrt(3) R its axial stiffness is therefore 1 - f_d / n. Its bending
// stiffness is f_r (n^2 - 1) / n^2 + f_d (n - 1)(n - 2) / n^2: the rows and the layers are sums over their
// heights, where the solid has an integral. A layer of slanting bonds is free to become thicker or thinner,
// so that it does not mind what the bonds along the rows do. So factors c1 = 1 + d1 on the normal stiffness
// of the bonds along the outermost row on either side, c2 = 1 + d2 along the second ones, make both exact if
// they satisfy
//   2 d1 + m d2 = a,
//   2 d1 (n - 1)^2 / 4 + m d2 (n - 3)^2 / 4 = n (1 + a (3n - 2)) / 12,
// m = 2, or 1 for n = 3, where one row is the second one from either side.
//
// The strength of the outermost bonds follows, so that a strip in bending breaks at the same stress of its
// outer fibre as the solid: their strain is (n - 1) / n of that of the outer fibre, half a row further out.
// The bonds of the second rows break at the strain at which those of the solid break.
#pragma once

#include <cstdint>
#include <span>

#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

inline constexpr std::uint32_t kFewestRows = 3;

struct StripFactors {
  BondFactors outermost, second;
};
// Of at least three rows. The second factor of three rows is positive only where ks < 3 kn.
StripFactors strip_factors(std::uint32_t rows, const BondStiffness& stiffness);

// Rows of a full hexagonal packing.
std::uint32_t rows_of(const Discs& discs);

// Puts the factors on the bonds along the two outer rows on either side. The discs are a full hexagonal
// packing of at least three rows, all joined by contact bonds of one law.
void stiffen_outer_rows(Model& model);

// Whether some disc of the lowest row and one of the highest have the weight 1: an overlap along a face
// leaves none.
bool faces_are_free(const Discs& discs, std::span<const double> weights);

}  // namespace adit::dem
