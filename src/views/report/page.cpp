#include "report/page.h"

#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/hash.h"
#include "report/assets.h"

namespace fissure {

namespace {

/// '<' stands in JSON only within strings.
std::string scriptSafe(const PageJson& data) {
  const std::string json = data.dump(-1, ' ', false, PageJson::error_handler_t::replace);
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

/// `frame` with each {{name}} replaced; what is put in is not looked through again.
std::string filledIn(std::string_view frame, const std::map<std::string, std::string_view>& values) {
  std::string text;
  for (;;) {
    const std::size_t open = frame.find("{{");
    text += frame.substr(0, open);
    if (open == std::string_view::npos) return text;
    const std::size_t close = frame.find("}}", open);
    const auto value = values.find(std::string(frame.substr(open + 2, close - open - 2)));
    if (value == values.end()) throw std::logic_error("the page's frame has an unknown place");
    text += value->second;
    frame.remove_prefix(close + 2);
  }
}

std::string joined(const std::vector<std::string_view>& pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text.append(piece).append("\n");
  return text;
}

struct Parts {
  std::vector<std::string_view> styles, scripts;
};

/// What a page of a kind is made of, in this order.
Parts partsOf(const std::string& kind) {
  if (kind == "sweep")
    return {{assets::page_css, assets::sweep_css},
            {assets::shared_js, assets::sweep_data_js, assets::sweep_marks_js, assets::sweep_maps_js,
             assets::sweep_parallel_js, assets::sweep_curves_js, assets::sweep_js}};
  if (kind == "study")
    return {{assets::page_css, assets::study_css},
            {assets::shared_js, assets::plots_js, assets::study_marks_js, assets::study_maps_js,
             assets::study_fronts_js, assets::study_js}};
  if (kind == "history")
    return {{assets::page_css, assets::history_css},
            {assets::shared_js, assets::plots_js, assets::history_js}};
  return {{assets::page_css, ""}, {assets::shared_js, assets::plots_js, assets::page_js}};
}

}  // namespace

std::string escapedHtml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string linkTo(const std::filesystem::path& page) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string link;
  for (const char c : page.generic_string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                       std::string_view("/-._~").find(c) != std::string_view::npos);
    if (plain)
      link += c;
    else
      link += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return link;
}

std::string pageText(const PageJson& data) {
  const std::string json = scriptSafe(data);
  // Through JSON, which replaces invalid UTF-8.
  const std::string title =
      PageJson::parse(PageJson(data.at("title")).dump(-1, ' ', false, PageJson::error_handler_t::replace));
  const std::string shown_title = escapedHtml(title);
  const std::string nonce = fnv1a64(json);  // known to no text that was written before the page was
  const Parts parts = partsOf(data.value("kind", ""));
  const std::string style = joined(parts.styles), scripts = joined(parts.scripts);
  return filledIn(assets::index_html, {{"title", shown_title},
                                       {"nonce", nonce},
                                       {"page_css", style},
                                       {"scripts", scripts},
                                       {"uplot_css", assets::uplot_css},
                                       {"uplot_js", assets::uplot_js},
                                       {"uplot_licence", assets::uplot_licence},
                                       {"data", json}});
}

}  // namespace fissure
