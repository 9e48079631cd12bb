#include "report/frames.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/base64.h"
#include "report/webp.h"

namespace fissure {

namespace {

constexpr std::size_t most_frames = 96;  ///< of all runs: what is encoded within a second

/// The frames of one run that are shown.
struct Chosen {
  std::size_t run = 0;
  const StoredQuantity* pictures = nullptr;
  std::vector<std::size_t> rows;
  std::vector<double> times_s;  ///< of all stored frames
};

struct Encoding {
  int width_px;
  double quality;
};

/// From the best to the smallest.
constexpr std::array<Encoding, 7> encodings = {
    {{800, 75}, {640, 75}, {640, 55}, {480, 55}, {480, 40}, {360, 40}, {240, 30}}};

std::vector<Chosen> withFrames(const std::vector<ReportRun>& runs) {
  std::vector<Chosen> all;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const StoredQuantity* pictures = runs[r].reader.find("frames");
    const StoredQuantity* times = runs[r].reader.find("frame_time");
    if (pictures && times && pictures->rows > 0 && pictures->rows == times->rows)
      all.push_back({r, pictures, {}, runs[r].reader.all(*times)});
  }
  return all;
}

std::string dataUri(const ReportRun& run, const Chosen& chosen, std::size_t row, const Encoding& encoding) {
  const Image image = run.reader.picture(*chosen.pictures, row);
  return "data:image/webp;base64," + base64(encodeWebp(image, encoding.width_px, encoding.quality));
}

/// From two frames of each run, a late and a middle one, which show more than the first.
double guessBytes(const std::vector<ReportRun>& runs, const std::vector<Chosen>& all,
                  const Encoding& encoding) {
  double sum = 0;
  for (const Chosen& chosen : all) {
    double sample = 0;
    const std::array<std::size_t, 2> rows = {chosen.rows[chosen.rows.size() / 2], chosen.rows.back()};
    for (const std::size_t row : rows)
      sample += static_cast<double>(dataUri(runs[chosen.run], chosen, row, encoding).size());
    sum += sample / static_cast<double>(rows.size()) * static_cast<double>(chosen.rows.size());
  }
  return sum;
}

PageJson encodeAll(const std::vector<ReportRun>& runs, const std::vector<Chosen>& all,
                   const Encoding& encoding, std::size_t& bytes) {
  PageJson json = PageJson::array();
  bytes = 0;
  for (const Chosen& chosen : all) {
    PageJson times = PageJson::array(), images = PageJson::array();
    for (const std::size_t row : chosen.rows) {
      times.push_back(shortNumber(chosen.times_s[row]));
      images.push_back(dataUri(runs[chosen.run], chosen, row, encoding));
      bytes += images.back().get_ref<const std::string&>().size() + 3;
    }
    json.push_back({{"run", chosen.run}, {"times_s", times}, {"images", images}});
  }
  return json;
}

/// Whether pictures are narrower than they were stored.
bool isSmaller(const std::vector<Chosen>& all, const Encoding& encoding) {
  return std::any_of(all.begin(), all.end(), [&](const Chosen& chosen) {
    return chosen.pictures->axes.at(1).length > static_cast<std::size_t>(encoding.width_px);
  });
}

/// The best encoding that seems to fit, from `first` on; the smallest where none does.
std::size_t chooseEncoding(const std::vector<ReportRun>& runs, const std::vector<Chosen>& all,
                           std::size_t first, std::size_t most_bytes) {
  constexpr double margin = 1.05;  // a guess from few frames
  std::size_t chosen = first;
  while (chosen + 1 < encodings.size() &&
         margin * guessBytes(runs, all, encodings[chosen]) > static_cast<double>(most_bytes))
    ++chosen;
  return chosen;
}

}  // namespace

std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows(std::min(count, most));
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (count > most)
    for (std::size_t& row : rows) row = row * (count - 1) / (most - 1);
  return rows;
}

PageJson framesJson(const std::vector<ReportRun>& runs, std::size_t most_bytes) {
  std::vector<Chosen> all = withFrames(runs);
  if (all.empty()) return nullptr;
  std::size_t each = std::max<std::size_t>(2, most_frames / all.size());
  std::size_t encoding = 0, stored = 0;
  for (const Chosen& chosen : all) stored += chosen.pictures->rows;
  for (;; each = std::max<std::size_t>(2, each / 2)) {
    std::size_t shown = 0;
    for (Chosen& chosen : all) {
      chosen.rows = evenlySpread(chosen.pictures->rows, each);
      shown += chosen.rows.size();
    }
    for (encoding = chooseEncoding(runs, all, encoding, most_bytes); encoding < encodings.size();
         ++encoding) {
      std::size_t bytes = 0;
      PageJson encoded = encodeAll(runs, all, encodings[encoding], bytes);
      if (bytes <= most_bytes || (each == 2 && encoding + 1 == encodings.size()))
        return {{"stored", stored},
                {"shown", shown},
                {"smaller", isSmaller(all, encodings[encoding])},
                {"runs", std::move(encoded)}};
    }
    --encoding;
  }
}

}  // namespace fissure
