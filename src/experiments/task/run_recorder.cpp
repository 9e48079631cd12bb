#include "task/run_recorder.h"

#include <algorithm>
#include <cmath>

#include "base/steps.h"

namespace fissure {

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

/// The values of all curves in one step: for each row of laws its curves one after the other.
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
          const LawValue of = settings_.laws->value(r * laws_ + law);
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
  if (settings_.laws) settings_.laws->evaluate();
  std::vector<double> now = valuesOf(row);
  const double step_s = now_s - before_s_;
  const double tolerance_s = step_slack * step_s;
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
      if (!settings_.laws || !of_law) numbers_.texts[name] = *text;
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
  if (settings_.laws) settings_.laws->evaluate();
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
