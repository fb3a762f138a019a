// What an engine's observers have for the summary of the run.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dem_server/engines/answers.hpp"
#include "dem_server/lining/envelope.hpp"
#include "dem_server/lining/ovals.hpp"
#include "dem_server/lining/use_peaks.hpp"
#include "dem_server/observe/bar_peaks.hpp"
#include "dem_server/observe/widest_crack.hpp"

namespace adit::dem {

// sections_largest_thrust_N, sections_smallest_thrust_N and so for moment_Nm and shear_N: over all sections
// and times, each with its …_time_s and the middle of its section, …_x_m and …_y_m. None where there are no
// sections.
std::vector<Figure> figures_of(const Sections& sections, const Envelope& envelope);

// sections_largest_utilisation with sections_thrust_at_largest_utilisation_N and
// sections_moment_at_largest_utilisation_Nm, and sections_largest_shear_utilisation with
// sections_shear_at_largest_shear_utilisation_N and sections_thrust_at_largest_shear_utilisation_N, and
// sections_largest_moment_ratio with sections_damage_state: over all sections with a strength, with time and
// place. None where there are no such sections.
std::vector<Figure> figures_of(const Sections& sections, const UsePeaks& peaks);

// ovals_largest_diameter_change_m and ovals_smallest_diameter_change_m: over all ovals and times, each with
// its …_time_s, the direction of that diameter, …_direction_rad, and the middle of its oval, …_x_m and …_y_m.
// None where there are no ovals.
std::vector<Figure> figures_of(std::span<const Oval> ovals, const OvalEnvelope& envelope);

// Springs that broke, and where and when the first did [s], [m].
struct SpringBreaks {
  std::size_t count = 0;
  double time = 0, x = 0, y = 0;
};

// springs_broken, and where any is, first_broken_spring_time_s, …_x_m, …_y_m.
std::vector<Figure> figures_of(const SpringBreaks& breaks);

// largest_crack_width_m over all cracks between cells and all times, with its …_time_s, …_x_m and …_y_m. None
// where none stood open.
std::vector<Figure> figures_of(const WidestCrack& widest);

// bars_largest_stress_Pa, bars_largest_force_N, bars_largest_strain and bars_largest_slip_m, by size and with
// their signs, each with its …_time_s, …_x_m and …_y_m.
std::vector<Figure> figures_of(const BarPeaks& peaks);

}  // namespace adit::dem
