// What a program writes, the next one takes: pairs of the pattern programs, with places, names and
// labels and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "pattern/file/garment_file.h"
#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace handed_on_test {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;

std::vector<fs::path> patterns_in(const fs::path& folder, std::size_t most) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), most));
  return files;
}

/// The samples, drafts of others, and ten of GarmentCode's random garments where they are.
std::vector<fs::path> patterns() {
  const fs::path source = TOILE_SOURCE_DIR;
  const char* elsewhere = std::getenv("TOILE_DATA");
  const fs::path data = elsewhere != nullptr ? fs::path(elsewhere) : source / "../shared/data";
  std::vector<fs::path> files = patterns_in(source / "samples", 100);
  for (const auto& [folder, most] : {std::pair(source / "tests/pattern/seams/drafts", 100),
                                     {data / "patterns/garmentcode", 100},
                                     {data / "patterns/garmentcode-random", 10}}) {
    const std::vector<fs::path> more = patterns_in(folder, static_cast<std::size_t>(most));
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

std::string without_places(const std::string& text) {
  Json file = Json::parse(text);
  for (Json& panel : file["pattern"]["panels"]) {
    for (const char* key : {"translation", "rotation", "placement"}) panel.erase(key);
  }
  return file.dump();
}

std::string without_names_and_labels(const std::string& text) {
  Json file = Json::parse(text);
  Json& pattern = file["pattern"];
  std::map<std::string, std::string> number;
  Json panels = Json::object();
  for (const auto& [name, panel] : pattern["panels"].items()) {
    number[name] = "p" + std::to_string(number.size());
    Json plain = panel;
    plain.erase("label");
    for (Json& edge : plain["edges"]) edge.erase("label");
    panels[number[name]] = plain;
  }
  pattern["panels"] = panels;
  pattern.erase("panel_order");
  for (Json& stitch : pattern["stitches"]) {
    for (int side = 0; side < 2; ++side) {
      stitch[side]["panel"] = number.at(stitch[side]["panel"].get<std::string>());
    }
  }
  return file.dump();
}

class HandedOn : public testing::Test {
 protected:
  /// Calls `then` with each pattern, in a file, in one of three forms: they take turns.
  template <class Then>
  void for_all(const Then& then) {
    int turn = 0;
    for (const fs::path& path : patterns()) {
      std::string text = read_text(path);
      if (turn == 1) text = without_places(text);
      if (turn == 2) text = without_names_and_labels(text);
      SCOPED_TRACE(path.filename().string() + " in form " + std::to_string(turn));
      turn = (turn + 1) % 3;
      write_text(folder / "p.json", text);
      then((folder / "p.json").string());
    }
  }

  std::string file(const char* name) const { return (folder / name).string(); }

  void expect_meshed(const std::string& pattern) {
    const pipeline::Run meshed =
        run("mesh-pattern", {pattern, "--edge-length", "60mm", "-q", "-o", file("g.obj")}, 60);
    ASSERT_EQ(meshed.exit_code, 0) << meshed.err;
    std::vector<std::string> warnings;
    try {
      read_garment(file("g.obj"), {}, &warnings);
    } catch (const Error& refused) {
      ADD_FAILURE() << "dress would say: " << refused.what();
    }
    EXPECT_TRUE(warnings.empty()) << warnings.front();
  }

  ScratchFolder folder;
};

TEST_F(HandedOn, WhatIsMeshedDressReads) {
  for_all([this](const std::string& pattern) { expect_meshed(pattern); });
}

TEST_F(HandedOn, WhatIsExportedIsImportedAndMeshed) {
  for_all([this](const std::string& pattern) {
    for (const char* sheet : {"s.dxf", "s.svg"}) {
      const pipeline::Run exported = run("export-pattern", {pattern, "-q", "-o", file(sheet)}, 60);
      ASSERT_EQ(exported.exit_code, 0) << exported.err;
      const pipeline::Run imported =
          run("import-pattern", {file(sheet), "-q", "-o", file("i.json")}, 60);
      ASSERT_EQ(imported.exit_code, 0) << imported.err;
      expect_meshed(file("i.json"));
    }
  });
}

// The search takes seconds for garments of many panels, so these are few.
TEST_F(HandedOn, WhatIsSewnIsMeshedAndWhatIsImportedIsSewn) {
  for (const char* name : {"band", "tube_top", "elastic_skirt", "gathered_skirt"}) {
    const std::string text =
        read_text(std::string(TOILE_SOURCE_DIR) + "/samples/" + name + ".json");
    for (const std::string& content :
         {text, without_places(text), without_names_and_labels(text)}) {
      SCOPED_TRACE(name);
      write_text(folder / "p.json", content);
      ASSERT_EQ(run("export-pattern", {file("p.json"), "-q", "-o", file("s.dxf")}).exit_code, 0);
      ASSERT_EQ(run("import-pattern", {file("s.dxf"), "-q", "-o", file("i.json")}).exit_code, 0);
      for (const char* drawn : {"p.json", "i.json"}) {
        const pipeline::Run sewn = run("find-seams", {file(drawn), "-q", "-o", file("f.json")}, 60);
        ASSERT_NE(sewn.exit_code, 1) << sewn.err;
        expect_meshed(file("f.json"));
      }
    }
  }
}

}  // namespace handed_on_test
}  // namespace toile
