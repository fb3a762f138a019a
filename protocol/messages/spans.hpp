// Repeated numbers of a message as spans.
#pragma once

#include <google/protobuf/repeated_field.h>

#include <span>

namespace adit::protocol {

inline std::span<const double> view(const google::protobuf::RepeatedField<double>& field) {
  return {field.data(), static_cast<std::size_t>(field.size())};
}

// Gives the field this many numbers, all to be written by the caller; its memory stays from step to step.
inline std::span<double> resize(google::protobuf::RepeatedField<double>& field, std::size_t size) {
  const int count = static_cast<int>(size);
  field.Clear();
  if (count == 0) return {};
  field.Reserve(count);
  return {field.AddNAlreadyReserved(count), size};
}

}  // namespace adit::protocol
