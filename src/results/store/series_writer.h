#pragma once

#include <vector>

#include "base/record.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// Rows per chunk for the series of a run with `expected_rows`: a single chunk up to 4096 rows, else equal
/// chunks of 2049 to 4096 rows, so that the last one is hardly ever mostly empty; 1024 where the number is
/// unknown (0).
std::size_t rowsInChunk(std::size_t expected_rows);

/// Writes the series of a layout as datasets of one group (and of its subgroup `timing`), row by row through
/// a buffer of one chunk. In series with an axis of laws the law comes before time, so that the curve of each
/// law is contiguous.
class SeriesWriter {
 public:
  /// Creates all datasets. Throws std::logic_error when the layout has no plain series `time` or uses a name
  /// twice.
  SeriesWriter(GroupBuilder& group, const RecordLayout& layout, std::size_t chunk_rows);

  /// Buffers a row; returns true when the chunk is full and must be written. Throws std::logic_error for a
  /// row of wrong length.
  bool append(const RecordRow& row);

  /// Writes the buffered rows of all series except `time`.
  void writeData();
  /// Writes `time` and empties the buffer. A row is committed when its time is written, so the caller must
  /// flush the file between writeData() and writeTime().
  void writeTime();

 private:
  struct Column {
    Series series;
    std::size_t leading = 1;  ///< product of the lengths of the axes before time
    GrowingDataset dataset;
  };

  std::size_t rows() const { return buffer_.size() / columns_; }
  template <typename Value>
  std::vector<Value> gather(const Column& column) const;
  void write(Column& column) const;

  std::size_t columns_;
  std::size_t chunk_rows_;
  std::size_t rows_in_chunk_ = 0;  ///< rows of the current chunk, written or buffered
  std::vector<double> buffer_;     ///< row by row
  std::vector<Column> series_;
  std::vector<Column> time_;  ///< one entry, which marks committed rows
};

}  // namespace fissure
