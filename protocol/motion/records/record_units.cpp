#include <cmath>
#include <string>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/motion/records/records.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/text.hpp"

namespace adit::motion {

using protocol::quote;
using protocol::UserError;

double acceleration_unit(std::string_view unit) {
  std::string name = protocol::lower_case(unit);
  for (const auto& [peer, ours] : {std::pair{"sec", "s"}, std::pair{"**", "^"}})
    for (std::size_t at = name.find(peer); at != std::string::npos; at = name.find(peer))
      name.replace(at, std::string_view(peer).size(), ours);
  const auto refuse = [&] {
    throw UserError("",
                    quote(unit) + " is not a unit of acceleration; give one such as g, gal, cm/s^2 or m/s^2");
  };
  protocol::Unit found;
  try {
    found = protocol::parse_unit(name);
  } catch (const UserError&) {
    refuse();
  }
  if (found.dimension != protocol::Dimension{.length = 1, .time = -2}) refuse();
  return found.factor * std::pow(10.0, found.decimals);
}

}  // namespace adit::motion
