// What interfaces went through, for the summary of the run.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/interfaces/contact_peaks.hpp"
#include "fdm_server/interfaces/contacts.hpp"
#include "fdm_server/interfaces/interface.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// Of each interface, over its contacts and since time began: interface_<name>_largest_offset_m and
// _largest_shear_stress_Pa, by size and with their signs, _largest_opening_m and _largest_pressure_Pa, each
// with its …_time_s, …_x_m and …_y_m. Of equal ones the first. None before the first step.
void add_figures(const Grid& grid, std::span<const Interface> interfaces, const Contacts& contacts,
                 const ContactPeaks& peaks, wire::Bye& bye);

}  // namespace adit::fdm
