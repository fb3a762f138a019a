#include "fdm_server/output/interface_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {

bool is_of_interface(scene::Quantity quantity) {
  return quantity == scene::OPENING || quantity == scene::OFFSET || quantity == scene::NORMAL_STRESS ||
         quantity == scene::SHEAR_STRESS;
}

InterfaceProbe resolve_interface_probe(const scene::History& history, const Supports& supports,
                                       const Grid& grid, const std::string& path) {
  const auto found = std::ranges::find(supports.interfaces, history.interface(), &Interface::name);
  if (found == supports.interfaces.end()) {
    std::vector<std::string> names;
    for (const Interface& interface : supports.interfaces) names.push_back(interface.name);
    throw protocol::UserError(
        path + ".interface",
        history.has_interface() ? "is `" + history.interface() +
                                      "`, but no interface of the continuum or of its linings has this name" +
                                      protocol::did_you_mean(history.interface(), names)
                                : std::string("is missing; name the interface that is observed"));
  }
  const auto distance = [&](std::uint32_t contact) {
    const auto point = supports.contacts.point(contact);
    return std::hypot(grid.x[point] - history.at().x(), grid.y[point] - history.at().y());
  };
  std::uint32_t nearest = found->first;
  for (std::uint32_t i = 0; i < found->count; ++i)
    if (distance(found->first + i) < distance(nearest)) nearest = found->first + i;
  // A place on the interface is at most about half a side from one of its points.
  if (const double side = supports.contacts.side(nearest); !(distance(nearest) <= 0.6 * side))
    throw protocol::UserError(
        path + ".at",
        fmt::format("lies {:.3g} m from the interface's nearest point ({:.6g}, {:.6g}) m; put it on "
                    "the interface",
                    distance(nearest), grid.x[supports.contacts.point(nearest)],
                    grid.y[supports.contacts.point(nearest)]));
  return {history.quantity(), nearest};
}

double value(const InterfaceProbe& probe, const Contacts& contacts) {
  const auto [normal, shear, opening, offset] = contacts.read(probe.contact);
  switch (probe.quantity) {
    case scene::OPENING:
      return opening;
    case scene::OFFSET:
      return offset;
    case scene::NORMAL_STRESS:
      return normal;
    default:
      return shear;
  }
}

}  // namespace adit::fdm
