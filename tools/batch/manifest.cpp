#include "tools/batch/manifest.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "cloth/scene/fabric.h"
#include "geometry/error.h"
#include "io/csv.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tools/dress/settings.h"
#include "tools/program.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

const std::set<std::string> known_columns = {"pattern",     "name",   "body",
                                             "edge_length", "fabric", "options"};

/// The header's columns: where those are that are known, and the others.
class Header {
 public:
  Header(const CsvRow& row, const std::string& name) : size_(row.fields.size()) {
    const std::string place = name + ":" + std::to_string(row.line);
    const std::vector<std::string>& own = result_columns();
    std::set<std::string> seen;
    for (std::size_t i = 0; i < size_; ++i) {
      const std::string& column = row.fields[i];
      const std::string shown = "column '" + shown_text(column) + "'";
      if (!seen.insert(column).second) throw Error(place, shown + " is there twice", "rename one");
      if (known_columns.contains(column)) {
        at_[column] = i;
      } else if (std::ranges::find(own, column) != own.end()) {
        throw Error(place, shown + " has the name of a column of results.csv", "rename it");
      } else {
        others_.push_back(i);
        other_columns_.push_back(valid_utf8(column));
      }
    }
    if (!at_.contains("pattern")) {
      throw Error(place, "there is no column 'pattern'",
                  "the first line names the columns: pattern, and if wanted name, body, "
                  "edge_length, fabric, options");
    }
  }

  std::size_t size() const { return size_; }
  const std::vector<std::string>& other_columns() const { return other_columns_; }
  /// The row's field of a known column; empty where there is none.
  std::string field(const CsvRow& row, const std::string& column) const {
    const auto found = at_.find(column);
    return found == at_.end() ? "" : row.fields[found->second];
  }
  std::vector<std::string> others(const CsvRow& row) const {
    std::vector<std::string> fields;
    for (const std::size_t i : others_) fields.push_back(valid_utf8(row.fields[i]));
    return fields;
  }

 private:
  std::size_t size_;
  std::map<std::string, std::size_t> at_;
  std::vector<std::size_t> others_;
  std::vector<std::string> other_columns_;
};

/// As names of folders are compared, on some disks.
std::string small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// A name is a folder's, beside bodies/ and the files of the batch.
void check_name(const std::string& name, const std::string& place) {
  const std::string small = small_letters(name);
  const bool is_taken =
      small == "bodies" || small == "results.csv" || small == "index.html" || small == "summary.md";
  if (!name.empty() && name.size() <= 200 && name.front() != '.' && name == valid_utf8(name) &&
      name.find_first_of("/\\") == std::string::npos && !is_taken) {
    return;
  }
  throw Error(place, "'" + shown_text(name) + "' is no name for a garment's folder",
              "give a name without slashes or a leading dot that is not bodies, results.csv, "
              "index.html or summary.md");
}

/// FABRIC or NAME=FABRIC, several with semicolons between; files count from `folder`.
void read_fabrics(BatchRow& row, const fs::path& folder) {
  const std::vector<std::string> known = fabric_names();
  std::string rest = row.fabric_text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    std::string word = rest.substr(0, end);
    rest.erase(0, end + 1);
    word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
    word.erase(word.find_last_not_of(' ') + 1);
    if (word.empty()) continue;
    const std::size_t equals = word.find('=');
    const std::string panels =
        equals == std::string::npos || equals == 0 ? "" : word.substr(0, equals + 1);
    const std::string fabric = word.substr(panels.size());
    if (std::ranges::find(known, fabric) != known.end()) {
      row.fabrics.push_back(word);
    } else {
      row.fabric_files.push_back(folder / fabric);
      row.fabrics.push_back(panels + row.fabric_files.back().string());
    }
  }
}

/// Options of dress, but for those of its files, which are the batch's.
void read_options(BatchRow& row, const std::string& place) {
  const std::set<std::string> own = {"body",   "garment",  "garment-json", "scene",    "fabric",
                                     "frames", "skeleton", "cache",        "continue", "from"};
  po::options_description dress;
  add_dress_options(dress, figures_quality);
  try {
    row.options = po::split_unix(row.options_text);
    const auto parsed = po::command_line_parser(row.options).options(dress).run();
    for (const po::option& option : parsed.options) {
      if (option.string_key.empty() || own.contains(option.string_key)) {
        throw Error(place,
                    "option '" + shown_text(option.original_tokens.front()) +
                        "' can't be given to a garment of a batch",
                    "give options of dress other than those of its files");
      }
    }
    // The options are whole once they name a garment.
    std::vector<std::string> words = row.options;
    words.insert(words.end(), {"--body", "body", "--garment", "garment"});
    po::variables_map given;
    po::store(po::command_line_parser(words).options(dress).run(), given);
    po::notify(given);
    check_dress_options(given);
    // The usual quality of dress alone is another.
    if (given["quality"].defaulted() && given.count("residual") == 0 &&
        given["method"].as<std::string>() == "relaxation") {
      row.options.insert(row.options.end(), {"--quality", read_quality(given).name});
    }
    read_dress_settings(given, "dressed.obj");
  } catch (const UsageError& wrong) {
    throw Error(place, std::string("options: ") + wrong.what(), "");
  } catch (const po::error& wrong) {
    throw Error(place, std::string("options: ") + wrong.what(), "dress --help lists them");
  }
}

/// Whether a file is JSON of something else, as the joints of a body. One that is damaged may have
/// been a pattern.
bool holds_no_pattern(const fs::path& file) {
  try {
    const nlohmann::ordered_json json = parse_json(read_file(file), file.string());
    return !(json.is_object() && json.contains("pattern"));
  } catch (const Error&) {
    return false;
  }
}

BatchRow read_row(const CsvRow& fields, const Header& header, const std::string& place,
                  const fs::path& folder, const BatchDefaults& defaults) {
  BatchRow row;
  row.pattern_text = header.field(fields, "pattern");
  if (row.pattern_text.empty()) throw Error(place, "names no pattern", "fill column 'pattern'");
  row.pattern = folder / row.pattern_text;
  row.name = header.field(fields, "name");
  if (row.name.empty()) row.name = row.pattern.stem().string();
  check_name(row.name, place);
  row.body_text = header.field(fields, "body");
  if (!row.body_text.empty()) {
    row.body = folder / row.body_text;
  } else if (!defaults.body.empty()) {
    row.body = row.body_text = defaults.body;
  } else {
    throw Error(place, "names no body", "fill column 'body', or give --body for all such rows");
  }
  row.edge_length = header.field(fields, "edge_length");
  if (row.edge_length.empty()) row.edge_length = defaults.edge_length;
  try {
    parse_length(row.edge_length, "edge_length");
  } catch (const UsageError& wrong) {
    throw Error(place, wrong.what(), "");
  }
  row.fabric_text = header.field(fields, "fabric");
  if (!row.fabric_text.empty()) {
    read_fabrics(row, folder);
  } else {
    row.fabric_text = defaults.fabric;
    read_fabrics(row, "");
  }
  row.options_text = header.field(fields, "options");
  if (row.options_text.empty()) row.options_text = defaults.options;
  read_options(row, place);
  row.others = header.others(fields);
  return row;
}

}  // namespace

const std::vector<std::string>& result_columns() {
  static const std::vector<std::string> columns = {"name",
                                                   "pattern",
                                                   "pattern_sha256",
                                                   "body",
                                                   "body_sha256",
                                                   "edge_length",
                                                   "fabric",
                                                   "options",
                                                   "version",
                                                   "verdict",
                                                   "cause",
                                                   "detail",
                                                   "fit",
                                                   "strain_p99",
                                                   "strain_max",
                                                   "seams_open",
                                                   "max_gap_mm",
                                                   "bust_ease_cm",
                                                   "waist_ease_cm",
                                                   "hip_ease_cm",
                                                   "intersections_body",
                                                   "intersections_self",
                                                   "converged",
                                                   "attempts",
                                                   "nodes",
                                                   "warnings",
                                                   "body_usable",
                                                   "mesh_seconds",
                                                   "dress_seconds",
                                                   "seconds",
                                                   "peak_MiB",
                                                   "dressed_sha256"};
  return columns;
}

Batch parse_manifest(const std::string& text, const std::string& name, const fs::path& folder,
                     const BatchDefaults& defaults) {
  const std::vector<CsvRow> table = parse_csv(text, name);
  if (table.size() < 2) {
    throw Error(name, "holds no garment",
                "give a first line with the names of the columns, then a line for each garment");
  }
  const Header header(table.front(), name);
  Batch batch;
  batch.other_columns = header.other_columns();
  std::map<std::string, int> line_of_name;
  for (std::size_t i = 1; i < table.size(); ++i) {
    const CsvRow& fields = table[i];
    const std::string place = name + ":" + std::to_string(fields.line);
    if (fields.fields.size() != header.size()) {
      throw Error(place,
                  "has " + std::to_string(fields.fields.size()) + " fields, the first line has " +
                      std::to_string(header.size()),
                  "give each line as many; a field with a comma needs quotes");
    }
    batch.rows.push_back(read_row(fields, header, place, folder, defaults));
    const std::string& called = batch.rows.back().name;
    const auto [other, is_new] = line_of_name.emplace(small_letters(called), fields.line);
    if (!is_new) {
      throw Error(place,
                  "'" + called + "' is the name of line " + std::to_string(other->second) + ", too",
                  "give each garment a name of its own in column 'name'");
    }
  }
  return batch;
}

Batch read_manifest(const fs::path& file, const BatchDefaults& defaults) {
  // No path begins as an option does.
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return parse_manifest(read_file(file), file.string(), folder, defaults);
}

Batch batch_of_folder(const fs::path& folder, const BatchDefaults& defaults) {
  Batch batch;
  std::vector<fs::path> patterns;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    if (holds_no_pattern(entry.path())) {
      batch.notes.push_back(entry.path().string() + " holds no pattern and is left out");
    } else {
      patterns.push_back(entry.path());
    }
  }
  std::ranges::sort(patterns);
  std::ranges::sort(batch.notes);
  if (patterns.empty()) {
    throw Error(folder.string(), "holds no pattern", "give a folder of .json files");
  }
  if (defaults.body.empty()) throw Error(folder.string(), "names no body", "give --body");
  std::map<std::string, fs::path> file_of_name;
  for (const fs::path& pattern : patterns) {
    BatchRow row;
    row.name = pattern.stem().string();
    check_name(row.name, pattern.string());
    const auto [other, is_new] = file_of_name.emplace(small_letters(row.name), pattern);
    if (!is_new) {
      throw Error(pattern.string(), "has the name of " + other->second.string(), "rename one");
    }
    row.pattern_text = pattern.string();
    row.pattern = pattern;
    row.body_text = defaults.body;
    row.body = defaults.body;
    row.edge_length = defaults.edge_length;
    row.fabric_text = defaults.fabric;
    read_fabrics(row, "");
    row.options_text = defaults.options;
    read_options(row, "--options");
    batch.rows.push_back(row);
  }
  return batch;
}

}  // namespace toile
