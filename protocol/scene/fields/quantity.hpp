// Numbers with units: "30 GPa", "2.5 t/m^3", "-9.81 m/s^2".
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// The number that `text` states, in `si_unit`; a number without unit is in `si_unit` already. An empty
// `si_unit` asks for a pure number. Independent of the locale; `inf` and `.inf` are infinity. Throws
// UserError (with no path) for anything else: no number, not a number, beyond the range of a double, unknown
// unit, unit of another dimension.
double parse_quantity(std::string_view text, std::string_view si_unit);

// What a field in `si_unit` holds and how it may be written: "a pressure", "30 GPa".
std::string quantity_name(std::string_view si_unit);
std::string quantity_example(std::string_view si_unit);

}  // namespace adit::protocol
