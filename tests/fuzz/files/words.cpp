// The words of a scene and of a command line: a quantity, a path of a field, an address.
#include "protocol/motion/records/records.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/fields/quantity.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/address.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kWords("words", [](std::string_view input) {
  for (const char* unit : {"", "m", "Pa*s/m"}) read_or_refuse([&] { protocol::parse_quantity(input, unit); });
  read_or_refuse([&] { protocol::parse_unit(input); });
  read_or_refuse([&] { motion::acceleration_unit(input); });
  read_or_refuse([&] { protocol::parse_address(input); });
  protocol::parse_path(input);
  require_one_line(protocol::one_line(input).c_str());
});

}  // namespace
}  // namespace adit::fuzz
