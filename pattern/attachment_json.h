// The entries of a panel's `attach`, as docs/pattern.schema.json states them.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "io/json_value.h"
#include "pattern/attachment.h"
#include "pattern/pattern.h"

namespace toile {

/// Girths that a level can be at, besides the joints: the fullest ones in front and behind.
inline constexpr std::array<std::string_view, 2> girth_names = {"bust", "hip"};

/// The entries of a panel's `attach`, their lengths times `unit` metres; `edges` are the panel's,
/// whose vertices are known to be there. Throws Error for edges and vertices that it lacks, unknown
/// keys and landmarks, and numbers that make no sense.
std::vector<PanelAttachment> read_panel_attachments(const JsonValue& attach, const JsonValue& edges,
                                                    double unit);

/// How one of them is held; what it holds, and other keys, are not looked at.
Attachment read_attachment(const JsonValue& entry, double unit);

/// What read_attachment reads back the same with unit 1.
nlohmann::ordered_json attachment_json(const Attachment& attachment);

}  // namespace toile
