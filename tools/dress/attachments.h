// What dress says of attachments.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "cloth/model/attachments.h"
#include "tools/program.h"

namespace toile {

nlohmann::ordered_json attachments_json(const std::vector<AttachmentFigures>& attachments);

/// A line for each, and a warning for one that did not hold.
void say_attachments(const std::vector<AttachmentFigures>& attachments,
                     const CommonSettings& common);

}  // namespace toile
