// One process at a time writes into a folder of results.
#pragma once

#include <filesystem>

namespace adit::results {

// The file by which a folder is locked. It stays, and tells later that the folder is one of results.
inline constexpr const char* kLockFile = ".lock";

// Holds the folder as long as it lives; the system lets go of it however the process ends.
class FolderLock {
 public:
  // Throws protocol::UserError, which names the process that holds the folder, or why it cannot be held.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int file_;  // descriptor, which no server inherits
};

}  // namespace adit::results
