// The two ends of a connection.
#pragma once

namespace adit::protocol {

enum class End { kClient, kServer };

}  // namespace adit::protocol
