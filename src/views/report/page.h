#pragma once

#include <filesystem>
#include <string>

#include "report/report_run.h"

namespace fissure {

/// The text of a self-contained HTML file with style, script, the plotting library and its licence, and
/// `data` as JSON, escaped so that nothing in it can begin or end a tag. Invalid UTF-8 is replaced. A content
/// security policy forbids the page to load anything and to run any scripts but its own. The same data give
/// the same bytes.
std::string pageText(const PageJson& data);

/// `text` with all characters that have a meaning in HTML (tags, entities, ends of attributes) replaced by
/// entities.
std::string escapedHtml(const std::string& text);

/// The path of a URL that leads to a file, with all but letters, digits and a few marks escaped.
std::string linkTo(const std::filesystem::path& page);

}  // namespace fissure
