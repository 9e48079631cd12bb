#include "motion/device_log.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "motion/axis_lines.h"
#include "scenario/catalog.h"
#include "text/delimited_text.h"
#include "text/scalars.h"

namespace fissure {
namespace {

void requireTimeBase(const ReplayMotion& settings, const std::string& where) {
  if (settings.time_column.has_value() == settings.rate_hz.has_value())
    throw InputError(
        where + (settings.rate_hz ? ": both time_column and rate_hz" : ": neither time_column nor rate_hz") +
        ", expected one of them");
  if (settings.frame_column && settings.time_column)
    throw InputError(where + ": both time_column and frame_column, expected rate_hz with frame_column");
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
    auto named = std::make_unique<DelimitedText>(file, files);
    named_ = named.get();
    table_ = std::move(named);
    if (settings.time_column) findTime(*settings.time_column);
    if (settings.frame_column) time_column_ = table_->column(*settings.frame_column);
    if (settings.where) filter_column_ = table_->column(settings.where->column);
    for (std::size_t i = 0; i < 3; ++i) position_columns_[i] = table_->column(settings.position_columns[i]);
    if (!settings.quaternion_columns) return;
    for (std::size_t i = 0; i < 4; ++i)
      quaternion_columns_[i] = table_->column((*settings.quaternion_columns)[i]);
  }

  DeviceLog read() {
    for (; table_->next(); ++row_) takeRow();
    const auto refuse = [&](const std::string& what) {
      throw InputError(inFile(table_->fileName()),
                       "none of its " + std::to_string(row_) + " rows has " + what);
    };
    if (row_ == 0)
      throw InputError(inFile(table_->fileName(), 1), "only a header line, expected rows below it");
    if (log_.filtered_rows.size() == row_)
      refuse(inQuotes(settings_.where->equals) + " in column " + inQuotes(settings_.where->column) +
             " (the first has " + inQuotes(first_filtered_) + "), expected some");
    if (log_.rows.empty())
      refuse("a pose" + (log_.beyond_reason.empty() ? ", expected a number in each named column"
                                                    : ": " + log_.first_beyond_reason));
    return std::move(log_);
  }

 private:
  void findTime(const std::string& column) {
    time_column_ = table_->column(column);
    const std::optional<TimeUnit> unit = settings_.timeUnit();
    if (!unit)
      throw InputError(inFile(table_->fileName(), named_->headerLine()),
                       "column " + inQuotes(column) +
                           " does not say clearly whether its unit is s, ms, us or ns, expected time_unit "
                           "beside time_column");
    unit_ = *unit;
  }

  void takeRow() {
    if (isLeftOut()) return log_.filtered_rows.push_back(row_);
    const double time_s = readTime_s();
    const Vec3 position_m = readPosition_m();
    const Quat orientation = readOrientation();
    const bool has_pose = position_m.allFinite() && orientation.coeffs().allFinite();
    if (!has_pose || !std::isfinite(time_s)) {
      log_.dropped_rows.push_back(row_);
    } else if (!log_.times_s.empty() && time_s <= log_.times_s.back()) {
      log_.repeated_rows.push_back(row_);
    } else {
      if (log_.rows.empty() && hasStamps()) zero_stamp_ = latest_stamp_;
      log_.rows.push_back(row_);
      log_.lines.push_back(table_->line());
      log_.times_s.push_back(log_.times_s.empty() && hasStamps() ? 0 : time_s);
      log_.positions_m.push_back(position_m);
      if (settings_.quaternion_columns) log_.orientations.push_back(orientation);
    }
  }

  bool isLeftOut() {
    if (!settings_.where || named_->text(filter_column_) == settings_.where->equals) return false;
    if (log_.filtered_rows.empty()) first_filtered_ = logExcerpt(named_->text(filter_column_));
    return true;
  }

  bool hasStamps() const { return settings_.time_column || settings_.frame_column; }

  /// Relative to the first row kept, once there is one.
  double readTime_s() {
    if (!hasStamps()) return static_cast<double>(row_) / *settings_.rate_hz;
    const double stamp =
        reasonable(table_->number(time_column_), kReasonableStamp,
                   settings_.frame_column ? *settings_.frame_column : *settings_.time_column);
    if (!std::isfinite(stamp)) return stamp;
    if (settings_.frame_column && stamp != std::floor(stamp))
      throw fault("frame " + formatReal(stamp) + " in column " + inQuotes(*settings_.frame_column) +
                  ", expected whole numbers");
    if (stamp < latest_stamp_) throw fault(goesBack(stamp));
    latest_stamp_ = stamp;
    const double since = stamp - zero_stamp_;
    return settings_.frame_column ? since / *settings_.rate_hz : since * seconds(unit_);
  }

  std::string goesBack(double stamp) const {
    const std::string from_to = " goes back from " + formatReal(latest_stamp_) + " to " + formatReal(stamp);
    if (settings_.frame_column)
      return "frame" + from_to + " in column " + inQuotes(*settings_.frame_column) +
             ", expected rows in order of frames";
    return "time" + from_to + " " + nameIn(catalog().time_units, unit_) + " in column " +
           inQuotes(*settings_.time_column) + ", expected rows in order of time";
  }

  InputError fault(const std::string& text) const {
    return InputError(inFile(table_->fileName(), table_->line()), text);
  }

  /// `value`, or NaN and a row beyond reason where it is larger than `most`. `column`: the name of its
  /// column.
  double reasonable(double value, double most, const std::string& column) {
    if (!(std::abs(value) > most)) return value;
    if (log_.beyond_reason.empty())
      log_.first_beyond_reason = fault(formatReal(value) + " in column " + inQuotes(column) +
                                       " is no measurement (beyond " + formatReal(most) + ")")
                                     .what();
    if (log_.beyond_reason.empty() || log_.beyond_reason.back() != row_) log_.beyond_reason.push_back(row_);
    return std::numeric_limits<double>::quiet_NaN();
  }

  Vec3 readPosition_m() {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      position[i] =
          reasonable(table_->number(position_columns_[at]), kReasonable, settings_.position_columns[at]);
    }
    return to_m_ * position;
  }

  /// Unit; NaN where the row has none.
  Quat readOrientation() {
    if (!settings_.quaternion_columns) return Quat::Identity();
    Eigen::Vector4d xyzw;
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      xyzw[i] = reasonable(table_->number(quaternion_columns_[at]), kReasonableStamp,
                           (*settings_.quaternion_columns)[at]);
    }
    const double largest = xyzw.cwiseAbs().maxCoeff();
    if (!xyzw.allFinite() || largest == 0)
      return Quat(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()));
    // By a power of two, which rounds nothing: no square is too small for a number then.
    const int exponent = std::ilogb(largest);
    for (double& part : xyzw) part = std::ldexp(part, -exponent);
    return Quat(Eigen::Vector4d(xyzw / xyzw.norm()));
  }

  const ReplayMotion& settings_;
  std::unique_ptr<LogTable> table_;
  const DelimitedText* named_ = nullptr;  ///< the table, where its columns have names
  double to_m_;
  TimeUnit unit_ = TimeUnit::s;
  std::size_t time_column_ = 0;  ///< of time stamps or frames
  std::size_t filter_column_ = 0;
  std::array<std::size_t, 3> position_columns_ = {};
  std::array<std::size_t, 4> quaternion_columns_ = {};
  std::size_t row_ = 0;
  double zero_stamp_ = 0;
  double latest_stamp_ = -std::numeric_limits<double>::infinity();
  std::string first_filtered_;
  DeviceLog log_;
};

}  // namespace

DeviceLog readDeviceLog(const ReplayMotion& settings, const std::filesystem::path& file,
                        const std::string& where, const LogFiles& files) {
  requireTimeBase(settings, where);
  return LogReader(settings, file, files).read();
}

}  // namespace fissure
