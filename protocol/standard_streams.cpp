#include "protocol/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>

#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

// What files and peers say may hold characters that a terminal obeys.
std::string fit_for_terminals(std::string_view text) {
  constexpr std::string_view kKept = "\n\r\t";
  std::string fit;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(kKept), text.size());
    fit += one_line(text.substr(0, end));
    if (end < text.size()) fit += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return fit;
}

void write(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
  std::clearerr(stream);
}

}  // namespace

void guard_standard_streams() {
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", O_RDWR);  // which takes the lowest free number: this one
}

void print(std::string_view text) {
  write(stdout, fit_for_terminals(text));
}

void print_error(std::string_view text) {
  write(stderr, fit_for_terminals(text));
}

}  // namespace adit::protocol
