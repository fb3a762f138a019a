#include "protocol/participant/peak_motion.hpp"

#include <string>

namespace adit::protocol {

void add_peak_fields(const PeakMotion& peaks, google::protobuf::RepeatedPtrField<wire::Field>& fields) {
  const auto add = [&](const std::string& name, std::span<const double> values) {
    wire::Field& field = *fields.Add();
    field.set_name(name);
    field.set_components(1);
    field.mutable_values()->Assign(values.begin(), values.end());
  };
  add("peak_displacement_m", peaks.displacement());
  add("peak_velocity_m_per_s", peaks.velocity());
  add("peak_acceleration_m_per_s2", peaks.acceleration());
}

}  // namespace adit::protocol
