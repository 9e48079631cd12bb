#include "render/font.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fissure::font {
namespace {

/// One entry a character from ' ' to '~'. Each pair of digits is a point (x, y); a blank lifts the pen. Base
/// line y = 2, small letters up to 6, capitals up to 8.
constexpr std::array<std::string_view, 95> glyphs = {
    "",                                  // space
    "2824 2222",                         // !
    "1816 3836",                         // "
    "1218 3238 0444 0646",               // #
    "473818070615354443321203 2921",     // $
    "0248 0818170708 3343423233",        // %
    "4216172837360403122244",            // &
    "2826",                              // '
    "39272331",                          // (
    "19272311",                          // )
    "2723 0644 0446",                    // *
    "2723 0545",                         // +
    "2211",                              // ,
    "0545",                              // -
    "2222",                              // .
    "0149",                              // /
    "123243473818070312 1436",           // 0
    "072822 0242",                       // 1
    "07183847460242",                    // 2
    "07183847463515 354443321203",       // 3
    "32380444",                          // 4
    "480805354443321203",                // 5
    "4738180703123243443505",            // 6
    "084812",                            // 7
    "15060718384746351504031232434435",  // 8
    "0312324347381807061545",            // 9
    "2525 2222",                         // :
    "2525 2211",                         // ;
    "470543",                            // <
    "0646 0444",                         // =
    "074503",                            // >
    "071838474624 2222",                 // ?
    "4212030718384744242646",            // @
    "022842 1434",                       // A
    "02083847463505 3544433202",         // B
    "4738180703123243",                  // C
    "02082846442202",                    // D
    "48080242 0535",                     // E
    "480802 0535",                       // F
    "47381807031232434525",              // G
    "0208 4248 0545",                    // H
    "1232 1838 2228",                    // I
    "4843321203",                        // J
    "0208 480542",                       // K
    "080242",                            // L
    "0208254842",                        // M
    "02084248",                          // N
    "123243473818070312",                // O
    "02083847463505",                    // P
    "123243473818070312 2442",           // Q
    "02083847463505 2542",               // R
    "473818070615354443321203",          // S
    "0848 2822",                         // T
    "080312324348",                      // U
    "082248",                            // V
    "0812263248",                        // W
    "0248 0842",                         // X
    "082548 2522",                       // Y
    "08480242",                          // Z
    "39292131",                          // [
    "0941",                              // backslash
    "19292111",                          // ]
    "062846",                            // ^
    "0141",                              // _
    "1827",                              // `
    "4536160503123243 4642",             // a
    "0802 0516364543321203",             // b
    "4536160503123243",                  // c
    "4842 4536160503123243",             // d
    "04444536160503123243",              // e
    "48382722 0646",                     // f
    "4536160503123243 4641301001",       // g
    "0802 0516364542",                   // h
    "162622 1232 2828",                  // i
    "2636312010 3838",                   // j
    "0802 460442",                       // k
    "182822 1232",                       // l
    "0206 05162522 25364542",            // m
    "0206 0516364542",                   // n
    "123243453616050312",                // o
    "0600 0516364543321203",             // p
    "4640 4536160503123243",             // q
    "0206 04263645",                     // r
    "4616051434433202",                  // s
    "28233242 0646",                     // t
    "0603123243 4642",                   // u
    "062246",                            // v
    "0612253246",                        // w
    "0246 0642",                         // x
    "0622 4610",                         // y
    "06460242",                          // z
    "39282615242231",                    // {
    "2921",                              // |
    "19282635242211",                    // }
    "04153445",                          // ~
};

std::string_view glyph(char character) {
  return glyphs[character < ' ' || character > '~' ? '?' - ' ' : character - ' '];
}

}  // namespace

std::vector<std::vector<Point2>> strokes(char character) {
  std::vector<std::vector<Point2>> lines;
  const std::string_view code = glyph(character);
  bool pen_up = true;
  for (std::size_t i = 0; i < code.size();) {
    if (code[i] == ' ') {
      pen_up = true;
      ++i;
      continue;
    }
    if (pen_up) {
      lines.emplace_back();
    }
    pen_up = false;
    lines.back().emplace_back(code[i] - '0', code[i + 1] - '0');
    i += 2;
  }
  return lines;
}

double unitFor(int height_px) {
  return std::max(1.0, std::round(height_px / 160.0) / 2);
}

double textWidth_px(std::string_view text, double unit_px) {
  return text.empty() ? 0 : (static_cast<double>(text.size() - 1) * advance_units + 4) * unit_px;
}

void drawText(Image& image, const Point2& base_px, std::string_view text, double unit_px, Colour colour) {
  const double width_px = std::max(1.0, 0.9 * unit_px);
  for (std::size_t i = 0; i < text.size(); ++i) {
    // Whole pixels keep upright strokes equally sharp in every column.
    const double left_px = std::floor(base_px.x() + static_cast<double>(i) * advance_units * unit_px) + 0.5;
    for (const std::vector<Point2>& line : strokes(text[i])) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const auto place = [&](const Point2& point) {
          return Point2(left_px + point.x() * unit_px,
                        std::floor(base_px.y()) + 0.5 - (point.y() - 2) * unit_px);
        };
        drawStroke(image, place(line[k]), place(line[k + 1]), width_px, colour);
      }
    }
  }
}

}  // namespace fissure::font
