#include "tools/programs.h"

namespace toile {

std::string toile_summary() {
  return "sews flat patterns around a body and reports how the garment fits";
}

std::vector<CommandLineProgram> all_programs() {
  return {fit_program(),
          try_program(),
          batch_program(),
          compare_program(),
          clean_body_program(),
          import_pattern_program(),
          export_pattern_program(),
          find_seams_program(),
          edit_seams_program(),
          mesh_pattern_program(),
          dress_program(),
          ease_map_program(),
          render_program(),
          make_mannequin_program(),
          measure_body_program(),
          measure_pattern_program(),
          pose_body_program(),
          drape_test_program()};
}

}  // namespace toile
