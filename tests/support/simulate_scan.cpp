// Scans a body as a model of a scanner would see it: for trying programs without a scanner.
//
//   simulate-scan BODY -o SCAN.xyz [--points 100000] [--noise-mm 1] [--seed 1]
//
// The body is a clean one in metres that stands along y. What is written is a table of points, one
// a line: the body, the floor and outliers. Nothing is measured at armpits, crotch and crown.
#include <boost/program_options.hpp>
#include <cstdio>
#include <iostream>

#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "tests/support/scanner.h"

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  using namespace toile;
  std::string body;
  std::string output;
  double noise = 0;
  test::Scanner scanner;
  po::options_description options("simulate-scan BODY -o SCAN.xyz");
  options.add_options()("help", "says this")("body", po::value(&body)->required(), "the body")(
      "output,o", po::value(&output)->required(), "the file of points")(
      "points", po::value(&scanner.points)->default_value(100000), "about how many")(
      "noise-mm", po::value(&noise)->default_value(1), "standard deviation along the ray")(
      "seed", po::value(&scanner.seed)->default_value(1), "another one is another scan");
  po::positional_options_description first;
  first.add("body", 1);
  try {
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(options).positional(first).run(), given);
    if (given.count("help") > 0) {
      std::cout << options;
      return 0;
    }
    po::notify(given);
    scanner.noise = noise / 1000;
    const test::Scan scan = test::scan_body(fan_triangles(read_mesh(body)), scanner);
    std::string text;
    for (const Vec3& p : scan.cloud.points) {
      char line[96];
      std::snprintf(line, sizeof line, "%.5f %.5f %.5f\n", p.x(), p.y(), p.z());
      text += line;
    }
    write_file(OutputPath(output), text);
  } catch (const po::error& error) {
    std::cerr << "simulate-scan: " << error.what() << "\n";
    return 2;
  } catch (const Error& error) {
    std::cerr << "simulate-scan: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
