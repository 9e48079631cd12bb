#pragma once

#include <vector>

#include "base/record.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// Rows in a chunk of the series of a run of `expected_rows` (0: unknown): all in one up to 4096, else equal
/// chunks of 2049 to 4096 rows, so that the last one is hardly ever left mostly empty. Unknown: 1024.
std::size_t rowsInChunk(std::size_t expected_rows);

/// The series of a layout as datasets of one group (and of its subgroup `timing`), fed row by row through a
/// buffer of one chunk. A series over the laws has the law before the time, so that one law's curve lies in
/// one piece.
class SeriesWriter {
 public:
  /// Makes all datasets. Throws std::logic_error when the layout has no plain series `time` or uses a name
  /// twice.
  SeriesWriter(GroupBuilder& group, const RecordLayout& layout, std::size_t chunk_rows);

  /// Buffers a row; true when the chunk is full and must be written. Throws std::logic_error on a row of
  /// wrong length.
  bool append(const RecordRow& row);

  /// Writes the buffered rows of every series but `time`.
  void writeData();
  /// Then `time`: a row counts as written once its time is, so the caller flushes in between. Empties the
  /// buffer.
  void writeTime();

 private:
  struct Column {
    Series series;
    std::size_t leading = 1;  ///< length of the axes before time
    GrowingDataset dataset;
  };

  std::size_t rows() const { return buffer_.size() / columns_; }
  template <typename Value>
  std::vector<Value> gather(const Column& column) const;
  void write(Column& column) const;

  std::size_t columns_;
  std::size_t chunk_rows_;
  std::size_t rows_in_chunk_ = 0;  ///< of the current chunk, written or buffered
  std::vector<double> buffer_;     ///< row by row
  std::vector<Column> series_;
  std::vector<Column> time_;  ///< one entry: the commit mark
};

}  // namespace fissure
