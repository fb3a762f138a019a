// Room on the disk that is kept for the summary of a run that ends because the disk is full.
#pragma once

#include <filesystem>

namespace adit::results {

class Reserve {
 public:
  // Takes the room by a file `reserve` in the folder. Throws protocol::DiskFull where there is none.
  explicit Reserve(const std::filesystem::path& folder);
  ~Reserve() { release(); }
  Reserve(const Reserve&) = delete;
  Reserve& operator=(const Reserve&) = delete;

  void release();

 private:
  std::filesystem::path file_;
};

}  // namespace adit::results
