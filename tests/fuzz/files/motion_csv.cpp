// A record as a table.
#include "protocol/motion/records/record_text.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kMotionCsv("motion_csv", [](std::string_view input) {
  read_or_refuse([&] { motion::parse_table(motion::split_text("x.csv", std::string(input)), {}); });
});

}  // namespace
}  // namespace adit::fuzz
