// The release of the programs.
#pragma once

#include <string_view>

namespace adit::protocol {

// This program's version, as in "0.1.0".
std::string_view release();

}  // namespace adit::protocol
