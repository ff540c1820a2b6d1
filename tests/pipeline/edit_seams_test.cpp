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

TEST(EditSeams, RefusesProposalsOfAnotherPattern) {
  const ScratchFolder folder;
  const auto proposed = [&](const std::string& a, const std::string& more) {
    write_text(folder / "seams.json", "{\"seams\": [{\"a\": " + a +
                                          R"(, "b": {"panel": "back", "edge": 1}, )" + more +
                                          R"("confidence": 1}], "undecided": []})");
    return edit(
        folder, samples::bag,
        {"--proposals", (folder / "seams.json").string(), "-o", (folder / "page.html").string()});
  };
  const std::string side = R"({"panel": "front", "edge": 1})";
  for (const pipeline::Run& refused : {proposed(R"({"panel": "zz", "edge": 1})", ""),
                                       proposed(R"({"panel": "front", "edge": 4})", ""),
                                       proposed(side, R"("length_a_cm": 30, )")}) {
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_HOLDS(refused.err, "seams[0], a: ");
    EXPECT_HOLDS(refused.err, "another pattern than ");
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bag.json", "seams.json"}));
  const pipeline::Run taken = proposed(side, R"("length_a_cm": 40, )");
  EXPECT_EQ(taken.exit_code, 0) << taken.err;
}

TEST(EditSeams, RefusesABodyThatCantBeRead) {
  const ScratchFolder folder;
  write_text(folder / "body.obj", "v 1 2\n");
  const auto done = edit(
      folder, samples::bag,
      {"--serve", "--body", (folder / "body.obj").string(), "-o", (folder / "sewn.json").string()});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_HOLDS(done.err, "body.obj:1");
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
