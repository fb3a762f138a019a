#include "protocol/release.hpp"

namespace adit::protocol {

std::string_view release() {
  return ADIT_RELEASE;
}

}  // namespace adit::protocol
