// What the programs tell on standard output and standard error. A terminal may go away, a disk may be full, a
// reader may end: what cannot be written is left out, and the run goes on.
#pragma once

#include <string_view>

namespace adit::protocol {

// To be called first in main(): descriptors 0, 1 and 2 that are closed become /dev/null, so that no socket
// and no file of results gets the number of one and with it what is told; and writing to a reader that has
// ended, or beyond the longest file that is allowed, is an error like others, not a signal.
void guard_standard_streams();

// Writes the text at once.
void print(std::string_view text);
void print_error(std::string_view text);

}  // namespace adit::protocol
