// A record of the PEER database.
#include "protocol/motion/records/record_text.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kAt2("at2", [](std::string_view input) {
  read_or_refuse([&] { motion::parse_at2(motion::split_text("x.AT2", std::string(input))); });
});

}  // namespace
}  // namespace adit::fuzz
