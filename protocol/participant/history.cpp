#include "protocol/participant/history.hpp"

#include "protocol/errors.hpp"
#include "protocol/messages/rule.pb.h"
#include "protocol/text.hpp"

namespace adit::protocol {

std::string column_of(const scene::History& history) {
  const auto* value = scene::Quantity_descriptor()->FindValueByNumber(history.quantity());
  return history.name() + "_" + value->options().GetExtension(scene::column);
}

std::string name_of(scene::Quantity quantity) {
  return lower_case(scene::Quantity_Name(quantity));
}

bool is_motion(scene::Quantity quantity) {
  switch (quantity) {
    case scene::DISPLACEMENT_X:
    case scene::DISPLACEMENT_Y:
    case scene::VELOCITY_X:
    case scene::VELOCITY_Y:
    case scene::ACCELERATION_X:
    case scene::ACCELERATION_Y:
      return true;
    default:
      return false;
  }
}

void require_relative_motion(const scene::History& history, const std::string& path) {
  if (history.has_relative_to() && !is_motion(history.quantity()))
    throw UserError(path + ".relative_to", "stands beside " + name_of(history.quantity()) +
                                               ", but only a displacement, velocity or acceleration counts "
                                               "against another place; leave it out");
}

void require_strength(const scene::History& history, bool stated, const std::string& section,
                      const std::string& path) {
  const bool use = history.quantity() == scene::UTILISATION || history.quantity() == scene::SHEAR_STRENGTH;
  require(!use || stated, path + ".section",
          "is " + quote(history.section()) + ", whose strength is not stated, but the quantity is " +
              name_of(history.quantity()) + "; give " + section + " a `section`");
}

}  // namespace adit::protocol
