// The state of the source from which a program was built.
#pragma once

#include <string_view>

namespace adit::protocol {

// The commit that was checked out, with " and changes" where files differed from it when it was read; empty
// for a build outside a git repository. cmake/revision.cmake writes the definition after each commit.
std::string_view revision();

}  // namespace adit::protocol
