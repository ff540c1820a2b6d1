// The command-line programs, each as run_program() takes it.
#pragma once

#include "tools/program.h"

namespace toile {

CommandLineProgram batch_program();
CommandLineProgram clean_body_program();
CommandLineProgram compare_program();
CommandLineProgram drape_test_program();
CommandLineProgram dress_program();
CommandLineProgram ease_map_program();
CommandLineProgram edit_seams_program();
CommandLineProgram export_pattern_program();
CommandLineProgram find_seams_program();
CommandLineProgram fit_program();
CommandLineProgram import_pattern_program();
CommandLineProgram make_mannequin_program();
CommandLineProgram measure_body_program();
CommandLineProgram measure_pattern_program();
CommandLineProgram mesh_pattern_program();
CommandLineProgram pose_body_program();
CommandLineProgram render_program();
CommandLineProgram try_program();

/// What `toile` is.
std::string toile_summary();

/// All of them, in the order in which `toile --help` lists them.
std::vector<CommandLineProgram> all_programs();

}  // namespace toile
