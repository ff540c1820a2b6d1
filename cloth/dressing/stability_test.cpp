#include "cloth/dressing/stability_test.h"

#include <utility>

#include "cloth/dressing/constants.h"

namespace toile {

ReleaseReport test_stability(const GarmentModel& model, ReleaseOptions options, RestingState& state,
                             const std::function<void(RestingState&)>& come_to_rest) {
  options.warm_start = &state.warm_start;
  for (int returns = 0;; ++returns) {
    std::vector<Vec3> nodes = state.nodes;
    ReleaseReport report = release(model, options, nodes);
    if (report.stays() || !state.at_rest || returns == max_returns) return report;
    state.nodes = std::move(nodes);
    state.warm_start = report.warm_start;
    come_to_rest(state);
  }
}

}  // namespace toile
