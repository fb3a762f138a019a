// Numbers with units: "30 GPa", "2.5 t/m^3", "-9.81 m/s^2".
#pragma once

#include <string>
#include <string_view>

namespace adit::protocol {

// The number that `text` gives, in `si_unit`. A number without a unit is in `si_unit` already, and an empty
// `si_unit` means a pure number. `inf` and `.inf` are infinity; the locale has no influence. Throws UserError
// without a path if the text is not a number, is NaN, lies beyond the range of a double, or has an unknown
// unit or one of another dimension.
double parse_quantity(std::string_view text, std::string_view si_unit);

// The quantity that a field in `si_unit` holds, and an example of it: "a pressure", "30 GPa".
std::string quantity_name(std::string_view si_unit);
std::string quantity_example(std::string_view si_unit);

}  // namespace adit::protocol
