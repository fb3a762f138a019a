// Classes of reinforcing steel.
//
// `B500A`, `B500B`, `B500C` are classes of EN 1992-1-1:2004, annex C: f_yk = 500 MPa, (f_t/f_y)_k at least
// 1.05, 1.08 and 1.15, strain at the largest force eps_uk 2.5, 5 and 7.5 %, E_s = 200 GPa (3.2.7 (4)). Their
// mean yield strength is 1.1 f_yk (EN 1992-2:2005, 5.7 (105)).
// `HPB300`, `HRB400`, `HRB500` are classes of GB 50010-2010: f_yk and f_stk of table 4.2.2-1, E_s of table
// 4.2.5, strain at the largest force of table 4.2.4. Their means are f_yk / (1 - 1.645 delta) with delta =
// 8.95 % of plain and 7.43 % of ribbed bars (GB 50010-2002, table C.1.1).
// Partial factors: 1.15 (EN 1992-1-1, table 2.1N); of GB 50010 those of its table 4.2.3-1: f_y = 270, 360 and
// 435 MPa.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace adit::protocol {

struct Steel {
  double young_modulus;                                   // [Pa]
  double characteristic_yield, mean_yield, design_yield;  // f_yk, f_ym, f_yd [Pa]
  double hardening;                                       // f_t / f_y
  double ultimate_strain;                                 // eps_uk
  double design_strain;                                   // 0.9 eps_uk (EN, 3.2.7), 0.01 (GB 50010, 6.2.1)
};

// Nothing where no standard has a class of this name.
std::optional<Steel> steel_of(const std::string& name);

// Of all classes.
std::vector<std::string> names_of_steel();

}  // namespace adit::protocol
