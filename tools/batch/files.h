// The files of a batch's folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pattern/file/garment_file.h"

namespace toile {

/// What the folder itself holds.
struct BatchFiles {
  explicit BatchFiles(const std::filesystem::path& folder)
      : results(folder / "results.csv"),
        sheet(folder / "index.html"),
        summary(folder / "summary.md"),
        bodies(folder / "bodies") {}

  std::filesystem::path results, sheet, summary;
  std::filesystem::path bodies;  ///< a folder
};

/// What the folder of one garment holds.
struct GarmentFiles {
  explicit GarmentFiles(const std::filesystem::path& folder_of_garment)
      : folder(folder_of_garment),
        garment(folder / "garment.obj"),
        garment_json(garment_json_path(garment)),
        mesh_report(folder / "mesh.json"),
        dressed(folder / "dressed.obj"),
        dress_report(folder / "dressed.json"),
        ease(folder / "ease.html"),
        ease_report(folder / "ease.json"),
        front(folder / "front.png"),
        back(folder / "back.png"),
        log(folder / "log.txt"),
        report(folder / "report.json") {}

  /// All but the log and the report, in the order in which they are written; what is only to look
  /// at with `pictures`.
  std::vector<std::filesystem::path> made(bool pictures = true) const {
    std::vector<std::filesystem::path> all = {garment, garment_json, mesh_report,
                                              dressed, dress_report, ease_report};
    if (pictures) all.insert(all.end(), {ease, front, back});
    return all;
  }

  std::filesystem::path folder;
  std::filesystem::path garment, garment_json, mesh_report;
  std::filesystem::path dressed, dress_report;
  std::filesystem::path ease, ease_report;
  std::filesystem::path front, back;
  std::filesystem::path log;     ///< what the programs said
  std::filesystem::path report;  ///< of the garment in this batch, written last
};

/// Removes the files, where they are there: no file of an earlier run may pass for a later one's.
/// Throws Error for one that can't be removed.
void remove_files(const std::vector<std::filesystem::path>& files);

}  // namespace toile
