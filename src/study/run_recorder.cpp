#include "study/run_recorder.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scenario/did_you_mean.h"

namespace fissure {

namespace {

constexpr double slack = 1e-9;  // of a step: times that rounding made a little too long or short

}  // namespace

std::vector<CurveQuantity> curveQuantities(const std::vector<std::string>& names, const RecordLayout& layout,
                                           const std::string& where) {
  std::vector<CurveQuantity> known;
  for (const Series& series : layout.series()) {
    if (series.name == "time" || series.name.starts_with("timing/")) continue;
    if (series.axes.empty()) known.push_back({series.name, series.units, series.long_name, false});
    if (series.name == "force" || series.name == "force_elastic" || series.name == "force_viscous")
      known.push_back({series.name, series.units,
                       series.name == "force" ? "magnitude of the force on the tools" : series.long_name,
                       true});
  }
  if (layout.find("tool_position") && layout.find("contact_count"))
    known.push_back({"indentation", "m", "way of the first tool since it first touched tissue", false});
  std::vector<std::string> choices;
  for (const CurveQuantity& quantity : known) choices.push_back(quantity.name);
  std::vector<CurveQuantity> found;
  for (const std::string& name : names) {
    const auto is = [&](const CurveQuantity& quantity) { return quantity.name == name; };
    const auto at = std::find_if(known.begin(), known.end(), is);
    if (at == known.end())
      throw InputError(std::string(where)
                           .append(": no quantity \"")
                           .append(name)
                           .append("\" with one value a step")
                           .append(didYouMean(name, choices)));
    if (std::any_of(found.begin(), found.end(), is))
      throw InputError(
          std::string(where).append(": \"").append(name).append("\" twice, expected each quantity once"));
    found.push_back(*at);
  }
  return found;
}

std::vector<double> curveTimes_s(const SweepCurves& curves) {
  std::vector<double> times_s;
  const double last = std::floor(*curves.until_s / curves.every_s + slack);
  for (double i = 0; i <= last; ++i) times_s.push_back(i * curves.every_s);
  return times_s;
}

RunRecorder::RunRecorder(const RecordLayout& layout, Settings settings)
    : layout_(layout), settings_(std::move(settings)) {
  if (const Series* force = layout.find("force")) laws_ = layout.axis(force->axes.front()).labels.size();
  if (settings_.laws) rows_ = settings_.laws->rows();
  for (const CurveQuantity& quantity : settings_.curves) width_ += quantity.per_law ? laws_ : 1;
  numbers_.rows = rows_;
  numbers_.curves.assign(rows_ * width_ * settings_.times_s.size(), kMissing);
}

/// The way of the first tool's origin since the first row with a contact.
double RunRecorder::indentation(const RecordRow& row) {
  const std::size_t column = layout_.find("tool_position")->first_column;
  const Vec3 now_m(row[column], row[column + 1], row[column + 2]);
  if (!touched_ && row[layout_.find("contact_count")->first_column] > 0) {
    touched_ = true;
    touched_at_m_ = now_m;
  }
  return touched_ ? (now_m - touched_at_m_).norm() : 0;
}

/// Of one step, row by row of laws: all curves one after the other.
std::vector<double> RunRecorder::valuesOf(const RecordRow& row) {
  std::vector<double> values(rows_ * width_);
  std::size_t at = 0;
  for (const CurveQuantity& quantity : settings_.curves) {
    if (!quantity.per_law) {
      const double value =
          quantity.name == "indentation" ? indentation(row) : row[layout_.find(quantity.name)->first_column];
      for (std::size_t r = 0; r < rows_; ++r) values[r * width_ + at] = value;
      ++at;
      continue;
    }
    const std::size_t column = layout_.find(quantity.name)->first_column;
    const bool magnitude = quantity.name == "force";
    const bool elastic = quantity.name == "force_elastic";
    for (std::size_t law = 0; law < laws_; ++law, ++at) {
      for (std::size_t r = 0; r < rows_; ++r) {
        double& value = values[r * width_ + at];
        if (settings_.laws) {
          const LawValue& of = settings_.laws->values()[r * laws_ + law];
          value = magnitude ? of.force_N : elastic ? of.elastic_N : of.viscous_N;
        } else if (magnitude) {
          const std::size_t x = column + 3 * law;
          value = Vec3(row[x], row[x + 1], row[x + 2]).norm();
        } else {
          value = row[column + law];
        }
      }
    }
  }
  return values;
}

void RunRecorder::keep(std::size_t time, const std::vector<double>& values) {
  const std::size_t times = settings_.times_s.size();
  for (std::size_t i = 0; i < values.size(); ++i) numbers_.curves[i * times + time] = values[i];
}

void RunRecorder::forceInputs(const State& state) {
  if (settings_.next) settings_.next->forceInputs(state);
  if (settings_.laws) settings_.laws->add(state);
}

void RunRecorder::append(const RecordRow& row) {
  if (settings_.next) settings_.next->append(row);
  if (width_ == 0 || next_time_ == settings_.times_s.size()) return;
  const double now_s = row[layout_.find("time")->first_column];
  std::vector<double> now = valuesOf(row);
  const double step_s = now_s - before_s_;
  const double tolerance_s = slack * step_s;
  for (; next_time_ < settings_.times_s.size(); ++next_time_) {
    const double time_s = settings_.times_s[next_time_];
    if (time_s > now_s + tolerance_s) break;
    if (before_.empty() || time_s >= now_s - tolerance_s) {
      keep(next_time_, now);
      continue;
    }
    const double share = (time_s - before_s_) / step_s;
    std::vector<double> between(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) between[i] = (1 - share) * before_[i] + share * now[i];
    keep(next_time_, between);
  }
  before_ = std::move(now);
  before_s_ = now_s;
}

void RunRecorder::snapshot(const State& state) {
  if (settings_.next) settings_.next->snapshot(state);
}

void RunRecorder::frame(double time_s, const Image& image) {
  if (settings_.next) settings_.next->frame(time_s, image);
}

void RunRecorder::finish(const RunStatus& status, const Summary& summary) {
  if (settings_.next) settings_.next->finish(status, summary);
  record_.status = status;
  std::vector<double> of_run;
  for (const auto& [name, value, of_law] : summary) {
    if (name.starts_with("provenance/")) continue;
    if (const auto* text = std::get_if<std::string>(&value)) {
      numbers_.texts[name] = *text;
      continue;
    }
    const auto* count = std::get_if<long long>(&value);
    const double number = count ? static_cast<double>(*count) : std::get<double>(value);
    if (name.starts_with("timing/")) {
      record_.timing[name] = number;
    } else if (!settings_.laws || !of_law) {
      numbers_.names.push_back(name);
      of_run.push_back(number);
    }
  }
  for (std::size_t row = 0; row < rows_; ++row) {
    numbers_.values.insert(numbers_.values.end(), of_run.begin(), of_run.end());
    if (!settings_.laws) continue;
    Summary of_laws;
    settings_.laws->summarize(row, of_laws);
    for (const SummaryValue& value : of_laws) {
      if (row == 0) numbers_.names.push_back(value.name);
      numbers_.values.push_back(std::get<double>(value.value));
    }
  }
  record_.numbers = encodeNumbers(numbers_);
}

}  // namespace fissure
