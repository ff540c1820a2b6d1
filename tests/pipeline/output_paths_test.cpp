// No program loses a file: it does not write over what it reads, nor twice to one place.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <map>
#include <sstream>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace output_paths_test {

using Words = std::vector<std::string>;

const char* const scene = R"({"body": "body.ply", "skeleton": "joints.json", "layers": [
    {"name": "tee", "garment": "garment.obj", "fabric": "fabric.json"},
    {"name": "coat", "garment": "out-coat.obj", "garment_json": "coat-panels.json"}]})";

/// Files of every kind, and links to them. What is in most of them is not read before it is known
/// that none is lost.
class OutputPaths : public testing::Test {
 protected:
  OutputPaths() {
    for (const char* name :
         {"scan.obj", "scan.body.json", "body.ply", "body.body.json", "body.distances",
          "joints.json", "pose.json", "pattern.json", "garment.obj", "garment.garment.json",
          "out-coat.obj", "coat-panels.json", "dressed.obj", "dressed.json", "drape-report.json"}) {
      write_text(folder / name, std::string("content of ") + name);
    }
    write_text(folder / "fabric.json", "{}");
    write_text(folder / "scene.json", scene);
    fs::create_symlink(".", folder / "here");
    for (const char* kind : {".obj", ".ply", ".json", ".garment.json", ".html", ".png"}) {
      const std::string of_kind = kind;
      const fs::path input =
          of_kind == ".obj" || of_kind == ".ply" ? "garment.obj" : "body.body.json";
      fs::create_symlink(input, folder / ("link" + of_kind));
      fs::create_hard_link(folder / input, folder / ("hard" + of_kind));
    }
  }

  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
      const bool is_file = fs::is_regular_file(entry.path());
      all[entry.path().string()] = is_file ? read_text(entry.path()) : "";
    }
    return all;
  }

  /// Runs "PROGRAM WORD..." in the folder, without a shell.
  pipeline::Run run_line(const std::string& line) const {
    Words words;
    std::istringstream stream(line);
    for (std::string word; stream >> word;) words.push_back(word);
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const pipeline::Run done = run(words.front(), Words(words.begin() + 1, words.end()));
    fs::current_path(before);
    return done;
  }

  /// Exit code 1, one message with `problem`, and every file as before.
  void expect_refused(const std::string& line, const std::string& problem) const {
    SCOPED_TRACE(line);
    const auto before = contents();
    const pipeline::Run done = run_line(line);
    EXPECT_EQ(done.exit_code, 1) << done.err;
    EXPECT_NE(done.err.find(problem), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_EQ(contents(), before);
  }

  ScratchFolder folder;
};

TEST_F(OutputPaths, NoInputIsOverwrittenThroughAnyOption) {
  const std::string dress = "dress --body body.ply garment.obj ";
  const std::string outfit = "dress --scene scene.json ";
  const std::string ease = "ease-map --body body.ply dressed.obj -o new.html ";
  for (const std::string& line : Words{
           "clean-body scan.obj -o scan.obj",
           "clean-body scan.obj -o ./scan.obj",
           "clean-body scan.obj -o here/scan.obj",
           "clean-body scan.obj -o SCAN.OBJ",
           "clean-body scan.obj -o scan.ply",  // its joints are read, and would be written
           "clean-body scan.obj -o new.ply --report scan.obj",
           "clean-body scan.obj -o new.ply --report scan.body.json",
           "clean-body garment.obj -o link.obj",
           "clean-body garment.obj -o hard.obj",
           "clean-body garment.obj -o hard.ply",
           "mesh-pattern garment.garment.json -o garment.obj",
           "mesh-pattern garment.garment.json -o GARMENT.OBJ",
           "mesh-pattern pattern.json -o new.obj --report pattern.json",
           "mesh-pattern body.body.json -o link.obj",
           "mesh-pattern body.body.json -o new.obj --report hard.json",
           dress + "-o garment.obj",
           dress + "-o link.obj",
           dress + "-o hard.obj",
           dress + "-o new.obj --report garment.obj",
           dress + "-o new.obj --report garment.garment.json",
           dress + "-o new.obj --report here/body.ply",
           dress + "-o new.obj --report body.body.json",
           dress + "-o new.obj --report Body.ply",
           dress + "-o new.obj --report joints.json --skeleton joints.json",
           dress + "-o new.obj --report coat-panels.json --garment-json coat-panels.json",
           dress + "-o new.obj --report fabric.json --fabric fabric.json",
           dress + "-o new.obj --report fabric.json --fabric wool=fabric.json",
           "dress --body body.ply out-coat.obj --garment-json body.distances --cache -o new.obj",
           outfit + "-o out.obj",  // out-coat.obj is a layer's garment
           outfit + "-o new.obj --report scene.json",
           outfit + "-o new.obj --report body.ply",
           outfit + "-o new.obj --report joints.json",
           outfit + "-o new.obj --report garment.garment.json",
           outfit + "-o new.obj --report coat-panels.json",
           outfit + "-o new.obj --report fabric.json",
           ease + "--report dressed.obj",
           ease + "--report dressed.json",  // the report of dress beside it
           ease + "--report body.body.json",
           ease + "--csv dressed.obj",
           ease + "--csv body.ply",
           ease + "--csv joints.json --skeleton joints.json",
           ease + "--csv drape-report.json --dress-report drape-report.json",
           ease + "--report ./body.ply",
           ease + "--report hard.json",
           ease + "--ply body.ply",
           ease + "--ply here/body.ply",
           "ease-map --body body.body.json dressed.obj -o link.html",
           "ease-map --body body.ply hard.png -o new.html --png link.png",
           "render --body hard.png garment.obj -o link.png --report new.json",
           "render --body body.body.json garment.obj -o link.png",
           "render --body body.ply garment.obj -o new.png --report garment.obj",
           "render dressed.obj garment.obj -o new.png --report garment.obj",
           "render --body body.ply -o new.png --report here/body.ply",
           "make-mannequin --pose body.body.json -o body.stl",
           "make-mannequin --pose pose.json -o new.ply --report pose.json",
           "toile fit --body body.ply pattern.json -o .",
           "toile try --body scan.obj pattern.json -o .",
           "toile try --measures sewn.json tshirt.svg -o .",
           "toile fit --body scan.obj garment.garment.json -o here/",
           "toile fit --body scan.obj pattern.json --fabric dressed.json -o .",
           "toile fit --body scan.obj pattern.json --fabric wool=dressed.json -o .",
           "toile fit --body scan.obj body.distances -o .",
           "toile dress --body body.ply garment.obj -o ./garment.obj",
       }) {
    // A fabric has to be one: what it holds is checked as soon as it is named.
    if (line.find("dressed.json -o .") != std::string::npos) {
      write_text(folder / "dressed.json", "{}");
    }
    expect_refused(line, "would be overwritten; give the output another name");
  }
}

TEST_F(OutputPaths, NoOutputIsWrittenOverAnother) {
  const std::string ease = "ease-map --body body.ply dressed.obj ";
  for (const std::string& line : Words{
           "clean-body garment.obj -o new.ply --report new.body.json",
           "clean-body garment.obj -o new.ply --report ./new.ply",
           "mesh-pattern pattern.json -o new.obj --report new.garment.json",
           "mesh-pattern pattern.json -o new.obj --report here/new.obj",
           "mesh-pattern pattern.json -o new.OBJ --report NEW.Garment.json",
           "dress --body body.ply garment.obj -o new.obj --report new.obj",
           "dress --body body.ply garment.obj -o new.obj --cache --report body.distances",
           "dress --scene scene.json -o new.obj --report new-tee.obj",
           ease + "-o new.html --report new.html",
           ease + "-o new.html --csv here/new.html",
           ease + "-o new.html --csv new.csv --report NEW.CSV",
           ease + "-o new.html --ply new.ply --report new.ply",
           ease + "-o new.html --png new.png --report ./new.png",
           "render garment.obj -o new.png --report new.png",
           "make-mannequin -o new.ply --report new.body.json",
           "make-mannequin -o new.ply --report new.ply",
       }) {
    expect_refused(line, "would be written twice; give each output a name of its own");
  }
}

TEST_F(OutputPaths, AFolderForFramesHoldsNoOtherFile) {
  fs::create_directory(folder / "frames");
  for (const char* name : {"0001-moved.obj", "0001-moved.json"}) {
    write_text(folder / "frames" / name, "content");
  }
  const std::string dress = "dress --body body.ply ";
  const std::string remedy = "name a folder for them alone";
  expect_refused(dress + "garment.obj -o new.obj --frames .", remedy);
  expect_refused(dress + "garment.obj -o new.obj --frames new.obj", remedy);
  expect_refused(dress + "frames/0001-moved.obj -o new.obj --frames frames/", remedy);
  expect_refused(dress + "garment.obj -o frames/new.obj --frames here/frames", remedy);
}

TEST_F(OutputPaths, DevicesPipesAndFoldersAreRefused) {
  for (const char* pipe : {"pipe.json", "pipe.garment.json", "pipe.body.json"}) {
    ASSERT_EQ(mkfifo((folder / pipe).c_str(), 0600), 0);
  }
  fs::create_symlink("/dev/full", folder / "full.png");
  fs::create_directory(folder / "held.body.json");
  fs::create_directory(folder / "held.garment.json");
  fs::create_directory(folder / "fit");
  ASSERT_EQ(mkfifo((folder / "fit" / "ease.png").c_str(), 0600), 0);
  const std::string device = "is a device, a pipe or a socket; name a file";
  const std::string ease = "ease-map --body body.ply dressed.obj ";
  expect_refused("clean-body garment.obj -o new.ply --report /dev/null", device);
  expect_refused("dress --body body.ply garment.obj -o new.obj --report pipe.json", device);
  expect_refused("mesh-pattern pattern.json -o pipe.obj", device);
  expect_refused(ease + "-o new.html --csv /dev/stdout", device);
  expect_refused(ease + "-o new.html --report /dev/full", device);
  expect_refused(ease + "-o new.html --png full.png", device);
  expect_refused("render garment.obj -o full.png", device);
  expect_refused("make-mannequin -o pipe.ply", device);
  expect_refused("toile fit --body scan.obj pattern.json -o fit", device);
  expect_refused("mesh-pattern pattern.json -o held.obj", "held.garment.json: is a folder");
  expect_refused("clean-body garment.obj -o held.ply", "held.body.json: is a folder");
  expect_refused("toile fit --body scan.obj pattern.json -o /dev/null", "can't be made");
}

/// The names in a folder, but for those of the inputs.
Words names_but(const ScratchFolder& folder, const Words& inputs) {
  Words names = folder.names();
  std::erase_if(names, [&](const std::string& name) {
    return std::find(inputs.begin(), inputs.end(), name) != inputs.end();
  });
  return names;
}

// The page is the largest of the files: a disk that is full before it has room for the others.
TEST(Outputs, AllAreWrittenOrNone) {
  const ScratchFolder folder;
  succeed("make-mannequin", {"-o", folder / "body.ply", "--edge-length", "15mm", "-q"});
  succeed("mesh-pattern",
          {sample("band"), "-o", folder / "band.obj", "--edge-length", "30mm", "-q"});
  write_text(folder / "full-disk", "ulimit -f $1; shift; exec \"$@\"\n");
  const Words inputs = folder.names();
  const auto on_full_disk = [&](const std::string& blocks, const std::string& program,
                                Words words) {
    words.insert(words.begin(),
                 {folder / "full-disk", blocks, fs::path(TOILE_TOOLS_DIR) / program});
    const pipeline::Run done = run("/bin/sh", words);
    EXPECT_EQ(done.exit_code, 1) << program << done.err;
    EXPECT_NE(done.err.find("could not be written whole"), std::string::npos) << done.err;
    EXPECT_EQ(names_but(folder, inputs), Words{}) << program;
  };
  on_full_disk("100", "ease-map",
               {"-q", "--body", folder / "body.ply", folder / "band.obj", "-o",
                folder / "ease.html", "--csv", folder / "ease.csv", "--report",
                folder / "ease.json", "--ply", folder / "ease.ply", "--png", folder / "ease.png"});
  on_full_disk("9", "mesh-pattern",
               {"-q", sample("band"), "-o", folder / "new.obj", "--edge-length", "30mm", "--report",
                folder / "report.json"});
}

/// Starts a program, waits until it has a temporary file in `folder`, and sends it `signal`.
/// Returns how it ended, as a shell does; -1 if it came to its end before.
int end_amid_writing(const Words& command, const fs::path& folder, int signal) {
  std::vector<char*> argv;
  Words words = command;
  words.front() = fs::path(TOILE_TOOLS_DIR) / words.front();
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    execv(argv[0], argv.data());
    _exit(127);
  }
  const auto is_writing = [&] {
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent)) {
      // The first ones only try whether the folder can be written.
      if (entry.path().extension().string().starts_with(".part") &&
          fs::file_size(entry.path(), absent) > 0 && !absent) {
        return true;
      }
    }
    return false;
  };
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (!is_writing()) continue;
    kill(child, signal);
    waitpid(child, &status, 0);
    break;
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : -1;
}

TEST(Outputs, AnEndBySignalLeavesNoTemporaryFile) {
  const ScratchFolder folder;
  const fs::path body = folder / "body.ply";
  succeed("make-mannequin", {"-o", body, "--edge-length", "15mm", "-q"});
  succeed("mesh-pattern",
          {sample("band"), "-o", folder / "band.obj", "--edge-length", "20mm", "-q"});
  // While the second layer is dressed, the first one's file waits for it.
  write_text(folder / "scene.json", R"({"body": "body.ply", "layers": [
      {"name": "inner", "garment": "band.obj"}, {"name": "outer", "garment": "band.obj"}]})");
  const Words inputs = folder.names();
  const int ended =
      end_amid_writing({"dress", "--scene", folder / "scene.json", "-o", folder / "out.obj", "-q"},
                       folder.path(), SIGINT);
  EXPECT_EQ(ended, 128 + SIGINT);
  EXPECT_EQ(names_but(folder, inputs), Words{});
}

TEST(Outputs, AFitThatIsEndedLeavesNoTemporaryFile) {
  const ScratchFolder folder;
  const fs::path body = folder / "mannequin.ply";
  succeed("make-mannequin", {"-o", body, "--edge-length", "15mm", "-q"});
  fs::create_directory(folder / "fit");
  const int ended = end_amid_writing({"toile", "fit", "--body", body, sample("tshirt"), "-o",
                                      folder / "fit", "--edge-length", "25mm", "-q"},
                                     folder / "fit", SIGTERM);
  EXPECT_EQ(ended, 128 + SIGTERM);
  for (const auto& entry : fs::directory_iterator(folder / "fit")) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

}  // namespace output_paths_test
}  // namespace toile::pipeline
