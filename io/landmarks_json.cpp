#include "io/landmarks_json.h"

#include "io/text.h"

namespace toile {

nlohmann::ordered_json landmarks_json(const Landmarks& landmarks) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Landmark& landmark : landmarks) {
    nlohmann::ordered_json entry;
    entry["place_m"] = nullptr;
    if (landmark.place) {
      entry["place_m"] = {landmark.place->x(), landmark.place->y(), landmark.place->z()};
    }
    entry["confidence"] = landmark.confidence;
    if (!landmark.reason.empty()) entry["reason"] = valid_utf8(landmark.reason);
    json[landmark.name] = entry;
  }
  return json;
}

}  // namespace toile
