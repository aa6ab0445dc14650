// A raster in bands of rows, each shared by pointer: a copy copies pointers
// only, and a change copies only the bands it touches. Rows are aligned to 64
// bytes.

#ifndef KG_COMPILER_DATA_PLANE_BANDS_H_
#define KG_COMPILER_DATA_PLANE_BANDS_H_

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace kg_compiler {

inline constexpr int kBandRows = 16;
inline constexpr std::size_t kRowAlignment = 64;

template <typename T>
class RowBands {
 public:
  RowBands() = default;
  // Allocates all bands; values are uninitialised.
  RowBands(int rows, int cols) : rows_(rows), cols_(cols) {
    const std::size_t unit = kRowAlignment / sizeof(T);
    stride_ = (static_cast<std::size_t>(cols) + unit - 1) / unit * unit;
    for (int band = 0; band < bands(); ++band) data_.push_back(New());
  }

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  int bands() const { return (rows_ + kBandRows - 1) / kBandRows; }
  static int BandOf(int row) { return row / kBandRows; }

  const T* Row(int row) const {
    return data_[BandOf(row)].get() + (row % kBandRows) * stride_;
  }
  // Writable row; only after construction or Renew() of its band.
  T* RowToWrite(int row) {
    return data_[BandOf(row)].get() + (row % kBandRows) * stride_;
  }
  // Copies the bands of rows [row, row_end) to make them writable.
  void Renew(int row, int row_end) {
    if (row >= row_end) return;
    for (int band = BandOf(row); band <= BandOf(row_end - 1); ++band) {
      std::shared_ptr<T[]> copy = New();
      std::memcpy(copy.get(), data_[band].get(), BandBytes());
      data_[band] = std::move(copy);
    }
  }

 private:
  std::size_t BandBytes() const {
    return std::min(rows_, kBandRows) * stride_ * sizeof(T);
  }
  std::shared_ptr<T[]> New() const {
    const std::align_val_t alignment{kRowAlignment};
    return {static_cast<T*>(::operator new[](BandBytes(), alignment)),
            [alignment](T* data) { ::operator delete[](data, alignment); }};
  }

  int rows_ = 0;
  int cols_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::shared_ptr<T[]>> data_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_BANDS_H_
