// Baselines for tensor_bench: memory bandwidth, and Eq. 1 in OpenCV steps.

#ifndef KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_PEERS_H_
#define KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_PEERS_H_

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/data_plane/testing/tensor_bench_world.h"

namespace kg_compiler {

// CPU time of this thread [s], independent of other processes.
template <typename Work>
double CpuSeconds(const Work& work) {
  const auto now = [] {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * time.tv_nsec;
  };
  const double begin = now();
  work();
  return now() - begin;
}

// a = b + s c, with ordinary or non-temporal stores, whichever is faster.
class Triad {
 public:
  explicit Triad(std::size_t size) : a_(size), b_(size, 1.0f), c_(size, 2.0f) {}
  void Plain() {
    float* __restrict a = a_.data();
    const float* __restrict b = b_.data();
    const float* __restrict c = c_.data();
    for (std::size_t i = 0; i < a_.size(); ++i) a[i] = b[i] + 3.0f * c[i];
  }
  void PastCaches() {
#if defined(__SSE2__)
    const __m128 s = _mm_set1_ps(3.0f);
    for (std::size_t i = 0; i + 4 <= a_.size(); i += 4) {
      _mm_stream_ps(&a_[i], _mm_add_ps(_mm_loadu_ps(&b_[i]),
                                       _mm_mul_ps(s, _mm_loadu_ps(&c_[i]))));
    }
    _mm_sfence();
#endif
  }
  double Best_s() {
    return std::min(CpuSeconds([this] { Plain(); }),
                    CpuSeconds([this] { PastCaches(); }));
  }

 private:
  std::vector<float> a_, b_, c_;
};

// Straightforward sequence of OpenCV calls.
class OpenCvSteps {
 public:
  explicit OpenCvSteps(const World& world) : w_(world) {
    const kg_base::Grid& grid = w_.grid;
    value_ = Of(w_.rasters.value);
    prior_ = Of(*w_.rasters.prior_rasters.at("ex:p"));
    const kg_base::Mask& soft = *w_.rasters.constraint_masks.at("ex:soft");
    const kg_base::Mask& hard = *w_.rasters.constraint_masks.at("ex:hard");
    soft_ = cv::Mat(grid.rows(), grid.cols(), CV_32F);
    open_ = cv::Mat(grid.rows(), grid.cols(), CV_8U);
    east_ = cv::Mat(grid.rows(), grid.cols(), CV_32F);
    for (int r = 0; r < grid.rows(); ++r) {
      const double lat_deg = grid.lat_deg()[r];
      for (int c = 0; c < grid.cols(); ++c) {
        const std::size_t i = grid.Index({r, c});
        soft_.at<float>(r, c) = soft[i] ? 0.4f : 1.0f;
        open_.at<unsigned char>(r, c) = hard[i] ? 0 : 255;
        if (c == 0 || c + 1 == grid.cols()) continue;
        east_.at<float>(r, c) =
            static_cast<float>(1e3 * kg_base::LocalScale(lat_deg).lon_deg /
                               (grid.lon_deg()[c + 1] - grid.lon_deg()[c - 1]));
      }
    }
    north_ = cv::Mat(grid.rows(), grid.cols(), CV_32F, cv::Scalar(0));
    for (int r = 1; r + 1 < grid.rows(); ++r) {
      double km = 0.0;
      for (const int s : {r - 1, r}) {
        const double a = grid.lat_deg()[s], b = grid.lat_deg()[s + 1];
        km += (b - a) / kg_base::LocalScale(0.5 * (a + b)).lat_deg / 1e3;
      }
      north_.row(r) = static_cast<float>(1.0 / km);
    }
    closed_ = open_ == 0;
  }

  const cv::Mat& Run() {
    const cv::Mat step = (cv::Mat_<float>(1, 3) << -1.f, 0.f, 1.f);
    cv::filter2D(value_, gx_, CV_32F, step);
    cv::filter2D(value_, gy_, CV_32F, step.t());
    cv::multiply(gx_, east_, gx_);
    cv::multiply(gy_, north_, gy_);
    cv::magnitude(gx_, gy_, front_);
    double most_value = 0.0, most_front = 0.0, most = 0.0;
    cv::minMaxLoc(value_, nullptr, &most_value, nullptr, nullptr, open_);
    cv::minMaxLoc(front_, nullptr, &most_front, nullptr, nullptr, open_);
    cv::addWeighted(value_, 1.0 / most_value, front_, 0.5 / most_front, 0.0,
                    v_);
    cv::scaleAdd(prior_, 0.7, v_, v_);
    cv::max(v_, 0.0, v_);
    cv::multiply(v_, soft_, v_);
    cv::minMaxLoc(v_, nullptr, &most, nullptr, nullptr, open_);
    v_.convertTo(u_, CV_32F, 0.8 / most);
    u_.setTo(0.0, closed_);
    return u_;
  }

 private:
  cv::Mat Of(const kg_base::Raster& raster) const {
    return cv::Mat(w_.grid.rows(), w_.grid.cols(), CV_32F,
                   const_cast<float*>(raster.data()));
  }
  const World& w_;
  cv::Mat value_, prior_, soft_, open_, closed_, east_, north_;
  cv::Mat gx_, gy_, front_, v_, u_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_PEERS_H_
