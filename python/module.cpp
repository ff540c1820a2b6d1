// toile._toile: include/toile for Python. Arrays are copies; reports are dicts.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <string>
#include <vector>

#include "toile/clean.h"
#include "toile/dress.h"
#include "toile/ease.h"
#include "toile/files.h"
#include "toile/find_seams.h"
#include "toile/import.h"
#include "toile/measure.h"
#include "toile/mesh.h"

namespace py = pybind11;
using namespace toile;
using std::string;
using Texts = std::vector<string>;
using Path = std::filesystem::path;

namespace {

template <typename T, std::size_t n>
py::array_t<T> rows_out(const std::vector<std::array<T, n>>& rows) {
  py::array_t<T> array({rows.size(), n});
  std::copy_n(rows.empty() ? nullptr : rows.front().data(), n * rows.size(), array.mutable_data());
  return array;
}

/// Rows of `n` numbers. Throws Error, naming `what`, for another shape and for fractions where
/// indices are meant.
template <typename T, std::size_t n>
std::vector<std::array<T, n>> rows_in(const py::object& given, const string& what) {
  const py::array any = py::array::ensure(given);
  const bool is_number = any && string("iuf").find(any.dtype().kind()) != string::npos;
  if (!is_number || (std::is_integral_v<T> && any.size() > 0 && any.dtype().kind() == 'f')) {
    throw Error(what, "is no array of " + string(std::is_integral_v<T> ? "indices" : "numbers"),
                "");
  }
  const bool is_table = any.ndim() == 2 && static_cast<std::size_t>(any.shape(1)) == n;
  if (!is_table && any.size() > 0) {
    throw Error(what, "does not have " + std::to_string(n) + " columns", "give one row each");
  }
  const auto array = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(any);
  std::vector<std::array<T, n>> rows(is_table ? static_cast<std::size_t>(array.shape(0)) : 0);
  if (!rows.empty()) std::copy_n(array.data(), n * rows.size(), rows.front().data());
  return rows;
}

/// A JSON text as a dict; None: there is none.
py::object json_out(const string& text) {
  return text.empty() ? py::none() : py::module_::import("json").attr("loads")(text);
}

string json_in(const py::object& value) {
  return value.is_none() ? string()
                         : py::module_::import("json").attr("dumps")(value).cast<string>();
}

/// Calls what takes long, while other threads of Python run.
template <typename Work>
auto unlocked(const Work& work) {
  const py::gil_scoped_release release;
  return work();
}

/// A member that is an array.
template <typename Value, typename T, std::size_t n>
void add_rows(py::class_<Value>& type, const char* name,
              std::vector<std::array<T, n>> Value::*member) {
  type.def_property(
      name, [member](const Value& value) { return rows_out(value.*member); },
      [member, name](Value& value, const py::object& rows) {
        value.*member = rows_in<T, n>(rows, name);
      });
}

/// A member that is a JSON text.
template <typename Value>
void add_json(py::class_<Value>& type, const char* name, string Value::*member) {
  type.def_property(
      name, [member](const Value& value) { return json_out(value.*member); },
      [member](Value& value, const py::object& json) { value.*member = json_in(json); });
}

void add_values(py::module_& module) {
  py::class_<Mesh> mesh(module, "Mesh");
  mesh.def(
      py::init([](const py::object& points, const py::object& triangles) {
        return Mesh{rows_in<double, 3>(points, "points"), rows_in<int, 3>(triangles, "triangles")};
      }),
      py::arg("points"), py::arg("triangles") = py::list());
  add_rows(mesh, "points", &Mesh::points);
  add_rows(mesh, "triangles", &Mesh::triangles);

  py::class_<Body> body(module, "Body");
  body.def(
      py::init([](const py::object& points, const py::object& triangles, const py::object& joints) {
        return Body{rows_in<double, 3>(points, "points"), rows_in<int, 3>(triangles, "triangles"),
                    json_in(joints), ""};
      }),
      py::arg("points"), py::arg("triangles"), py::arg("joints") = py::none());
  add_rows(body, "points", &Body::points);
  add_rows(body, "triangles", &Body::triangles);
  add_json(body, "joints", &Body::joints);
  add_json(body, "report", &Body::report);

  py::class_<SewingPattern> pattern(module, "SewingPattern");
  pattern.def(py::init([](const py::object& json, const string& name) {
                return SewingPattern{json_in(json), name, ""};
              }),
              py::arg("json"), py::arg("name") = "pattern");
  add_json(pattern, "json", &SewingPattern::json);
  pattern.def_readwrite("name", &SewingPattern::name);
  add_json(pattern, "report", &SewingPattern::report);

  py::class_<Garment> garment(module, "Garment");
  garment.def(py::init([](const py::object& flat, const py::object& placed,
                          const py::object& triangles, const py::object& json) {
                return Garment{rows_in<double, 2>(flat, "flat"),
                               rows_in<double, 3>(placed, "placed"),
                               rows_in<int, 3>(triangles, "triangles"), json_in(json), ""};
              }),
              py::arg("flat"), py::arg("placed"), py::arg("triangles"), py::arg("json"));
  add_rows(garment, "flat", &Garment::flat);
  add_rows(garment, "placed", &Garment::placed);
  add_rows(garment, "triangles", &Garment::triangles);
  add_json(garment, "json", &Garment::json);
  add_json(garment, "report", &Garment::report);

  py::class_<Drape> drape(module, "Drape");
  drape.def(py::init([](const py::object& points, const py::object& triangles, const Garment& of) {
              return Drape{rows_in<double, 3>(points, "points"),
                           rows_in<int, 3>(triangles, "triangles"),
                           of,
                           {},
                           ""};
            }),
            py::arg("points"), py::arg("triangles"), py::arg("garment"));
  add_rows(drape, "points", &Drape::points);
  add_rows(drape, "triangles", &Drape::triangles);
  drape.def_readwrite("garment", &Drape::garment);
  add_rows(drape, "started", &Drape::started);
  add_json(drape, "report", &Drape::report);
}

void add_files(py::module_& module) {
  const py::call_guard<py::gil_scoped_release> release;
  module.def("read_mesh", &read_mesh, py::arg("file"), release);
  module.def("read_body", &read_body, py::arg("file"), release);
  module.def("read_pattern", &read_pattern, py::arg("file"), release);
  module.def("read_garment", &read_garment, py::arg("file"), release);
  module.def("read_drape", &read_drape, py::arg("file"), py::arg("garment"), release);
  const auto add_write = [&]<typename Value>(void (*write_value)(const Value&, const Path&)) {
    module.def("write", write_value, py::arg("value"), py::arg("file"), release);
  };
  add_write.operator()<Body>(&write);
  add_write.operator()<SewingPattern>(&write);
  add_write.operator()<Garment>(&write);
  add_write.operator()<Drape>(&write);
}

void add_body_functions(py::module_& module) {
  const auto add_clean = [&]<typename From>(Body (*clean_it)(const From&, const CleanChoices&),
                                            const char* from) {
    module.def(
        "clean",
        [clean_it](const From& given, const std::optional<double>& metres_per_unit,
                   const std::optional<double>& height, const string& up, const string& front,
                   bool as_points, const std::optional<double>& edge_length) {
          return clean_it(given, {metres_per_unit, height, up, front, as_points, edge_length});
        },
        py::arg(from), py::kw_only(), py::arg("metres_per_unit") = py::none(),
        py::arg("height") = py::none(), py::arg("up") = "", py::arg("front") = "",
        py::arg("as_points") = false, py::arg("edge_length") = py::none(),
        py::call_guard<py::gil_scoped_release>());
  };
  add_clean.operator()<Mesh>(&clean, "mesh");
  add_clean.operator()<std::vector<Path>>(&clean, "files");
  module.def("mannequin", &mannequin, py::arg("measures") = std::map<string, double>(),
             py::arg("figure") = "", py::call_guard<py::gil_scoped_release>());
  module.def(
      "measure",
      [](const Body& body, const Texts& freehand, const string& unit) {
        return json_out(unlocked([&] { return measure(body, {freehand, unit}); }));
      },
      py::arg("body"), py::kw_only(), py::arg("freehand") = Texts(), py::arg("unit") = "cm");
}

void add_pattern_functions(py::module_& module) {
  const py::call_guard<py::gil_scoped_release> release;
  module.def(
      "import_pattern",
      [](const Path& drawing, const std::optional<double>& metres_per_unit, const string& size,
         const std::optional<double>& seam_allowance, const Texts& unfold, const Texts& names,
         const Texts& pairs, const Texts& singles, const Texts& without, bool cut_line) {
        return import_pattern(drawing, {metres_per_unit, size, seam_allowance, unfold, names, pairs,
                                        singles, without, cut_line});
      },
      py::arg("drawing"), py::kw_only(), py::arg("metres_per_unit") = py::none(),
      py::arg("size") = "", py::arg("seam_allowance") = py::none(), py::arg("unfold") = Texts(),
      py::arg("names") = Texts(), py::arg("pairs") = Texts(), py::arg("singles") = Texts(),
      py::arg("without") = Texts(), py::arg("cut_line") = false, release);
  module.def(
      "find_seams",
      [](const SewingPattern& pattern, bool keep, const Texts& sewn, const Texts& with,
         const Texts& without, double min_confidence, double time_limit) {
        return find_seams(pattern, {keep, sewn, with, without, min_confidence, time_limit});
      },
      py::arg("pattern"), py::kw_only(), py::arg("keep") = false, py::arg("sewn") = Texts(),
      py::arg("with_") = Texts(), py::arg("without") = Texts(),
      py::arg("min_confidence") = FindSeamsChoices().min_confidence,
      py::arg("time_limit") = FindSeamsChoices().time_limit, release);
  module.def(
      "mesh",
      [](const SewingPattern& pattern, double edge_length, int subdivisions) {
        return mesh(pattern, {edge_length, subdivisions});
      },
      py::arg("pattern"), py::kw_only(), py::arg("edge_length") = MeshChoices().edge_length,
      py::arg("subdivisions") = MeshChoices().subdivisions, release);
}

void add_drape_functions(py::module_& module) {
  module.def(
      "dress",
      [](const Garment& garment, const Body& body, const string& fabric,
         const std::map<string, string>& fabrics, const string& quality, bool has_floor,
         const std::optional<Drape>& earlier) {
        return dress(garment, body, {fabric, fabrics, quality, has_floor, earlier});
      },
      py::arg("garment"), py::arg("body"), py::kw_only(), py::arg("fabric") = DressChoices().fabric,
      py::arg("fabrics") = std::map<string, string>(), py::arg("quality") = DressChoices().quality,
      py::arg("has_floor") = true, py::arg("earlier") = py::none(),
      py::call_guard<py::gil_scoped_release>());
  module.def(
      "judge",
      [](const Drape& drape, const Body& body) {
        return json_out(unlocked([&] { return judge(drape, body); }));
      },
      py::arg("drape"), py::arg("body"));
  module.def(
      "ease",
      [](const Drape& drape, const Body& body, const string& target,
         const std::vector<double>& heights, const std::optional<double>& contact) {
        return json_out(unlocked([&] { return ease(drape, body, {target, heights, contact}); }));
      },
      py::arg("drape"), py::arg("body"), py::kw_only(), py::arg("target") = "",
      py::arg("heights") = std::vector<double>(), py::arg("contact") = py::none());
  module.def(
      "gaps",
      [](const Drape& drape, const Body& body) {
        const std::vector<double> all = unlocked([&] { return gaps(drape, body); });
        return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
      },
      py::arg("drape"), py::arg("body"));
}

}  // namespace

PYBIND11_MODULE(_toile, module) {
  py::register_exception<Error>(module, "Error");
  add_values(module);
  add_files(module);
  add_body_functions(module);
  add_pattern_functions(module);
  add_drape_functions(module);
}
