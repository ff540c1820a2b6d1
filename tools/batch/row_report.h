// report.json of a garment: what was asked for, of which inputs, and what came of it.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "tools/batch/dress_row.h"

namespace toile {

/// What decides a garment's bits: its inputs with their checksums, its settings, the programs. The
/// limits are there as well. A file that can't be read has no checksum.
class RowKeys {
 public:
  explicit RowKeys(const RowLimits& limits);

  /// Of all rows that are asked for, each body and fabric is read once.
  nlohmann::ordered_json key_of(const BatchRow& row);

 private:
  nlohmann::ordered_json input_of(const std::filesystem::path& file);

  RowLimits limits_;
  std::string executable_;  // its checksum
  std::map<std::filesystem::path, std::optional<std::string>> checksums_;
};

/// The report in the garment's folder, if it is of this key, and all files that it names are there
/// as they were written. A report of a garment that could not be done counts only if the limits
/// were the same. Without `pictures` those need not be there.
std::optional<nlohmann::ordered_json> kept_report(const GarmentFiles& files,
                                                  const nlohmann::ordered_json& key, bool pictures);

/// Writes report.json: the key, then the outcome. Gives both.
nlohmann::ordered_json write_report(const GarmentFiles& files, const nlohmann::ordered_json& key,
                                    const nlohmann::ordered_json& outcome);

}  // namespace toile
