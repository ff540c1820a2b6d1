// toile batch: many garments, one table; a garment that fails stops no other.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "io/checksum.h"
#include "io/csv.h"
#include "io/skeleton_file.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace batch_test {

using Json = nlohmann::json;
using Words = std::vector<std::string>;
using Row = std::map<std::string, std::string>;

/// results.csv by name and column.
std::map<std::string, Row> results(const fs::path& out) {
  const std::vector<CsvRow> table = parse_csv(read_text(out / "results.csv"), "results.csv");
  std::map<std::string, Row> rows;
  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_EQ(table[i].fields.size(), table[0].fields.size());
    Row row;
    for (std::size_t c = 0; c < table[0].fields.size(); ++c) {
      row[table[0].fields[c]] = table[i].fields[c];
    }
    rows[row["name"]] = row;
  }
  EXPECT_EQ(rows.size() + 1, table.size());
  return rows;
}

/// Its tests share a mannequin, and a batch of two garments that ended well.
class ToileBatch : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared = new ScratchFolder;
    succeed("make-mannequin", {"-o", *shared / "body.ply", "--edge-length", "15mm", "-q"});
    fs::copy_file(sample("band"), *shared / "band.json");
    fs::copy_file(sample("tube_top"), *shared / "top, new.json");
    write_text(*shared / "garments.csv",
               "season,pattern,name,edge_length,options,fabric\n"
               "\"spring, early\",band.json,,40mm,,\n"
               "autumn,\"top, new.json\",top,,--quality draft,jersey\n");
    done = new pipeline::Run(batch({*shared / "garments.csv", "-o", *shared / "out", "-j", "2"}));
  }
  static void TearDownTestSuite() {
    delete done;
    delete shared;
  }

  /// Of the shared body, with 40 mm edges where a row says nothing.
  static pipeline::Run batch(const Words& words) {
    Words all = {"batch", "--body", *shared / "body.ply", "--edge-length", "40mm"};
    all.insert(all.end(), words.begin(), words.end());
    return run("toile", all);
  }

  /// A copy of the shared batch, with its inputs: what is done there can be done again.
  fs::path copy_of_batch() const {
    fs::copy(*shared / "out", folder / "out", fs::copy_options::recursive);
    return folder / "out";
  }

  /// Resumes the batch, with no time for what is done again: that is the garment of this name
  /// alone, or none. Its folder is then as it was.
  void expect_redone(const fs::path& out, const std::string& redone) const {
    const pipeline::Run again =
        batch({*shared / "garments.csv", "-o", out, "--resume", "--timeout", "10ms"});
    EXPECT_EQ(again.exit_code, redone.empty() ? 0 : 1) << again.err;
    for (auto& [name, row] : results(out)) {
      EXPECT_EQ(row["verdict"], name == redone ? "error" : "sewn") << name;
    }
    if (redone.empty()) return;
    fs::remove_all(out / redone);
    fs::copy(*shared / "out" / redone, out / redone, fs::copy_options::recursive);
  }

  static ScratchFolder* shared;
  static pipeline::Run* done;
  ScratchFolder folder;
};

ScratchFolder* ToileBatch::shared = nullptr;
pipeline::Run* ToileBatch::done = nullptr;

TEST_F(ToileBatch, EveryGarmentHasItsRowAndFiles) {
  ASSERT_EQ(done->exit_code, 0) << done->err;
  const fs::path out = *shared / "out";
  auto rows = results(out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows["band"]["season"], "spring, early");
  EXPECT_EQ(rows["top"]["season"], "autumn");
  EXPECT_EQ(rows["top"]["pattern"], "top, new.json");
  EXPECT_EQ(rows["top"]["fabric"], "jersey");
  EXPECT_EQ(rows["top"]["edge_length"], "40mm");
  EXPECT_EQ(rows["band"]["pattern_sha256"], sha256_of_file(*shared / "band.json"));
  for (auto& [name, row] : rows) {
    EXPECT_EQ(row["verdict"], "sewn");
    EXPECT_EQ(row["cause"], "");
    EXPECT_EQ(row["body_sha256"], sha256_of_file(*shared / "body.ply"));
    EXPECT_EQ(row["dressed_sha256"], sha256_of_file(out / name / "dressed.obj"));
    EXPECT_EQ(row["seams_open"], "0");
    EXPECT_EQ(row["intersections_self"], "0");
    EXPECT_EQ(row["converged"], "true");
    EXPECT_GT(std::stod(row["seconds"]), std::stod(row["dress_seconds"]));
    EXPECT_GT(std::stod(row["peak_MiB"]), 5);
    for (const char* file : {"garment.obj", "garment.garment.json", "dressed.json", "ease.html",
                             "front.png", "back.png"}) {
      EXPECT_TRUE(fs::exists(out / name / file)) << file;
    }
    const Json report = Json::parse(read_text(out / name / "report.json"));
    EXPECT_EQ(report["inputs"]["pattern"]["sha256"], row["pattern_sha256"]);
  }
  const fs::path source = TOILE_SOURCE_DIR;
  const pipeline::Run valid =
      run(source / "tests" / "support" / "validate_report",
          {source / "docs" / "report.schema.json", "batch_garment", out / "top" / "report.json"});
  EXPECT_EQ(valid.exit_code, 0) << valid.err;
  EXPECT_EQ(done->out, read_text(out / "summary.md"));
  EXPECT_NE(done->out.find("| `sewn` | 2 | 100.0 % |"), std::string::npos) << done->out;
  EXPECT_NE(done->err.find("left: 0 of 2"), std::string::npos) << done->err;
  const std::string page = read_text(out / "index.html");
  EXPECT_NE(page.find("./top/front.png"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST_F(ToileBatch, HasTheBitsOfOneByOne) {
  const std::string body = folder / "body.ply", garment = folder / "garment.obj";
  succeed("clean-body", {*shared / "body.ply", "-o", body, "-q"});
  succeed("mesh-pattern", {*shared / "band.json", "-o", garment, "--edge-length", "40mm", "-q"});
  succeed("dress", {"--body", body, garment, "-o", folder / "dressed.obj", "--quality", "figures",
                    "-q", "--threads", "2"});
  const fs::path out = *shared / "out";
  EXPECT_EQ(read_text(out / "bodies" / "body.ply"), read_text(body));
  EXPECT_EQ(read_text(out / "band" / "garment.obj"), read_text(garment));
  EXPECT_EQ(read_text(out / "band" / "dressed.obj"), read_text(folder / "dressed.obj"));
}

TEST_F(ToileBatch, FiguresAloneAreTheSameWithoutPictures) {
  const fs::path out = folder / "out";
  const Words words = {*shared / "garments.csv", "-o", out, "--no-pictures"};
  const pipeline::Run bare = batch(words);
  ASSERT_EQ(bare.exit_code, 0) << bare.err;
  for (const char* file : {"dressed.obj", "garment.obj"}) {
    EXPECT_EQ(read_text(out / "top" / file), read_text(*shared / "out" / "top" / file)) << file;
  }
  auto row = results(out)["top"];
  auto drawn = results(*shared / "out")["top"];
  std::string eases;
  for (const char* ease : {"bust_ease_cm", "waist_ease_cm", "hip_ease_cm"}) {
    EXPECT_EQ(row[ease], drawn[ease]) << ease;
    eases += row[ease];
  }
  EXPECT_NE(eases, "");
  for (const char* file : {"ease.html", "front.png", "back.png"}) {
    EXPECT_FALSE(fs::exists(out / "top" / file)) << file;
    EXPECT_EQ(read_text(out / "index.html").find(file), std::string::npos) << file;
  }
  // Nothing is missing but where pictures are asked for.
  const auto resumed = [&](Words more) {
    more.insert(more.end(), {"--resume", "--timeout", "10ms"});
    return batch(more).exit_code;
  };
  EXPECT_EQ(resumed(words), 0);
  EXPECT_EQ(resumed({words.begin(), words.end() - 1}), 1);
}

TEST_F(ToileBatch, ResumeRedoesWhatIsMissing) {
  const fs::path out = copy_of_batch();
  fs::remove(out / "band" / "dressed.obj");
  const std::string kept = read_text(out / "top" / "report.json");
  const pipeline::Run again = batch({*shared / "garments.csv", "-o", out, "--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("1 of 2 garments are done already"), std::string::npos) << again.err;
  EXPECT_EQ(read_text(out / "top" / "report.json"), kept);
  EXPECT_EQ(read_text(out / "band" / "dressed.obj"),
            read_text(*shared / "out" / "band" / "dressed.obj"));
  EXPECT_EQ(results(out).size(), 2U);
}

TEST_F(ToileBatch, ResumeRedoesWhatChanged) {
  const fs::path out = copy_of_batch();
  // The band's edge length is another, and the top's pattern is gone.
  write_text(*shared / "changed.csv",
             "season,pattern,name,edge_length,options,fabric\n"
             "winter,band.json,,41mm,--quality draft,\n"
             "winter,gone.json,top,,--quality draft,jersey\n");
  const pipeline::Run again = batch({*shared / "changed.csv", "-o", out, "--resume"});
  EXPECT_EQ(again.exit_code, 1) << again.err;
  EXPECT_EQ(again.err.find("done already"), std::string::npos) << again.err;
  EXPECT_NE(read_text(out / "band" / "garment.obj"),
            read_text(*shared / "out" / "band" / "garment.obj"));
  auto rows = results(out);
  EXPECT_EQ(rows["band"]["verdict"], "sewn");
  EXPECT_EQ(rows["top"]["verdict"], "error");
  EXPECT_EQ(rows["top"]["pattern_sha256"], "");
  EXPECT_NE(rows["top"]["detail"].find("gone.json"), std::string::npos) << rows["top"]["detail"];
  EXPECT_FALSE(fs::exists(out / "top" / "dressed.obj"));
}

TEST_F(ToileBatch, ResumeRedoesWhatHasADamagedReport) {
  const fs::path out = copy_of_batch();
  const fs::path report = out / "band" / "report.json";
  const std::string sound = read_text(report);
  expect_redone(out, "");  // the control
  for (const std::string& text :
       {std::string(200000, '[') + std::string(200000, ']'), std::string("[3]"), std::string("3"),
        std::string(), sound.substr(0, sound.size() / 2)}) {
    SCOPED_TRACE(text.substr(0, 20));
    write_text(report, text);
    expect_redone(out, "band");
  }
  const struct {
    const char *place, *value;
  } wrong[] = {
      {"/verdict", R"("sewed")"},
      {"/verdict", "3"},
      {"/verdict", "null"},
      {"/verdict", R"("error")"},  // and it has figures
      {"/cause", "3"},
      {"/detail", "null"},
      {"/seconds", R"("1")"},
      {"/mesh_seconds", R"("1")"},
      {"/dress_seconds", "null"},
      {"/peak_MiB", "[]"},
      {"/body_usable", "1"},
      {"/warnings", R"("none")"},
      {"/warnings", R"([{"code": "a", "place": "", "text": 3}])"},
      {"/figures", "null"},
      {"/figures", "[]"},
      {"/figures/fit", "3"},
      {"/figures/strain_p99", R"("1")"},
      {"/figures/strain_max", "null"},
      {"/figures/max_gap_mm", "[1]"},
      {"/figures/seams_open", "-1"},
      {"/figures/intersections_body", "true"},
      {"/figures/intersections_self", "1e300"},
      {"/figures/attempts", "1.5"},
      {"/figures/nodes", R"("132")"},
      {"/figures/converged", "1"},
      {"/figures/bust_ease_cm", R"("wide")"},
      {"/inputs", "[]"},
      {"/limits", "3"},
      {"/outputs", "null"},
      {"/outputs", "[]"},
      {"/outputs/dressed.obj", "3"},
  };
  for (const auto& [place, value] : wrong) {
    SCOPED_TRACE(std::string(place) + " " + value);
    // In the file's order, so that nothing else differs.
    using Ordered = nlohmann::ordered_json;
    Ordered damaged = Ordered::parse(sound);
    damaged[Ordered::json_pointer(place)] = Ordered::parse(value);
    write_text(report, damaged.dump());
    // What was allowed does not change what is done.
    expect_redone(out, std::string(place) == "/limits" ? "" : "band");
  }
}

TEST_F(ToileBatch, ResumeRedoesWhatHasAChangedOutput) {
  const fs::path out = copy_of_batch();
  for (const char* name : {"garment.obj", "garment.garment.json", "mesh.json", "dressed.obj",
                           "dressed.json", "ease.html", "ease.json", "front.png", "back.png"}) {
    SCOPED_TRACE(name);
    const fs::path file = out / "band" / name;
    write_text(file, read_text(file) + "\n");
    expect_redone(out, "band");
    fs::remove(file);
    expect_redone(out, "band");
  }
}

TEST_F(ToileBatch, ResumeRedoesWhatHasOtherJoints) {
  const fs::path body = folder / "body.ply", joints = skeleton_path(body);
  fs::copy_file(*shared / "body.ply", body);
  write_text(folder / "garments.csv", "name,pattern,body,options\nband," +
                                          (*shared / "band.json").string() +
                                          ",body.ply,--quality draft\n");
  const fs::path out = folder / "out";
  ASSERT_EQ(batch({folder / "garments.csv", "-o", out}).exit_code, 0);
  const auto expect = [&](const std::string& kept) {
    fs::copy(out, folder / "again", fs::copy_options::recursive);
    const pipeline::Run again =
        batch({folder / "garments.csv", "-o", folder / "again", "--resume", "--timeout", "10ms"});
    EXPECT_EQ(results(folder / "again")["band"]["verdict"], kept) << again.err;
    fs::remove_all(folder / "again");
  };
  expect("sewn");
  // It had none.
  fs::copy_file(skeleton_path(*shared / "body.ply"), joints);
  expect("error");
  // Others, by either name.
  ASSERT_EQ(batch({folder / "garments.csv", "-o", out}).exit_code, 0);
  expect("sewn");
  const std::string text = read_text(joints);
  write_text(joints, text + "\n");
  expect("error");
  write_text(joints, text);
  expect("sewn");
  write_text(folder / "body.json", text + "\n");  // of an earlier version, and not read
  expect("sewn");
  fs::remove(joints);
  expect("error");
}

/// A batch of a missing pattern, a band, and a T-shirt that takes long.
class BatchUnderWay : public ToileBatch {
 protected:
  BatchUnderWay() {
    write_text(folder / "garments.csv",
               "name,pattern,edge_length,options\nquick,missing.json,,\n"
               "band," +
                   sample("band").string() + ",40mm,--quality draft\nslow," +
                   sample("tshirt").string() + ",4mm,--quality fine\n");
    // Runs a batch until `$2` is in the file `$1`, and sends it the signal $3. A half file is seen.
    write_text(folder / "amid", R"(
file=$1 words=$2 signal=$3
shift 3
"$@" 2>err &
batch=$!
until grep -q "$words" "$file" 2>/dev/null; do
  kill -0 $batch || exit 99
  sleep 0.02
done
kill -$signal $batch
wait $batch
)");
  }

  /// The exit code, as a shell has it.
  int end_by(const std::string& signal, const std::string& file, const std::string& words,
             const Words& more = {}) const {
    Words all = {folder / "amid",
                 file,
                 words,
                 signal,
                 fs::path(TOILE_TOOLS_DIR) / "toile",
                 "batch",
                 "--body",
                 *shared / "body.ply",
                 folder / "garments.csv",
                 "-j",
                 "1",
                 "-o",
                 folder / "out"};
    all.insert(all.end(), more.begin(), more.end());
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const pipeline::Run ended = run("/bin/sh", all);
    fs::current_path(before);
    EXPECT_EQ(ended.err.find("No such process"), std::string::npos) << ended.err;
    return ended.exit_code;
  }
};

TEST_F(BatchUnderWay, WritesItsTableAndItsPageAsItGoes) {
  EXPECT_EQ(end_by("KILL", "out/results.csv", "^quick,"), 128 + SIGKILL);
  auto rows = results(folder / "out");
  EXPECT_EQ(rows["quick"]["verdict"], "error");
  EXPECT_FALSE(rows.contains("slow"));
  const std::string page = read_text(folder / "out" / "index.html");
  EXPECT_NE(page.find(" of 3 garments</h1>"), std::string::npos);
  EXPECT_NE(page.find("<h2>quick</h2>"), std::string::npos);
  EXPECT_EQ(page.find("<h2>slow</h2>"), std::string::npos);
}

// The band ends within the pause after the writing of what was quick.
TEST_F(BatchUnderWay, WritesWhatIsDoneWhenItIsInterrupted) {
  EXPECT_EQ(end_by("TERM", "err", "^band: "), 128 + SIGTERM);
  auto rows = results(folder / "out");
  EXPECT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows["band"]["verdict"], "sewn");
  EXPECT_FALSE(fs::exists(folder / "out" / "summary.md"));
  for (const auto& entry : fs::directory_iterator(folder / "out")) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }

  // What is kept is there from the start.
  fs::remove(folder / "out" / "results.csv");
  EXPECT_EQ(end_by("KILL", "out/results.csv", "^quick,", {"--resume"}), 128 + SIGKILL);
  EXPECT_EQ(results(folder / "out").size(), 2U);
}

TEST_F(ToileBatch, ResumeOfAllThatIsDoneRunsNothing) {
  const fs::path out = copy_of_batch();
  const pipeline::Run again = batch({*shared / "garments.csv", "-o", out, "--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find("2 of 2 garments are done already"), std::string::npos) << again.err;
  EXPECT_EQ(read_text(out / "results.csv"), read_text(*shared / "out" / "results.csv"));
}

TEST_F(ToileBatch, AGarmentOutOfTimeIsAnErrorAndLeavesNoOlderResult) {
  const fs::path out = copy_of_batch();
  const pipeline::Run late =
      batch({*shared / "garments.csv", "-o", out, "--timeout", "10ms", "-q"});
  EXPECT_EQ(late.exit_code, 1) << late.err;
  EXPECT_EQ(late.err, "");
  for (auto& [name, row] : results(out)) {
    EXPECT_EQ(row["verdict"], "error");
    EXPECT_EQ(row["cause"], "clean-body: out of time");
    EXPECT_NE(row["detail"].find("it may take 0.01 s"), std::string::npos) << row["detail"];
    EXPECT_EQ(row["dressed_sha256"], "");
    for (const char* file : {"dressed.obj", "dressed.json", "ease.html", "front.png"}) {
      EXPECT_FALSE(fs::exists(out / name / file)) << file;
    }
    for (const auto& entry : fs::directory_iterator(out / name)) {
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
  }
}

#ifndef __SANITIZE_ADDRESS__  // its programs reserve terabytes of addresses
TEST_F(ToileBatch, AGarmentOutOfMemoryIsAnError) {
  const pipeline::Run done_small =
      batch({*shared / "garments.csv", "-o", folder / "out", "--memory", "110MB"});
  EXPECT_EQ(done_small.exit_code, 1) << done_small.err;
  for (auto& [name, row] : results(folder / "out")) {
    EXPECT_EQ(row["verdict"], "error") << name;
    EXPECT_NE(row["cause"].find("out of memory"), std::string::npos) << row["detail"];
  }
}
#endif

TEST_F(ToileBatch, OneThatFailsStopsNoOther) {
  write_text(folder / "no pattern.json", "{}");
  fs::copy_file(sample("band"), folder / "band.json");
  fs::copy_file(*shared / "body.ply", folder / "body.ply");
  write_text(folder / "garments.csv",
             "pattern,body,options\n"
             "missing.json,body.ply,\nno pattern.json,body.ply,\n"
             "band.json,body.ply,--quality draft\n");
  const pipeline::Run ended = batch({folder / "garments.csv", "-o", folder / "out"});
  EXPECT_EQ(ended.exit_code, 1);
  auto rows = results(folder / "out");
  EXPECT_EQ(rows["missing"]["verdict"], "error");
  EXPECT_EQ(rows["missing"]["cause"].find("mesh-pattern: "), 0U) << rows["missing"]["cause"];
  EXPECT_EQ(rows["no pattern"]["verdict"], "error");
  EXPECT_EQ(rows["band"]["verdict"], "sewn");
  EXPECT_NE(read_text(folder / "out" / "index.html").find("./no%20pattern/log.txt"),
            std::string::npos);
}

TEST_F(ToileBatch, BodiesOfOneNameAndFilesOfFabricsCountFromTheManifest) {
  std::string table = "name,pattern,body,options,fabric\n";
  for (const std::string name : {"a", "b"}) {
    fs::create_directory(folder / name);
    fs::copy_file(*shared / "body.ply", folder / name / "body.ply");
    table += name + ",band.json," + name + "/body.ply,--quality draft,a/wool.json\n";
  }
  fs::copy_file(fs::path(TOILE_SOURCE_DIR) / "samples" / "fabrics" / "wool.json",
                folder / "a" / "wool.json");
  fs::copy_file(sample("band"), folder / "band.json");
  write_text(folder / "garments.csv", table);
  const pipeline::Run ended =
      batch({folder / "garments.csv", "-o", folder / "out", "-j", "2", "--threads", "1"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  int bodies = 0;
  for (const auto& entry : fs::directory_iterator(folder / "out" / "bodies")) {
    bodies += entry.path().extension() == ".ply" ? 1 : 0;
  }
  EXPECT_EQ(bodies, 2);
  const Json report = Json::parse(read_text(folder / "out" / "a" / "report.json"));
  ASSERT_EQ(report["inputs"]["fabrics"].size(), 1U);
  EXPECT_EQ(report["inputs"]["fabrics"][0]["sha256"], sha256_of_file(folder / "a" / "wool.json"));
  const Json dressed = Json::parse(read_text(folder / "out" / "a" / "dressed.json"));
  EXPECT_EQ(dressed["scene"]["fabric"], Json::parse(read_text(folder / "a" / "wool.json"))["name"]);
  // The same body under two names: the same bits.
  EXPECT_EQ(read_text(folder / "out" / "a" / "dressed.obj"),
            read_text(folder / "out" / "b" / "dressed.obj"));
}

TEST_F(ToileBatch, ANegativeVerdictEndsWith3AndAFolderIsABatchToo) {
  Json pattern = Json::parse(read_text(sample("band")));
  for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
    panel["translation"][1] = panel["translation"][1].get<double>() - 60;
  }
  fs::create_directory(folder / "patterns");
  write_text(folder / "patterns" / "low.json", pattern.dump());
  fs::copy_file(sample("tshirt"), folder / "patterns" / "tshirt.json");
  write_text(folder / "patterns" / "body.json", R"({"joints": {}})");
  const pipeline::Run ended = batch({folder / "patterns", "-o", folder / "out", "--fabric",
                                     "jersey", "--options", "--quality draft"});
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_NE(ended.err.find("body.json holds no pattern"), std::string::npos) << ended.err;
  auto rows = results(folder / "out");
  ASSERT_EQ(rows.size(), 2U);
  // docs/report.md says the ease.
  EXPECT_NEAR(std::stod(rows["tshirt"]["bust_ease_cm"]), 11.3, 1);
  // Its hem hangs near the hip. Where a drape does not close there, the field is empty.
  const Json ease = Json::parse(read_text(folder / "out" / "tshirt" / "ease.json"));
  const Json left_out = ease.value("levels_left_out", Json::array());
  const bool has_hip =
      std::ranges::none_of(left_out, [](const Json& level) { return level["level"] == "hip"; });
  EXPECT_EQ(rows["tshirt"]["hip_ease_cm"].empty(), !has_hip);
  if (has_hip) {
    EXPECT_NEAR(std::stod(rows["tshirt"]["hip_ease_cm"]), 8.0, 1);
  }
  EXPECT_EQ(rows["tshirt"]["body_usable"], "true");
  EXPECT_NE(read_text(folder / "out" / "index.html").find("ease as cut: bust 1"),
            std::string::npos);
  EXPECT_EQ(rows["low"]["fabric"], "jersey");
  EXPECT_EQ(rows["low"]["options"], "--quality draft");
  EXPECT_NE(rows["low"]["verdict"], "sewn");
  EXPECT_NE(rows["low"]["cause"], "");
  EXPECT_NE(ended.out.find(rows["low"]["cause"].substr(0, 10)), std::string::npos) << ended.out;
}

TEST_F(ToileBatch, ABodyThatCanNotBeCleanedIsAnErrorOfItsGarments) {
  write_text(folder / "body.ply", "no mesh");
  write_text(folder / "garments.csv",
             "pattern,body\n" + (*shared / "band.json").string() + ",body.ply\n");
  const pipeline::Run ended = batch({folder / "garments.csv", "-o", folder / "out"});
  EXPECT_EQ(ended.exit_code, 1);
  auto rows = results(folder / "out");
  EXPECT_EQ(rows["band"]["cause"].find("clean-body: "), 0U) << rows["band"]["cause"];
  EXPECT_EQ(rows["band"]["body_usable"], "false");
  EXPECT_TRUE(fs::exists(folder / "out" / "band" / "log.txt"));
}

TEST_F(ToileBatch, WrongManifestsAreRefusedBeforeTheStart) {
  const struct {
    const char *text, *problem;
  } wrong[] = {
      {"", "holds no garment"},
      {"pattern\n", "holds no garment"},
      {"name,body\na,b\n", "garments.csv:1: there is no column 'pattern'"},
      {"pattern,pattern\na,b\n", "column 'pattern' is there twice"},
      {"pattern,verdict\na,b\n", "column 'verdict' has the name of a column of results.csv"},
      {"pattern,name\na,\n\nb,A\n", "garments.csv:4: 'A' is the name of line 2, too"},
      {"pattern\nx/a.json\ny/a.json\n", "garments.csv:3: 'a' is the name of line 2, too"},
      {"pattern,name\na\n", "garments.csv:2: has 1 fields, the first line has 2"},
      {"pattern\n\"a\n", "garments.csv:2: has a quote that is not where it may be"},
      {"pattern\nb\"a\n", "garments.csv:2: has a quote that is not where it may be"},
      {"pattern,name\n,x\n", "garments.csv:2: names no pattern"},
      {"pattern,name\na,../x\n", "'../x' is no name for a garment's folder"},
      {"pattern,name\na,bodies\n", "'bodies' is no name for a garment's folder"},
      {"pattern,edge_length\na,25\n", "garments.csv:2: edge_length: '25' is not a length"},
      {"pattern,options\na,--qualiti fine\n", "garments.csv:2: options: "},
      {"pattern,options\na,--body x.ply\n", "option '--body' can't be given"},
      {"pattern,options\na,-o x.obj\n", "garments.csv:2: options: "},
      {"pattern,options\na,x.obj\n", "option 'x.obj' can't be given"},
      {"pattern\nout/a.json\n", "lies in the folder that is written"},
  };
  for (const auto& [text, problem] : wrong) {
    SCOPED_TRACE(text);
    write_text(folder / "garments.csv", text);
    const pipeline::Run ended = batch({folder / "garments.csv", "-o", folder / "out"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_NE(ended.err.find(problem), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
  write_text(folder / "garments.csv", "pattern\na.json\n");
  const pipeline::Run bodiless =
      run("toile", {"batch", folder / "garments.csv", "-o", folder / "out"});
  EXPECT_EQ(bodiless.exit_code, 1);
  EXPECT_NE(bodiless.err.find("garments.csv:2: names no body"), std::string::npos) << bodiless.err;
}

}  // namespace batch_test
}  // namespace toile::pipeline
