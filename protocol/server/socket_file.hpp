// The file of a Unix socket at which a server listens.
#pragma once

#include <filesystem>

namespace adit::protocol {

// Removes the socket that a server left there when it was killed. Throws UserError if a server listens there,
// or the file is something else.
void make_room_for_socket(const std::filesystem::path& path);

// Nothing where the path is empty or the file has gone.
void remove_socket(const std::filesystem::path& path);

// A folder for the Unix socket of a server that one process alone uses.
// Only this user can enter it. It is removed with this object, which the server owns and not the process that
// started it: that one may be killed at any time, and the server ends with it.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }  // empty where none can be made

 private:
  std::filesystem::path path_;
};

}  // namespace adit::protocol
