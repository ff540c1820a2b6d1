// Texts of DXF without their format codes.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// A TEXT's content: %%d and the like, and \U+XXXX, become the characters that they stand for.
std::string plain_dxf_text(std::string_view text);

/// An MTEXT's content without fonts, heights and colours. Paragraphs (\P) are lines.
std::string plain_dxf_paragraphs(std::string_view text);

}  // namespace toile
