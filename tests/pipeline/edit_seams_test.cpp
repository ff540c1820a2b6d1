// The program edit-seams: its page as a file, and what it refuses. tests/browser/edit_seams clicks
// through the page that it serves.
#include <gtest/gtest.h>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace edit_seams_test {

using pipeline::read_text;
using pipeline::Run;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;

Run edit(const ScratchFolder& folder, const std::string& pattern,
         const std::vector<std::string>& options) {
  write_text(folder / "bag.json", pattern);
  std::vector<std::string> arguments = {(folder / "bag.json").string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run("edit-seams", arguments, 60);
}

TEST(EditSeams, WritesThePageInOneFile) {
  const ScratchFolder folder;
  const auto done = edit(folder, samples::bag, {"-o", (folder / "page.html").string()});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.out, "");
  EXPECT_HOLDS(read_text(folder / "page.html"), "<title>bag.json</title>");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bag.json", "page.html"}));
}

TEST(EditSeams, RefusesWhatIsNoPattern) {
  const ScratchFolder folder;
  const auto done = edit(folder, "{\"pattern\": 3}", {"-o", (folder / "page.html").string()});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_HOLDS(done.err, "bag.json");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bag.json"}));
}

TEST(EditSeams, OptionsThatNeedTheServerSaySo) {
  const ScratchFolder folder;
  const std::string page = (folder / "page.html").string();
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"-o", page, "--body", "body.ply"},
        {"-o", page, "--port", "8080"},
        {"-o", (folder / "sewn.json").string(), "--serve", "--port", "80"}}) {
    EXPECT_EQ(edit(folder, samples::bag, options).exit_code, 2);
  }
  const auto named = edit(folder, samples::bag, {"-o", page, "--serve"});
  EXPECT_EQ(named.exit_code, 1);
  EXPECT_HOLDS(named.err, "does not end in .json");
}

}  // namespace edit_seams_test
}  // namespace toile
