// Adds the path of a scene's field to the errors of motions, which are independent of scenes.
#pragma once

#include <string>

#include "protocol/errors.hpp"

namespace adit::motion {

template <class Work>
auto errors_at(const std::string& field, Work&& work) {
  try {
    return work();
  } catch (const protocol::UserError& error) {
    throw protocol::UserError(error.path().empty() ? field : error.path(), error.what());
  }
}

}  // namespace adit::motion
