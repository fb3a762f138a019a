// What an engine's observers have for the summary of the run.
#pragma once

#include <cstddef>
#include <vector>

#include "dem_server/engines/answers.hpp"
#include "dem_server/lining/envelope.hpp"

namespace adit::dem {

// sections_largest_thrust_N, sections_smallest_thrust_N and so for moment_Nm and shear_N: over all sections
// and times, each with its …_time_s and the middle of its section, …_x_m and …_y_m. None where there are no
// sections.
std::vector<Figure> figures_of(const Sections& sections, const Envelope& envelope);

// Springs that broke, and where and when the first did [s], [m].
struct SpringBreaks {
  std::size_t count = 0;
  double time = 0, x = 0, y = 0;
};

// springs_broken, and where any is, first_broken_spring_time_s, …_x_m, …_y_m.
std::vector<Figure> figures_of(const SpringBreaks& breaks);

}  // namespace adit::dem
