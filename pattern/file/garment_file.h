// Garments on disk: garment.obj with garment.garment.json beside it, and dressed.obj.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Writes a garment as a pair of files.
///
/// - garment.obj: `v` are the placed points and `vt` the flat coordinates, both in metres and in
///   the same order. One group a panel; `l` are the seam pairs.
/// - garment.garment.json, of the same stem: panels with their ranges, grain, fabric, part and
/// placement;
///   seams with their pairs and lengths. Then elastics, attachments, marks, cut-outs and
///   subdivisions.
///
/// Both files are new or neither. Throws Error as OutputFile does.
void write_garment(const OutputPath& obj, const PanelMesh& garment);

/// The text of garment.garment.json.
std::string garment_json(const PanelMesh& garment);

/// Where a garment's panels and seams are written: garment.garment.json beside garment.obj.
std::filesystem::path garment_json_path(const std::filesystem::path& obj);

/// Where they are read: garment_json_path(), or garment.json of an earlier version if that holds
/// panels and seams. See sidecar_beside().
std::filesystem::path garment_json_beside(const std::filesystem::path& obj);

/// Reads what write_garment wrote, also after another program has moved the points. If `json` is
/// empty, garment_json_beside() is read. `warnings`, if given, gets what is left out of it:
/// attachments without points. Throws Error, naming the file, when the two do not fit together.
PanelMesh read_garment(const std::filesystem::path& obj, const std::filesystem::path& json = {},
                       std::vector<std::string>* warnings = nullptr);

/// The same of values. `garment` has its points, flat and placed, and its triangles, and gets all
/// else from `json`, the text of garment.garment.json. `mesh_name` and `name` stand for the files.
PanelMesh parse_garment(PanelMesh garment, const std::string& mesh_name, const std::string& json,
                        const std::string& name, std::vector<std::string>* warnings = nullptr);

/// The text of a dressed garment's file.
std::string format_dressed(const DressedGarment& garment);
/// Writes a dressed garment: `v` are the nodes, `vn` their normals, `vt` the flat coordinates, one
/// object (`o`) a panel. Its fabric is its material, "cloth" where it is not known. Throws Error as
/// OutputFile does.
void write_dressed(const OutputPath& obj, const DressedGarment& garment);

/// Reads what write_dressed wrote, now or in earlier versions, which wrote groups (`g`). Throws
/// Error when there is no face, or when a face has no vt, is no triangle, belongs to no group, or
/// is there twice.
DressedGarment read_dressed(const std::filesystem::path& obj);

}  // namespace toile
