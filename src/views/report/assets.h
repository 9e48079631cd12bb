#pragma once

#include <string_view>

namespace fissure::assets {

/// The contents of the files in report/page and report/vendor, which CMake embeds in the program
/// (embed.cmake).
extern const std::string_view index_html;
extern const std::string_view page_css;
extern const std::string_view shared_js;
extern const std::string_view plots_js;
extern const std::string_view page_js;
extern const std::string_view sweep_css;
extern const std::string_view sweep_data_js;
extern const std::string_view sweep_maps_js;
extern const std::string_view sweep_marks_js;
extern const std::string_view sweep_parallel_js;
extern const std::string_view sweep_curves_js;
extern const std::string_view sweep_js;
extern const std::string_view history_css;
extern const std::string_view history_js;
extern const std::string_view study_css;
extern const std::string_view study_marks_js;
extern const std::string_view study_maps_js;
extern const std::string_view study_fronts_js;
extern const std::string_view study_js;
extern const std::string_view uplot_js;
extern const std::string_view uplot_css;
extern const std::string_view uplot_licence;

}  // namespace fissure::assets
