// The rules of the scene's definition (rule.proto), checked in a message by protobuf reflection. Whoever
// reads a scene calls this once, after the file or on arrival; what reads the fields may then rely on every
// rule.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace adit::protocol {

// `path`: where `message` stands in the scene, empty for the scene itself. In each message the given fields
// are checked first, in the order of the definition: numbers are finite and within their limits, lists have
// their length and order. Then what is required must be there, and fields must stand in the relation that
// they name. Before all, a message must hold nothing that this release does not know, such as a newer one
// would send: the model would be another one without it. The first breach throws UserError with the path of
// the field, what it is and what was expected.
void check_rules(const google::protobuf::Message& message, const std::string& path = {});

}  // namespace adit::protocol
