#include "io/temporary_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <list>
#include <set>

#include "io/output_file.h"
#include "tests/support/run_program.h"

namespace toile {
namespace temporary_file_test {

using Names = std::vector<std::string>;

/// Runs `work` in another process. Returns the signal that ended it; 0: it came to its end.
template <class Work>
int signal_that_ends(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

TEST(TemporaryFile, ASignalRemovesAllBeforeItEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    const pipeline::ScratchFolder folder;
    pipeline::write_text(folder / "a.txt", "old");
    const int ended = signal_that_ends([&] {
      std::signal(signal, SIG_DFL);
      remove_temporary_files_on_signals();
      OutputFiles files;
      write_file(files.at(folder / "a.txt"), "new");
      write_file(files.at(folder / "b.txt"), "new");
      OutputFile half(folder / "c.txt");
      half.stream() << "a part" << std::flush;
      std::raise(signal);
    });
    EXPECT_EQ(ended, signal);
    EXPECT_EQ(folder.names(), Names{"a.txt"});
    EXPECT_EQ(pipeline::read_text(folder / "a.txt"), "old");
  }
}

TEST(TemporaryFile, ASignalWaitsUntilAllFilesAreInPlace) {
  const pipeline::ScratchFolder folder;
  const int ended = signal_that_ends([&] {
    remove_temporary_files_on_signals();
    OutputFiles files;
    write_file(files.at(folder / "a.txt"), "new");
    write_file(files.at(folder / "b.txt"), "new");
    const SignalsWait wait;
    std::raise(SIGTERM);
    files.commit();
  });
  EXPECT_EQ(ended, SIGTERM);
  EXPECT_EQ(folder.names(), (Names{"a.txt", "b.txt"}));
}

TEST(TemporaryFile, AnIgnoredSignalStaysIgnored) {
  const pipeline::ScratchFolder folder;
  const int ended = signal_that_ends([&] {
    std::signal(SIGHUP, SIG_IGN);
    remove_temporary_files_on_signals();
    OutputFile file(folder / "a.txt");
    std::raise(SIGHUP);
    file.commit();
  });
  EXPECT_EQ(ended, 0);
  EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(TemporaryFile, ALinkLaidAtANameIsNotFollowed) {
  const pipeline::ScratchFolder folder;
  pipeline::write_text(folder / "victim.txt", "old");
  std::filesystem::create_symlink("victim.txt", folder / "link");
  std::filesystem::create_symlink("none.txt", folder / "dangling");
  for (const char* name : {"link", "dangling", "victim.txt"}) {
    EXPECT_EQ(make_new_file(folder / name), -1) << name;
    EXPECT_EQ(errno, EEXIST) << name;
  }
  // The name that a file of this process had once.
  const std::string foreseen = "a.txt.part" + std::to_string(getpid());
  std::filesystem::create_symlink("victim.txt", folder / foreseen);
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(pipeline::read_text(folder / "a.txt"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "a.txt"));
  EXPECT_EQ(pipeline::read_text(folder / "victim.txt"), "old");
  EXPECT_EQ(folder.names(), (Names{"a.txt", foreseen, "dangling", "link", "victim.txt"}));
}

TEST(TemporaryFile, WhatIsPutUnderItsNameIsNotWritten) {
  const pipeline::ScratchFolder folder;
  pipeline::write_text(folder / "victim.txt", "old");
  OutputFile file(folder / "a.txt");
  std::filesystem::remove(file.temporary());
  std::filesystem::create_symlink("victim.txt", file.temporary());
  file.stream() << "new";
  file.finish();
  EXPECT_EQ(pipeline::read_text(folder / "victim.txt"), "old");
}

TEST(TemporaryFile, FilesForOnePathHaveNamesOfTheirOwn) {
  const pipeline::ScratchFolder folder;
  std::set<std::string> names;
  std::list<TemporaryFile> files;
  for (int i = 0; i < 50; ++i) {
    const TemporaryFile& file = files.emplace_back(folder / "a.txt");
    ASSERT_TRUE(file.is_open());
    EXPECT_TRUE(file.name().filename().string().starts_with("a.txt.part"));
    names.insert(file.name().string());
  }
  EXPECT_EQ(names.size(), 50u);
  EXPECT_EQ(folder.names().size(), 50u);
  files.clear();
  EXPECT_EQ(folder.names(), Names{});
  EXPECT_FALSE(TemporaryFile(folder / "none" / "a.txt").is_open());
}

TEST(TemporaryFile, HasTheModeThatTheUmaskLeaves) {
  const pipeline::ScratchFolder folder;
  for (const mode_t mask : {0022, 0077, 0002}) {
    const mode_t before = umask(mask);
    write_file(folder / "a.txt", "text");
    umask(before);
    struct stat status = {};
    ASSERT_EQ(stat((folder / "a.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0666 & ~mask);
  }
}

}  // namespace temporary_file_test
}  // namespace toile
