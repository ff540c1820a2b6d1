#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "geometry/error.h"
#include "tests/support/run_program.h"

namespace toile {
namespace output_file_test {

using Names = std::vector<std::string>;
using pipeline::read_text;
using pipeline::ScratchFolder;
using pipeline::write_text;

/// While one lives, files end at 1 kB, as on a full disk.
class SmallDisk {
 public:
  SmallDisk() {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small = before_;
    small.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_ = {};
};

TEST(OutputFile, ReplacesTheFileAtCommitAndNotBefore) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "old");
  {
    OutputFile file(folder / "a.txt");
    file.stream() << "new";
    file.stream().flush();
    EXPECT_EQ(read_text(folder / "a.txt"), "old");
    file.commit();
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
  { OutputFile(folder / "a.txt").stream() << "given up"; }
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
  EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(OutputFile, WhatIsNotWrittenWholeIsNotPutInPlace) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "old");
  const std::string content(5000, 'x');
  {
    OutputFile file(folder / "a.txt");
    const SmallDisk disk;
    file.stream() << content;
    EXPECT_THROW(file.commit(), Error);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  {
    OutputFile file(folder / "a.txt");
    file.stream() << "a part";
    file.stream().setstate(std::ios::badbit);
    EXPECT_THROW(file.commit(), Error);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  {
    const SmallDisk disk;
    EXPECT_THROW(write_file(folder / "a.txt", content), Error);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(OutputFile, ALinkStaysAndItsFileIsReplaced) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "there");
  write_text(folder / "there" / "a.txt", "old");
  std::filesystem::create_symlink("there/a.txt", folder / "link.txt");
  std::filesystem::create_symlink("there/none.txt", folder / "dangling.txt");
  write_file(folder / "link.txt", "new");
  write_file(folder / "dangling.txt", "made");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read_text(folder / "there" / "a.txt"), "new");
  EXPECT_EQ(read_text(folder / "there" / "none.txt"), "made");
}

TEST(OutputFile, FoldersDevicesPipesAndLockedFilesAreRefused) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "folder");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/null", folder / "link");
  for (const std::filesystem::path& path :
       {folder / "folder", folder / "pipe", folder / "link", std::filesystem::path("/dev/null"),
        std::filesystem::path("/dev/full"), std::filesystem::path("/dev/stdout"),
        std::filesystem::path("/dev/fd/1"), std::filesystem::path("/proc/self/fd/1")}) {
    EXPECT_THROW(check_writable(path), Error) << path;
    EXPECT_THROW(write_file(path, "text"), Error) << path;
  }
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  if (geteuid() == 0) return;  // root may write everything
  write_text(folder / "locked", "old");
  ASSERT_EQ(chmod((folder / "locked").c_str(), 0400), 0);
  EXPECT_THROW(check_writable(folder / "locked"), Error);
  EXPECT_EQ(read_text(folder / "locked"), "old");
}

TEST(OutputFiles, AllAreReplacedOrNone) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "old");
  write_text(folder / "b.txt", "old");
  {
    OutputFiles files;
    write_file(files.at(folder / "a.txt"), "new");
    EXPECT_EQ(read_text(files.written(folder / "a.txt")), "new");
    const SmallDisk disk;
    EXPECT_THROW(write_file(files.at(folder / "b.txt"), std::string(5000, 'x')), Error);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names(), (Names{"a.txt", "b.txt"}));
  OutputFiles files;
  write_file(files.at(folder / "a.txt"), "first");
  write_file(files.at(folder / "a.txt"), "new a");
  write_file(files.at(folder / "b.txt"), "new b");
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  files.commit();
  EXPECT_EQ(read_text(folder / "a.txt"), "new a");
  EXPECT_EQ(read_text(folder / "b.txt"), "new b");
  EXPECT_EQ(folder.names(), (Names{"a.txt", "b.txt"}));
}

TEST(SameFile, ByAnyNameAndByLinksOfBothKinds) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "a");
  write_text(folder / "b.txt", "b");
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink("a.txt", folder / "link.txt");
  std::filesystem::create_symlink("none.txt", folder / "dangling.txt");
  std::filesystem::create_symlink(folder.path(), folder / "here");
  std::filesystem::create_hard_link(folder / "a.txt", folder / "hard.txt");
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "a.txt"));
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "./sub/../a.txt"));
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "here/a.txt"));
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "link.txt"));
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "hard.txt"));
  EXPECT_TRUE(same_file(folder / "a.txt", folder / "A.TXT"));
  EXPECT_TRUE(same_file(folder / "none.txt", folder / "here/none.txt"));
  EXPECT_TRUE(same_file(folder / "none.txt", folder / "dangling.txt"));
  EXPECT_TRUE(same_file("none.txt", "./none.txt"));
  EXPECT_FALSE(same_file(folder / "a.txt", folder / "b.txt"));
  EXPECT_FALSE(same_file(folder / "a.txt", folder / "sub/a.txt"));
  EXPECT_FALSE(same_file(folder / "none.txt", folder / "other.txt"));
}

}  // namespace output_file_test
}  // namespace toile
