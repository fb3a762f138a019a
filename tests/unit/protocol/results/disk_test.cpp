#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <utility>

#include "protocol/results/atomic_file.hpp"
#include "protocol/results/disk/growing_file.hpp"
#include "protocol/results/disk/reserve.hpp"
#include "protocol/results/disk/write_error.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results::disk_test {
namespace {

// While it lives, no file may be longer. The system then writes what has room and refuses the rest, as on a
// full disk.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

// Of a piece for which there is no room nothing stays: the file ends with the last whole one.
TEST(GrowingFile, EndsWithAWholePiece) {
  const ScratchFolder folder;
  GrowingFile file(folder / "a.csv");
  const FileLimit limit(10);
  file.append("1,2,3\n");
  EXPECT_THROW(file.append("4,5,6\n"), std::runtime_error);
  EXPECT_EQ(content_of(folder / "a.csv"), "1,2,3\n");
  EXPECT_EQ(file.size(), 6u);
}

// What a file was moved from closes nothing, standard output least of all.
TEST(GrowingFile, IsClosedOnce) {
  const ScratchFolder folder;
  {
    GrowingFile from(folder / "a.csv");
    GrowingFile file(std::move(from));
    file.append("1\n");
  }
  EXPECT_EQ(content_of(folder / "a.csv"), "1\n");
  EXPECT_GE(::fcntl(STDOUT_FILENO, F_GETFD), 0);
}

// Rows before the checkpoint that were edited since would stand among those of the run.
TEST(GrowingFile, DoesNotGoOnWithOtherContent) {
  const ScratchFolder folder;
  state::Archive writes;
  {
    GrowingFile file(folder / "a.csv");
    file.append("1\n");
    file.exchange(writes);
  }
  std::ofstream(folder / "a.csv") << "2\n3\n";
  GrowingFile file(folder / "a.csv", GrowingFile::Begin::kGoOn);
  state::Archive reads(writes.take());
  test::expect_refusal([&] { file.exchange(reads); }, "", "is not what the run wrote until the checkpoint");
}

// A file that goes on is cut to what it was when the state was written.
TEST(GrowingFile, GoesOnFromAState) {
  const ScratchFolder folder;
  state::Archive writes;
  {
    GrowingFile file(folder / "a.csv");
    file.append("1\n");
    file.exchange(writes);
    file.append("2\n3\n");
  }
  const state::Parts parts = writes.take();
  {
    GrowingFile file(folder / "a.csv", GrowingFile::Begin::kGoOn);
    state::Archive reads(parts);
    file.exchange(reads);
    file.append("4\n");
  }
  EXPECT_EQ(content_of(folder / "a.csv"), "1\n4\n");

  GrowingFile(folder / "a.csv").append("");
  GrowingFile shorter(folder / "a.csv", GrowingFile::Begin::kGoOn);
  state::Archive reads(parts);
  test::expect_refusal([&] { shorter.exchange(reads); }, "", "is shorter than it was at the checkpoint");
  test::expect_refusal([&] { GrowingFile(folder / "b.csv", GrowingFile::Begin::kGoOn); }, "", "is missing");
}

// A file that cannot be written whole is as it was, and no part lies beside it.
TEST(AtomicFile, LeavesNothingHalfWritten) {
  const ScratchFolder folder;
  replace_file(folder / "a.json", "old");
  {
    const FileLimit limit(10);
    EXPECT_THROW(replace_file(folder / "a.json", std::string(100, 'x')), std::runtime_error);
  }
  EXPECT_EQ(content_of(folder / "a.json"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.json.part"));
}

// The reserve takes its room at once, and gives it back.
TEST(Reserve, HoldsRoom) {
  const ScratchFolder folder;
  Reserve reserve(folder / ".");
  EXPECT_GE(std::filesystem::file_size(folder / "reserve"), 100'000u);
  reserve.release();
  EXPECT_FALSE(std::filesystem::exists(folder / "reserve"));
  const FileLimit limit(1000);
  EXPECT_ANY_THROW(Reserve(folder / "."));
  EXPECT_FALSE(std::filesystem::exists(folder / "reserve"));
}

// A full disk and a used quota are told apart from all other reasons.
TEST(WriteError, KnowsAFullDisk) {
  EXPECT_THROW(throw_write_error("a.csv", ENOSPC), protocol::DiskFull);
  EXPECT_THROW(throw_write_error("a.csv", EDQUOT), protocol::DiskFull);
  try {
    throw_write_error("a.csv", EACCES);
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(dynamic_cast<const protocol::DiskFull*>(&error), nullptr);
    EXPECT_THAT(error.what(), testing::HasSubstr("a.csv: Permission denied"));
  }
}

}  // namespace
}  // namespace adit::results::disk_test
