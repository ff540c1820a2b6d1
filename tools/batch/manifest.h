// Which garments a batch dresses: of a manifest, or of a folder of patterns.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toile {

/// One garment on one body. Files need not be there.
struct BatchRow {
  std::string name;                                                ///< of its folder too
  std::string pattern_text, body_text, fabric_text, options_text;  ///< as they were given
  std::filesystem::path pattern, body;
  std::string edge_length;           ///< with its unit
  std::vector<std::string> fabrics;  ///< each as --fabric of dress takes it
  std::vector<std::filesystem::path> fabric_files;
  std::vector<std::string> options;  ///< further ones of dress, word by word
  std::vector<std::string> others;   ///< the fields of Batch::other_columns
};

struct Batch {
  std::vector<std::string> other_columns;  ///< of the manifest, copied through to the results
  std::vector<BatchRow> rows;              ///< at least one; no two of one name
  std::vector<std::string> notes = {};     ///< files of the folder that are no patterns
};

/// What counts where a row says nothing.
struct BatchDefaults {
  std::string body;         ///< empty: each row needs its own
  std::string edge_length;  ///< with its unit
  std::string fabric = {};  ///< as the column `fabric`, files as seen from here; empty: dress's own
  std::string options = {};  ///< as the column `options`
};

/// The columns of results.csv, in their order, before those that are copied through.
const std::vector<std::string>& result_columns();

/// Reads a manifest from its text. Paths count from `folder`. Throws Error with the place
/// "name:line" for a table or a value that can't be understood, and for two rows of one name.
Batch parse_manifest(const std::string& text, const std::string& name,
                     const std::filesystem::path& folder, const BatchDefaults& defaults);

/// The same of a file; paths count from its folder.
Batch read_manifest(const std::filesystem::path& file, const BatchDefaults& defaults);

/// All .json files of a folder, by name, on the body of `defaults`, but for those that can be read
/// and hold no pattern. Throws Error where there are none.
Batch batch_of_folder(const std::filesystem::path& folder, const BatchDefaults& defaults);

}  // namespace toile
