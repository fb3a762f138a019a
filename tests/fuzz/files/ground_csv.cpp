// The motion of the ground beside a model, and that of a rigid body, as tables.
#include "protocol/foundation/body_course.hpp"
#include "protocol/foundation/read.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kGroundCsv("ground_csv", [](std::string_view input) {
  scene::Foundation foundation;
  foundation.mutable_ground()->set_content(std::string(input));
  read_or_refuse([&] { foundation::read_ground(foundation, "foundation"); });
  scene::BodyMotion body;
  body.set_content(std::string(input));
  read_or_refuse([&] { foundation::BodyCourse(body, "body").at(0.1); });
});

}  // namespace
}  // namespace adit::fuzz
