// The library's values as the rooms have them, and back.
#pragma once

#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/body/landmark.h"
#include "geometry/body/skeleton.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"
#include "toile/error.h"
#include "toile/values.h"
#include "tools/program.h"

namespace toile {

/// Throws Error, calling the mesh `name`, for indices that are out of range and for coordinates
/// that are not finite or beyond max_coordinate. So do the others.
TriangleMesh mesh_in(const std::vector<library::Point>& points,
                     const std::vector<library::Corners>& triangles, const std::string& name);
std::vector<library::Point> points_out(const std::vector<Vec3>& points);

/// The skin, closed, and the joints, which are those of this skin.
TriangleMesh skin_in(const library::Body& body);
std::optional<Skeleton> skeleton_in(const library::Body& body);
library::Body body_out(const TriangleMesh& skin, const std::optional<Skeleton>& skeleton,
                       const Landmarks& landmarks);

PanelMesh garment_in(const library::Garment& garment);
library::Garment garment_out(const PanelMesh& garment);

DressedGarment drape_in(const library::Drape& drape);

/// What a program's report would say of itself; nothing is said on stderr.
CommonSettings settings_of(const std::string& program);

/// Calls `work`. All that it throws becomes an Error.
template <typename Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error("memory", "is used up", "use a coarser mesh");
  } catch (const std::filesystem::filesystem_error& failed) {
    throw Error(failed.path1().string(), "can't be reached (" + failed.code().message() + ")",
                "name another file");
  } catch (const std::exception& failed) {
    throw Error("the input", std::string("leads to a case that was not foreseen: ") + failed.what(),
                "report it together with the input");
  }
}

}  // namespace toile
