#include "io/measures_file.h"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <set>

#include "geometry/error.h"
#include "io/csv.h"
#include "io/json_value.h"
#include "io/line_scanner.h"
#include "io/measure_names.h"
#include "io/measure_words.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

constexpr double centimetre = 0.01;
constexpr double millimetre = 0.001;

/// Metres of a unit's name; nothing for another word.
std::optional<double> unit_of(std::string_view name) {
  if (name == "mm") return millimetre;
  if (name == "cm") return centimetre;
  if (name == "m") return 1.0;
  if (name == "in" || name == "inch" || name == "inches") return 0.0254;
  return std::nullopt;
}

double unit_named(const std::string& name, const std::string& place) {
  const std::optional<double> unit = unit_of(name);
  if (!unit) throw Error(place, "'" + shown_text(name) + "' is no unit", "give cm, mm, m or inch");
  return *unit;
}

/// Whether a word is known and counts in units of length.
bool is_length(std::string_view word) {
  const std::optional<MeasureWord> known = measure_of_word(word);
  return known && find_measure_name(known->measure.name)->unit == MeasureUnit::length;
}

/// Adds a measure by a word for it; an unknown one is left out.
void add(MeasureSet& set, const std::string& word, double value, double unit,
         const std::string& place) {
  const std::optional<MeasureWord> known = measure_of_word(word);
  if (!known) {
    set.left_out.push_back(valid_utf8(word));
    return;
  }
  const bool counts = is_length(word);
  if (!std::isfinite(value) || (counts && !(value > 0))) {
    std::string what = shown_text(word);
    what.append(" is ").append(number_text(value)).append(", which is no length");
    throw Error(place, what, "give a positive number, or leave the measure out");
  }
  const std::string whole = known->side + std::string(known->measure.name);
  value /= known->measure.factor;
  if (!set.values.emplace(whole, counts ? value * unit : value).second) {
    throw Error(place, whole + " is there twice", "leave one out");
  }
  if (whole != word) set.taken_as.emplace(valid_utf8(word), whole);
}

/// Adds what another program's names say. A sum of measures gives the one that is still missing.
void add_foreign(MeasureSet& set, const std::map<std::string, double>& read,
                 DraftingProgram program, double unit, const std::string& place) {
  std::set<std::string> known;
  std::vector<const ForeignMeasure*> sums;
  for (const ForeignMeasure& measure : foreign_measures(program)) {
    const std::string name(measure.name);
    const auto found = read.find(name);
    if (found == read.end()) continue;
    known.insert(name);
    // Programs write 0 for what nobody measured.
    if (found->second == 0) {
      set.left_out.push_back(name);
    } else if (measure.terms.size() > 1) {
      sums.push_back(&measure);
    } else {
      const MeasureTerm& term = measure.terms.front();
      add(set, std::string(term.name), found->second / term.factor, unit,
          std::string(place).append(": ").append(name));
    }
  }
  for (const ForeignMeasure* measure : sums) {
    double rest = read.at(std::string(measure->name)) * unit;
    std::vector<const MeasureTerm*> missing;
    for (const MeasureTerm& term : measure->terms) {
      const auto found = set.values.find(std::string(term.name));
      if (found == set.values.end()) {
        missing.push_back(&term);
      } else {
        rest -= term.factor * found->second;
      }
    }
    if (missing.size() == 1) {
      add(set, std::string(missing[0]->name), rest / missing[0]->factor, 1,
          place + ": " + std::string(measure->name));
    } else if (!missing.empty()) {
      set.left_out.emplace_back(measure->name);
    }
  }
  for (const auto& [name, value] : read) {
    if (!known.contains(name)) set.left_out.push_back(valid_utf8(name));
  }
}

bool is_freesewing(const JsonValue& root) {
  if (root.find("height") || root.find("hip") || root.find("bust")) return false;
  return root.find("seat") || root.find("hips") || root.find("chest") || root.find("hpsToBust");
}

void read_json(const std::string& text, const std::string& name, std::optional<double> asked,
               MeasureSet& set) {
  const JsonDocument document(text, name);
  const JsonValue root = document.root();
  if (!root.is_object()) root.fail("is no object of measures");
  if (const auto measures = root.find("measures")) {
    double unit = asked.value_or(centimetre);
    if (const auto stated = root.find("unit")) unit = unit_named(stated->text(), stated->place());
    for (const std::string& key : measures->keys()) {
      const auto measure = measures->find(key);
      if (!measure) continue;
      if (!measure->is_object()) {
        add(set, key, measure->number(), unit, measure->place());
        continue;
      }
      const auto value = measure->find("value");
      if (!value) continue;
      double own = unit;
      const auto stated = measure->find("unit");
      if (stated && is_length(key)) own = unit_named(stated->text(), stated->place());
      add(set, key, value->number(), own, measure->place());
    }
    return;
  }
  std::optional<JsonValue> block;
  for (const char* key : {"measies", "measurements"}) {
    if (!block) block = root.find(key);
  }
  const bool is_foreign = block || is_freesewing(root);
  if (!block) block = root;
  if (!block->is_object()) block->fail("is no object of measures");
  std::map<std::string, double> read;
  for (const std::string& key : block->keys()) {
    const auto value = block->find(key);
    if (!value || value->is_text() || value->is_flag() || value->is_object() || value->is_array()) {
      if (value) set.left_out.push_back(valid_utf8(key));
      continue;
    }
    if (is_foreign) {
      read[key] = value->number();
    } else {
      add(set, key, value->number(), asked.value_or(centimetre), value->place());
    }
  }
  if (is_foreign) {
    add_foreign(set, read, DraftingProgram::freesewing, asked.value_or(millimetre), name);
  }
}

void read_csv(const std::string& text, const std::string& name, std::optional<double> asked,
              MeasureSet& set) {
  const std::vector<CsvRow> rows = parse_csv(text, name);
  std::size_t at_name = 0;
  std::size_t at_value = 1;
  std::size_t at_unit = 2;
  for (const CsvRow& row : rows) {
    const std::string place = name + ":" + std::to_string(row.line);
    if (row.fields.size() < 2) {
      throw Error(place, "has no value", "write a name, a comma and a number");
    }
    if (&row == &rows.front() && std::ranges::find(row.fields, "value") != row.fields.end()) {
      for (std::size_t i = 0; i < row.fields.size(); ++i) {
        const std::string& column = row.fields[i];
        if (column == "measure" || column == "name") at_name = i;
        if (column == "value") at_value = i;
        if (column == "unit") at_unit = i;
      }
      continue;
    }
    if (std::max(at_name, at_value) >= row.fields.size() || row.fields[at_value].empty()) {
      if (at_name < row.fields.size()) set.left_out.push_back(valid_utf8(row.fields[at_name]));
      continue;
    }
    const std::optional<double> value = parse_number(row.fields[at_value]);
    if (!value) {
      throw Error(place, "'" + shown_text(row.fields[at_value]) + "' is no number",
                  "write a name, a comma and a number");
    }
    double unit = asked.value_or(centimetre);
    const bool states_unit = at_unit < row.fields.size() && !row.fields[at_unit].empty();
    if (states_unit && is_length(row.fields[at_name])) {
      unit = unit_named(row.fields[at_unit], place);
    }
    add(set, row.fields[at_name], *value, unit, place);
  }
}

void read_seamly(const std::string& text, const std::string& name, std::optional<double> asked,
                 MeasureSet& set) {
  pugi::xml_document document;
  const pugi::xml_parse_result done = document.load_buffer(text.data(), text.size());
  if (!done) {
    throw Error(name, std::string("is no XML: ") + done.description(), "save it anew in SeamlyMe");
  }
  const pugi::xml_node root = document.document_element();
  const pugi::xml_node body = root.child("body-measurements");
  if (!body) {
    throw Error(name, "has no <body-measurements>", "give a file of SeamlyMe or Valentina");
  }
  const std::string stated = root.child("unit").text().get();
  const double unit = stated.empty() ? asked.value_or(centimetre) : unit_named(stated, name);
  set.gender = root.child("personal").child("gender").text().get();
  if (set.gender != "female" && set.gender != "male") set.gender.clear();
  std::map<std::string, double> read;
  for (const pugi::xml_node measure : body.children("m")) {
    const std::string key = measure.attribute("name").value();
    const pugi::xml_attribute value =
        measure.attribute("value") ? measure.attribute("value") : measure.attribute("base");
    const std::optional<double> number = parse_number(value.value());
    if (!number) {
      set.left_out.push_back(valid_utf8(key));
    } else if (!read.emplace(key, *number).second) {
      throw Error(name, shown_text(key) + " is there twice", "leave one out");
    }
  }
  add_foreign(set, read, DraftingProgram::valentina, unit, name);
}

void read_yaml(const std::string& text, const std::string& name, std::optional<double> asked,
               MeasureSet& set) {
  std::map<std::string, double> read;
  LineScanner lines(text, name);
  while (lines.next_line('#')) {
    std::string key(lines.word());
    if (key == "body:" || key == "---") continue;
    if (key.size() < 2 || key.back() != ':') lines.fail("is no measure", "write name: number");
    key.pop_back();
    const std::optional<double> value = parse_number(lines.word());
    if (!value) {
      set.left_out.push_back(valid_utf8(key));
    } else if (!read.emplace(key, *value).second) {
      lines.fail(shown_text(key) + " is there twice", "leave one out");
    }
  }
  add_foreign(set, read, DraftingProgram::garmentcode, asked.value_or(centimetre), name);
}

}  // namespace

MeasureSet read_measures(const fs::path& path, std::optional<double> metres_per_unit) {
  std::string end = path.extension().string();
  std::ranges::transform(end, end.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const std::string name = path.string();
  MeasureSet set;
  if (end == ".json") {
    read_json(read_file(path), name, metres_per_unit, set);
  } else if (end == ".csv") {
    read_csv(read_file(path), name, metres_per_unit, set);
  } else if (end == ".vit" || end == ".smis" || end == ".vst" || end == ".smms") {
    read_seamly(read_file(path), name, metres_per_unit, set);
  } else if (end == ".yaml" || end == ".yml") {
    read_yaml(read_file(path), name, metres_per_unit, set);
  } else {
    throw Error(name, "is no file of measures by its name",
                "give .json, .csv, .vit, .smis, .vst, .smms or .yaml");
  }
  if (set.values.empty()) {
    throw Error(name, "has no measure that is known here", "make-mannequin --help lists them");
  }
  return set;
}

void add_measure(const std::string& text, double metres_per_unit, MeasureSet& set) {
  const std::size_t equals = text.find('=');
  const std::string place = "--measures";
  if (equals == std::string::npos || equals == 0) {
    throw Error(place, "'" + shown_text(text) + "' is no measure",
                "write name=number, bust=94 say");
  }
  const std::string name = text.substr(0, equals);
  if (!measure_of_word(name)) {
    throw Error(place, "there is no measure '" + shown_text(name) + "'",
                "make-mannequin --help lists the names");
  }
  std::string number = text.substr(equals + 1);
  double unit = metres_per_unit;
  const std::size_t letters = number.find_last_not_of("abcdefghijklmnopqrstuvwxyz");
  if (letters != std::string::npos && letters + 1 < number.size()) {
    unit = unit_named(number.substr(letters + 1), place);
    number.resize(letters + 1);
  }
  const std::optional<double> value = parse_number(number);
  if (!value) {
    throw Error(place, "'" + shown_text(text) + "' has no number",
                "write name=number, bust=94 say");
  }
  add(set, name, *value, unit, place);
}

}  // namespace toile
