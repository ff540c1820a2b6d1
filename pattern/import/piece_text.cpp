#include "pattern/import/piece_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

namespace toile {

namespace {

constexpr int max_quantity = 1000;

/// Bytes: longer texts are no labels of pieces.
constexpr std::size_t max_label = 200;

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Without capitals, blanks and underscores.
std::string folded_word(const std::string& text) {
  std::string word;
  for (const char c : in_small_letters(text)) {
    if (c != ' ' && c != '_') word += c;
  }
  return word;
}

/// The keys of ASTM D6673, and those that pattern programs write beside them.
constexpr std::array<std::string_view, 27> known_text_keys = {"piece name",
                                                              "size",
                                                              "quantity",
                                                              "material",
                                                              "annotation",
                                                              "category",
                                                              "style name",
                                                              "sample size",
                                                              "units",
                                                              "author",
                                                              "creation date",
                                                              "product",
                                                              "creation time",
                                                              "version",
                                                              "grade rule table",
                                                              "size range",
                                                              "description",
                                                              "grading rule table",
                                                              "rule table",
                                                              "fabric",
                                                              "customer",
                                                              "base size",
                                                              "asme/astm version",
                                                              "aama/astm version",
                                                              "panel",
                                                              "side",
                                                              "left out"};

}  // namespace

std::optional<PieceQuantity> read_quantity(const std::string& given) {
  const std::string text = in_small_letters(given.substr(0, max_label));
  std::vector<int> numbers;
  for (std::size_t i = 0; i < text.size();) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) {
      ++i;
      continue;
    }
    int number = 0;
    for (; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0; ++i) {
      number = std::min(max_quantity, number * 10 + (text[i] - '0'));
    }
    numbers.push_back(number);
  }
  const auto says = [&](std::string_view word) { return text.find(word) != std::string::npos; };
  const bool pairs = says("pair") || says("paar") || says("paire");
  const bool mirrored = says("mirror") || says("spiegel") || says("gegengleich") ||
                        (says("left") && says("right")) || (says("links") && says("rechts"));
  PieceQuantity quantity;
  if (numbers.size() >= 2) {
    quantity.count = numbers[0] + numbers[1];
    quantity.pair = numbers[0] > 0 && numbers[1] > 0;
    quantity.none_mirrored = !quantity.pair;
  } else if (numbers.size() == 1) {
    quantity.count = pairs ? 2 * numbers[0] : numbers[0];
    quantity.pair = (pairs || mirrored) && quantity.count > 1;
  } else if (pairs || mirrored) {
    quantity = {2, true};
  } else {
    return std::nullopt;
  }
  if (quantity.count == 0) return std::nullopt;
  quantity.count = std::min(quantity.count, max_quantity);
  return quantity;
}

namespace {

/// Where the word "cut" stands with a number behind it; npos: nowhere.
std::size_t cut_label(const std::string& line) {
  if (line.size() > max_label) return std::string::npos;
  const std::string small = in_small_letters(line);
  const auto is_word = [&](std::size_t at) {
    return std::isalnum(static_cast<unsigned char>(small[at])) != 0 || small[at] == '_';
  };
  for (std::size_t at = 0; (at = small.find("cut", at)) != std::string::npos; at += 3) {
    if (at > 0 && is_word(at - 1)) continue;
    const std::size_t behind = small.find_first_not_of(" \t", at + 3);
    if (behind == std::string::npos || behind == at + 3) continue;
    if (std::isdigit(static_cast<unsigned char>(small[behind])) != 0) return at;
  }
  return std::string::npos;
}

/// The count of an annotation "2X FABRIC"; of several materials, that of the first.
std::optional<PieceQuantity> times_cut(const std::string& annotation) {
  const std::size_t end = annotation.find_first_not_of("0123456789");
  if (end == 0 || end == std::string::npos || end > 3) return std::nullopt;
  const std::size_t word = annotation.find_first_not_of(' ', end + 1);
  const bool times = annotation[end] == 'X' || annotation[end] == 'x';
  if (!times || word == std::string::npos ||
      std::isalpha(static_cast<unsigned char>(annotation[word])) == 0) {
    return std::nullopt;
  }
  return read_quantity(annotation.substr(0, end));
}

}  // namespace

void PieceTexts::add(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = without_blanks(line);
    if (line.empty()) continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos) {
      const std::string key = without_blanks(in_small_letters(line.substr(0, colon)));
      if (std::find(known_text_keys.begin(), known_text_keys.end(), key) != known_text_keys.end()) {
        values_.emplace(key, without_blanks(line.substr(colon + 1)));
        continue;
      }
    }
    // "Fabric, Cut 2", "Cut 1 on fold", as Valentina's labels have it.
    if (const std::size_t cut = cut_label(line); cut != std::string::npos) {
      cut_quantity_ = read_quantity(line.substr(line.find_first_of("0123456789", cut)));
      std::string material = without_blanks(line.substr(0, cut));
      if (!material.empty() && (material.back() == ',' || material.back() == ';')) {
        material = without_blanks(material.substr(0, material.size() - 1));
      }
      if (cut_material_.empty()) cut_material_ = material;
      continue;
    }
    plain_.push_back(line);
    ++others_;
  }
}

std::string PieceTexts::value(const std::string& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? "" : found->second;
}

std::optional<PieceQuantity> PieceTexts::quantity() const {
  if (auto stated = read_quantity(value("quantity"))) return stated;
  if (cut_quantity_) return cut_quantity_;
  return times_cut(value("annotation"));
}

std::string PieceTexts::material() const {
  if (!value("material").empty()) return value("material");
  return value("fabric").empty() ? cut_material_ : value("fabric");
}

std::string PieceTexts::spelling_of(const std::string& name) const {
  const auto found = std::find_if(plain_.begin(), plain_.end(), [&](const std::string& line) {
    return folded_word(line) == folded_word(name);
  });
  return found == plain_.end() ? "" : *found;
}

}  // namespace toile
