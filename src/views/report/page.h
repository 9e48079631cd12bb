#pragma once

#include <string>

#include "report/report_run.h"

namespace fissure {

/// One HTML file that needs no other: style, script, the plotting library with its licence, and `data` as
/// JSON, in which nothing can end or begin a tag. Invalid UTF-8 in it is replaced. A content security policy
/// forbids the page to load anything and to run any script but its own. The same data give the same bytes.
std::string pageText(const PageJson& data);

/// `text` with what HTML would take for tags, entities or the end of an attribute written as entities.
std::string escapedHtml(const std::string& text);

}  // namespace fissure
