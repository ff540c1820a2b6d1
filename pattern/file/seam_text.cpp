#include "pattern/file/seam_text.h"

#include <sstream>

#include "geometry/error.h"

namespace toile {

namespace {

constexpr int max_seam_number = 1'000'000;

}  // namespace

std::string seam_text(const SeamText& seam) {
  std::string text = "Seam: " + std::to_string(seam.number) + (seam.second ? " b" : " a");
  if (seam.direction == StitchDirection::by_position) text += " found";
  if (seam.layered) text += " layer";
  if (seam.gathered) text += " gather";
  if (seam.gathered && seam.fullness > 0) text += " " + number_text(seam.fullness, 6);
  return text;
}

std::optional<SeamText> read_seam_text(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  SeamText seam;
  if (!(words >> word) || word != "Seam:" || !(words >> seam.number >> word)) return std::nullopt;
  if (seam.number < 1 || seam.number > max_seam_number) return std::nullopt;
  if (word != "a" && word != "b") return std::nullopt;
  seam.second = word == "b";
  while (words >> word) {
    if (word == "found") {
      seam.direction = StitchDirection::by_position;
    } else if (word == "layer") {
      seam.layered = true;
    } else if (word == "gather") {
      seam.gathered = true;
      double fullness = 0;
      if (words >> fullness && fullness >= 1 && fullness <= 20) seam.fullness = fullness;
      words.clear();
    } else {
      return std::nullopt;
    }
  }
  return seam;
}

}  // namespace toile
