#include "fdm_server/participant/interface_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fdm_server/participant/figures.hpp"

namespace adit::fdm {

void add_figures(const Grid& grid, std::span<const Interface> interfaces, const Contacts& contacts,
                 const ContactPeaks& peaks, wire::Bye& bye) {
  if (peaks.empty()) return;
  Figures figures(grid, bye);
  for (const auto& [name, first, count, closed] : interfaces) {
    const auto add_largest = [&](const std::string& what, const std::string& unit,
                                 const std::vector<ContactPeaks::Peak>& of) {
      const auto rows = std::span(of).subspan(first, count);
      const auto largest =
          std::ranges::max_element(rows, {}, [](const auto& peak) { return std::abs(peak.value); });
      const auto point = contacts.point(first + static_cast<std::uint32_t>(largest - rows.begin()));
      const std::string figure = "interface_" + name + "_largest_" + what;
      figures.add(figure + unit, largest->value);
      figures.add_when_and_where(figure, largest->time, point);
    };
    add_largest("offset", "_m", peaks.offset());
    add_largest("opening", "_m", peaks.opening());
    add_largest("pressure", "_Pa", peaks.pressure());
    add_largest("shear_stress", "_Pa", peaks.shear_stress());
  }
}

}  // namespace adit::fdm
