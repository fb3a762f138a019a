#include "protocol/participant/history.hpp"

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

}  // namespace adit::protocol
