// A record of any format, which its content tells, with and without what a scene may state of it.
#include "protocol/motion/records/records.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kRecords("records", [](std::string_view input) {
  for (const motion::RecordKeys& keys :
       {motion::RecordKeys{}, {.column = "2"}, {.column = "ns", .time_step = 0.01, .unit = "gal"}})
    read_or_refuse([&] { motion::parse_motion("record", std::string(input), keys); });
});

}  // namespace
}  // namespace adit::fuzz
