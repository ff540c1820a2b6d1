#include "io/temporary_file.h"

#include <gtest/gtest.h>

#include <csignal>

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

}  // namespace temporary_file_test
}  // namespace toile
