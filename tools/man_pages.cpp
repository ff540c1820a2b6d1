// Writes the man pages of all programs, from what their --help says, into a folder.
#include <fstream>
#include <iostream>
#include <sstream>

#include "tools/programs.h"

namespace toile {

namespace {

/// Text as roff takes it: no line is a request, no hyphen is typographic.
std::string escaped(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') roff += '\\';
    if (c == '-') roff += '\\';
    if ((c == '.' || c == '\'') && (roff.empty() || roff.back() == '\n')) roff += "\\&";
    roff += c;
  }
  return roff;
}

void write_options(std::ostream& page, const boost::program_options::options_description& options) {
  page << ".SS " << escaped("Options") << '\n';
  for (const auto& option : options.options()) {
    page << ".TP\n.B " << escaped(option->format_name() + " " + option->format_parameter()) << '\n'
         << escaped(option->description()) << '\n';
  }
}

void write_head(std::ostream& page, const std::string& name, const std::string& summary) {
  page << ".TH \"" << name << "\" 1 \"\" \"Toile " << toile_version() << "\" \"Toile\"\n"
       << ".SH NAME\n"
       << escaped(name) << " \\- " << escaped(summary) << '\n';
}

std::string page_name(const CommandLineProgram& program) {
  std::string name = program.name;
  for (char& c : name) {
    if (c == ' ') c = '-';
  }
  return name;
}

std::string page_of(const CommandLineProgram& program) {
  std::ostringstream page;
  write_head(page, page_name(program), program.summary);
  page << ".SH SYNOPSIS\n.nf\n"
       << escaped(program.name + " " + program.usage) << "\n.fi\n"
       << ".SH OPTIONS\n";
  write_options(page, program.options);
  write_options(page, common_options(program));
  if (!program.footer.empty()) page << ".SH NOTES\n" << escaped(program.footer) << '\n';
  page << ".SH EXIT STATUS\n"
       << ".TP\n0\ndone\n"
       << ".TP\n1\nan input or processing error; one message says where and what to do\n"
       << ".TP\n2\na command line that can't be understood\n"
       << ".TP\n3\ndone and written, but the verdict is negative\n"
       << ".SH SEE ALSO\n.BR toile (1)\n";
  return page.str();
}

std::string page_of_toile() {
  std::ostringstream page;
  write_head(page, "toile", toile_summary());
  page << ".SH SYNOPSIS\ntoile COMMAND [arguments]\n.SH COMMANDS\n";
  for (const CommandLineProgram& program : all_programs()) {
    page << ".TP\n.B " << escaped(program.name) << '\n' << escaped(program.summary) << '\n';
  }
  page << ".SH SEE ALSO\n";
  for (const CommandLineProgram& program : all_programs()) {
    page << ".BR " << escaped(page_name(program)) << " (1)\n";
  }
  return page.str();
}

void write(const std::string& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder + "/" + name + ".1") << text;
}

}  // namespace

}  // namespace toile

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: man_pages FOLDER\n";
    return toile::exit_usage;
  }
  toile::write(argv[1], "toile", toile::page_of_toile());
  for (const toile::CommandLineProgram& program : toile::all_programs()) {
    toile::write(argv[1], toile::page_name(program), toile::page_of(program));
  }
}
