#include "tools/ease_map/pdf.h"

#include <stdlib.h>  // NOLINT: mkdtemp
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "geometry/error.h"
#include "io/output_file.h"
#include "tools/child.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// Seconds after which Chromium has failed. On two busy cores it took fewer than 20.
constexpr int print_seconds = 180;

std::optional<fs::path> browser() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const fs::path program = fs::path(folder) / name;
      if (access(program.c_str(), X_OK) == 0) return program;
    }
  }
  return std::nullopt;
}

/// A folder for files of its own, removed at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "toile-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw Error(name, "can't be made", "set TMPDIR to a folder that can be written");
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void check_printer() {
  if (browser()) return;
  throw Error("--pdf", "needs Chromium, which is not on the PATH",
              "install it (Debian: chromium), or print the page from your own browser");
}

std::string printed_page(const std::string& html) {
  check_printer();
  const TemporaryFolder folder;
  const fs::path page = folder.path() / "page.html";
  const fs::path pdf = folder.path() / "page.pdf";
  write_file(page, html);
  // No graphics card is asked for: the picture is drawn by the processor.
  std::vector<std::string> words = {"--headless",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--no-first-run",
                                    "--disable-extensions",
                                    "--user-data-dir=" + (folder.path() / "profile").string(),
                                    "--no-pdf-header-footer",
                                    "--lang=en",
                                    "--virtual-time-budget=20000",
                                    "--print-to-pdf=" + pdf.string()};
  // Chromium's sandbox does not run as root. The page loads nothing.
  if (geteuid() == 0) words.emplace_back("--no-sandbox");
  words.push_back("file://" + page.string());
  ChildLimits limits;
  limits.end = std::chrono::steady_clock::now() + std::chrono::seconds(print_seconds);
  const ChildEnd end = run_program(*browser(), words, limits);
  if (end.timed_out || end.exit_code != 0 || !fs::exists(pdf)) {
    throw Error("--pdf", "Chromium did not print the page",
                end.timed_out ? "it took more than " + std::to_string(print_seconds) + " s"
                              : "print the page from a browser");
  }
  return read_file(pdf);
}

}  // namespace toile
