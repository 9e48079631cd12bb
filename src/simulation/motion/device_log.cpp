#include "motion/device_log.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "motion/axis_lines.h"
#include "text/delimited_text.h"
#include "text/scalars.h"

namespace fissure {
namespace {

/// A quaternion shorter than this is no rotation: trackers write zeros when they see nothing.
constexpr double shortest_quaternion = 1e-6;

void requireTimeBase(const ReplayMotion& settings, const std::string& where) {
  if (settings.time_column.has_value() == settings.rate_hz.has_value())
    throw InputError(
        where + (settings.rate_hz ? ": both time_column and rate_hz" : ": neither time_column nor rate_hz") +
        ", expected one of them");
  if (settings.rate_hz && !(*settings.rate_hz > 0 && std::isfinite(*settings.rate_hz)))
    throw InputError(where + ".rate_hz: expected a value above 0");
}

/// Takes a log row by row.
class LogReader {
 public:
  LogReader(const ReplayMotion& settings, const std::filesystem::path& file, const LogFiles& files)
      : settings_(settings), to_m_(metres(settings.position_unit)) {
    if (settings.layout == LogLayout::axes) {
      table_ = std::make_unique<AxisLines>(file, files);
      position_columns_ = {0, 1, 2};
      return;
    }
    table_ = std::make_unique<DelimitedText>(file, files);
    if (settings.time_column) time_column_ = table_->column(*settings.time_column);
    for (std::size_t i = 0; i < 3; ++i) position_columns_[i] = table_->column(settings.position_columns[i]);
    if (!settings.quaternion_columns) return;
    for (std::size_t i = 0; i < 4; ++i)
      quaternion_columns_[i] = table_->column((*settings.quaternion_columns)[i]);
  }

  DeviceLog read() {
    for (; table_->next(); ++row_) takeRow();
    if (row_ == 0)
      throw InputError(inFile(table_->fileName(), 1), "only a header line, expected rows below it");
    if (log_.rows.empty())
      throw InputError(
          inFile(table_->fileName()),
          "none of its " + std::to_string(row_) + " rows has a pose, expected a number in each named column");
    return std::move(log_);
  }

 private:
  void takeRow() {
    const double time_s = readTime_s();
    const Vec3 position_m = readPosition_m();
    const Quat orientation = readOrientation();
    const bool has_pose = position_m.allFinite() && orientation.coeffs().allFinite();
    if (!has_pose || !std::isfinite(time_s)) {
      log_.dropped_rows.push_back(row_);
    } else if (!log_.times_s.empty() && time_s <= log_.times_s.back()) {
      log_.repeated_rows.push_back(row_);
    } else {
      log_.rows.push_back(row_);
      log_.times_s.push_back(time_s);
      log_.positions_m.push_back(position_m);
      if (settings_.quaternion_columns) log_.orientations.push_back(orientation);
    }
    if (log_.rows.size() == 1 && log_.rows.back() == row_ && settings_.time_column) setTimeZero();
  }

  /// Relative to the first row kept, once there is one.
  double readTime_s() {
    if (!settings_.time_column) return static_cast<double>(row_) / *settings_.rate_hz;
    const double stamp_s = table_->number(time_column_);
    if (!std::isfinite(stamp_s)) return stamp_s;
    if (stamp_s < latest_stamp_s_)
      throw InputError(inFile(table_->fileName(), table_->line()),
                       "time goes back from " + formatReal(latest_stamp_s_) + " to " + formatReal(stamp_s) +
                           " s in column \"" + *settings_.time_column + "\", expected rows in order of time");
    latest_stamp_s_ = stamp_s;
    return stamp_s - zero_stamp_s_;
  }

  void setTimeZero() {
    zero_stamp_s_ = log_.times_s.back();
    log_.times_s.back() = 0;
  }

  Vec3 readPosition_m() const {
    return to_m_ * Vec3(table_->number(position_columns_[0]), table_->number(position_columns_[1]),
                        table_->number(position_columns_[2]));
  }

  /// Unit; NaN where the row has none.
  Quat readOrientation() const {
    if (!settings_.quaternion_columns) return Quat::Identity();
    const auto& columns = quaternion_columns_;
    const Eigen::Vector4d xyzw(table_->number(columns[0]), table_->number(columns[1]),
                               table_->number(columns[2]), table_->number(columns[3]));
    if (xyzw.norm() > shortest_quaternion) return Quat(Eigen::Vector4d(xyzw / xyzw.norm()));
    return Quat(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }

  const ReplayMotion& settings_;
  std::unique_ptr<LogTable> table_;
  double to_m_;
  std::size_t time_column_ = 0;
  std::array<std::size_t, 3> position_columns_ = {};
  std::array<std::size_t, 4> quaternion_columns_ = {};
  std::size_t row_ = 0;
  double zero_stamp_s_ = 0;
  double latest_stamp_s_ = -std::numeric_limits<double>::infinity();
  DeviceLog log_;
};

}  // namespace

DeviceLog readDeviceLog(const ReplayMotion& settings, const std::filesystem::path& file,
                        const std::string& where, const LogFiles& files) {
  requireTimeBase(settings, where);
  return LogReader(settings, file, files).read();
}

}  // namespace fissure
