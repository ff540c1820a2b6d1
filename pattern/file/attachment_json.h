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

/// Girths of the torso that a level can be at, besides the joints: the fullest in front and behind.
inline constexpr std::array<std::string_view, 2> girth_names = {"bust", "hip"};

/// Reads the entries of a panel's `attach`. Lengths in the file are in units of `unit` metres.
/// `edges` is the panel's own array; its vertices have been checked. Throws Error for edges and
/// vertices that the panel lacks, unknown keys and landmarks, and numbers out of range.
std::vector<PanelAttachment> read_panel_attachments(const JsonValue& attach, const JsonValue& edges,
                                                    double unit);

/// Reads the target and the spring of one entry. Other keys are ignored, the held edge or vertex
/// among them. Throws Error as read_panel_attachments does.
Attachment read_attachment(const JsonValue& entry, double unit);

/// The attachment as JSON, in metres: read_attachment with unit 1 gives the same back.
nlohmann::ordered_json attachment_json(const Attachment& attachment);

}  // namespace toile
