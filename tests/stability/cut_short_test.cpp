// Case 8: runs that are killed, disks that are full, folders that may not be written.
#include <pwd.h>
#include <sys/mount.h>

#include <random>
#include <thread>

#include "io/mesh_file.h"
#include "pattern/file/garment_file.h"
#include "tests/stability/hard_case.h"

namespace toile::test {
namespace cut_short_test {

using pipeline::read_text;
using pipeline::write_text;

/// Starts a program in silence; 0 in `seconds` lets it end by itself.
int ended(const std::vector<std::string>& words, double seconds) {
  std::vector<std::string> all = words;
  all.front() = (fs::path(TOILE_TOOLS_DIR) / words.front()).string();
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDERR_FILENO);
    dup2(null, STDOUT_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  if (seconds > 0) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

class CutShort : public HardCase {
 protected:
  /// Whole: the reader takes it, and it is the one that a run which was left alone wrote. The
  /// report's times differ.
  static void expect_whole(const fs::path& path, const fs::path& reference) {
    if (path.extension() == ".json" && path.string().find("report") != std::string::npos) {
      EXPECT_EQ(Json::parse(read_text(path))["verdict"],
                Json::parse(read_text(reference))["verdict"])
          << path;
    } else {
      EXPECT_EQ(read_text(path), read_text(reference)) << path;
    }
  }

  /// Kills runs of a program at ten moments of its time, the first time with nothing there, then
  /// with an older file where it writes.
  void kill_ten_times(const std::vector<std::string>& words,
                      const std::vector<std::string>& outputs) {
    const auto in = [&](const fs::path& where) {
      std::vector<std::string> all = words;
      for (std::string& word : all) {
        if (word.starts_with("OUT/")) word = (where / word.substr(4)).string();
      }
      return all;
    };
    const fs::path reference = folder / "reference";
    fs::create_directory(reference);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(ended(in(reference), 0), 0);
    const double whole =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::mt19937 random(8);
    std::uniform_real_distribution<double> moment(0.02, 1.05);
    int killed = 0, written = 0;
    for (int i = 0; i < 10; ++i) {
      const fs::path where = folder / ("run" + std::to_string(i));
      fs::create_directory(where);
      const bool overwriting = i % 2 == 1;
      for (const std::string& name : outputs) {
        if (overwriting) write_text(where / name, "older");
      }
      killed += ended(in(where), whole * moment(random)) == 128 + SIGKILL;
      for (const std::string& name : outputs) {
        if (!fs::exists(where / name)) {
          EXPECT_FALSE(overwriting) << name << " was there";
          continue;
        }
        if (overwriting && read_text(where / name) == "older") continue;
        expect_whole(where / name, reference / name);
        ++written;
      }
      for (const auto& entry : fs::directory_iterator(where)) {
        const std::string name = entry.path().filename();
        const bool known = std::find(outputs.begin(), outputs.end(), name) != outputs.end();
        EXPECT_TRUE(known || name.find(".part") != std::string::npos) << name;
      }
    }
    EXPECT_GT(killed, 1) << "of ten; how fast a run is changes with what else runs";
    state("8 killed at ten moments", words.front(), "nothing half-written",
          std::to_string(killed) + " killed before their end, " + std::to_string(written) +
              " files written, all whole");
  }

  /// Runs the words under a shell's limit, and expects an error of one line without any file.
  void expect_error(const std::string& what, const std::string& shell_words,
                    const std::string& name, const fs::path& where, const std::string& said) {
    const pipeline::Run done = pipeline::run("/bin/bash", {"-c", shell_words});
    EXPECT_EQ(done.exit_code, 1) << what << ": " << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_NE(done.err.find(said), std::string::npos) << done.err;
    EXPECT_NE(done.err.find(name + ": error: "), std::string::npos) << done.err;
    std::vector<std::string> left;
    for (const auto& entry : fs::directory_iterator(where)) left.push_back(entry.path().filename());
    EXPECT_TRUE(left.empty()) << what << " leaves " << left.front();
    Ending ending;
    ending.said = done.err;
    state("8 " + what, name, "error", ending.first_words());
  }

  static std::string tool(const std::string& name) {
    return (fs::path(TOILE_TOOLS_DIR) / name).string();
  }

  /// All programs, writing into the folder `where`.
  std::vector<std::pair<std::string, std::string>> all_programs(const fs::path& where) {
    const std::string body = mannequin(), to = " -o " + where.string() + "/";
    const std::string garment = band();
    const std::string dressed = folder / "dressed.obj";
    if (!fs::exists(dressed)) {
      EXPECT_EQ(pipeline::run("dress", {"--body", body, garment, "-o", dressed, "-q"}).exit_code,
                0);
    }
    return {{"make-mannequin", to + "a.ply --edge-length 14mm -q"},
            {"clean-body", " " + body + to + "a.ply -q"},
            {"mesh-pattern",
             std::string(" ") + TOILE_SOURCE_DIR + "/samples/tshirt.json" + to + "a.obj -q"},
            {"dress", " --body " + body + " " + garment + to + "a.obj -q"},
            {"dress", " --method paper --body " + body + " " + garment + to + "a.obj -q"},
            {"ease-map", " --body " + body + " " + dressed + to + "a.html -q"},
            {"render", " --body " + body + " " + dressed + to + "a.png -q"}};
  }
};

TEST_F(CutShort, KilledWhileDressing) {
  kill_ten_times({"dress", "--body", mannequin(), band(), "-o", "OUT/dressed.obj", "--report",
                  "OUT/report.json"},
                 {"dressed.obj", "report.json"});
}

TEST_F(CutShort, KilledWhileMeshing) {
  kill_ten_times({"mesh-pattern", std::string(TOILE_SOURCE_DIR) + "/samples/tshirt.json", "-o",
                  "OUT/garment.obj", "--edge-length", "8mm"},
                 {"garment.obj", "garment.garment.json"});
}

TEST_F(CutShort, KilledWhileCleaning) {
  kill_ten_times({"clean-body", mannequin(), "-o", "OUT/body.ply"}, {"body.ply", "body.body.json"});
}

TEST_F(CutShort, AFileSizeLimitIsAnError) {
  const fs::path where = folder / "limited";
  fs::create_directory(where);
  for (const auto& [name, words] : all_programs(where)) {
    expect_error("file-size limit of 4 KiB", "ulimit -f 4; exec " + tool(name) + words, name, where,
                 "not be written whole");
  }
}

/// Needs the right to mount; who has not is told so, and has the limit above.
TEST_F(CutShort, AFullDiskIsAnError) {
  const fs::path where = folder / "disk";
  fs::create_directory(where);
  if (mount("none", where.c_str(), "tmpfs", 0, "size=8k") != 0) {
    state("8 full disk", "all programs", "not run", "no right to mount a small disk");
    GTEST_SKIP() << "no right to mount a small disk";
  }
  const auto programs = all_programs(where);
  for (const auto& [name, words] : programs) {
    expect_error("disk of 8 KiB", "exec " + tool(name) + words, name, where,
                 "not be written whole");
  }
  umount(where.c_str());
}

TEST_F(CutShort, AFolderWithoutTheRightToWriteIsAnError) {
  const fs::path where = folder / "locked";
  fs::create_directory(where);
  fs::permissions(where, fs::perms(0555));
  // Root may write anywhere: as nobody then, who has to be let into the folders above.
  std::string as_nobody;
  if (geteuid() == 0) {
    as_nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
    for (const fs::path& readable : {folder.path(), fs::path(mannequin()).parent_path()}) {
      fs::permissions(readable, fs::perms(0755));
    }
    if (pipeline::run("/bin/bash", {"-c", "exec " + as_nobody + tool("dress") + " --version"})
            .exit_code != 0) {
      state("8 folder without the right to write", "all programs", "not run",
            "nobody may not run the programs where they were built");
      GTEST_SKIP() << "nobody may not run the programs where they were built";
    }
  }
  for (const auto& [name, words] : all_programs(where)) {
    expect_error("folder without the right to write", "exec " + as_nobody + tool(name) + words,
                 name, where, "can't be written");
  }
}

}  // namespace cut_short_test
}  // namespace toile::test
