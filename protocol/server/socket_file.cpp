#include "protocol/server/socket_file.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

using boost::asio::local::stream_protocol;

bool somebody_listens(const std::filesystem::path& path) {
  boost::asio::io_context io;
  stream_protocol::socket socket(io);
  socket.open();
  socket.native_non_blocking(true);
  const stream_protocol::endpoint endpoint(path.string());
  return ::connect(socket.native_handle(), endpoint.data(), static_cast<socklen_t>(endpoint.size())) == 0 ||
         errno == EAGAIN;  // its queue is full
}

}  // namespace

void make_room_for_socket(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  if (status.type() != std::filesystem::file_type::socket)
    throw UserError(
        "", fmt::format("cannot listen on unix:{}: a file that is no socket is there; remove it, or choose "
                        "another path",
                        path.string()));
  if (somebody_listens(path))
    throw UserError(
        "", fmt::format("unix:{} is in use: stop the server that listens there, or choose another path",
                        path.string()));
  remove_socket(path);
}

void remove_socket(const std::filesystem::path& path) {
  if (!path.empty()) ::unlink(path.c_str());
}

// In /tmp, because the path of a Unix socket must be short.
PrivateFolder::PrivateFolder() {
  std::string name = fmt::format("/tmp/adit-{}-XXXXXX", ::getpid());
  if (::mkdtemp(name.data()) != nullptr) path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace adit::protocol
