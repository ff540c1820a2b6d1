#include "toile/measure.h"

#include <nlohmann/json.hpp>

#include "io/json_words.h"
#include "library/rooms.h"
#include "tools/measure_body/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

std::string measure(const Body& body, const MeasureChoices& choices) {
  return guarded([&] {
    if (choices.unit != "cm" && choices.unit != "inch") {
      throw Error("unit", in_quotes(choices.unit) + " is unknown", "use cm or inch");
    }
    MeasureBodySettings settings;
    settings.freehand = choices.freehand;
    settings.unit = choices.unit;
    return json_text(measures_json(take_measures(skin_in(body), "body", settings), {}));
  });
}

}  // namespace library
}  // namespace toile
