#include "io/sidecar.h"

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

namespace fs = std::filesystem;

fs::path sidecar_path(const fs::path& mesh, const std::string& kind) {
  return fs::path(mesh).replace_extension("." + kind + ".json");
}

fs::path earlier_sidecar_path(const fs::path& mesh) {
  return fs::path(mesh).replace_extension(".json");
}

fs::path sidecar_beside(const fs::path& mesh, const std::string& kind,
                        const std::function<bool(const JsonValue&)>& is_sidecar) {
  fs::path path = sidecar_path(mesh, kind);
  fs::path earlier = earlier_sidecar_path(mesh);
  std::error_code unreachable;
  if (fs::exists(path, unreachable) || !fs::is_regular_file(earlier, unreachable)) return path;
  try {
    const JsonDocument document(read_file(earlier), earlier.string());
    return is_sidecar(document.root()) ? earlier : path;
  } catch (const Error&) {
    return earlier;
  }
}

}  // namespace toile
