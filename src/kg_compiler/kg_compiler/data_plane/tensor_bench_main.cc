// Benchmark: the data plane's pass against the memory's bandwidth, OpenCV step
// by step, numpy and threads (targets 1, 2 and 3).
//
//   tensor_bench [--quick]
//   tensor_bench --repeat FOLDER COUNT     (the C++ side of a numpy pair)
//
// One mission on two grids: B with its frontness (central differences), a prior
// that is a raster, a soft zone and a hard one. Compulsory traffic is counted
// as B 4 + prior 4 + soft 4 + hard 1 + U 4 = 17 bytes a cell; the soft zone is
// held in one byte, so that 14 move. KG_TENSOR_BENCH_NUMPY is the command of
// numpy's side (scripts/bench_tensor_numpy.py); without it that is not
// compared.

#include <pthread.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "kg_compiler/bench_report.h"
#include "kg_compiler/data_plane/compiled_tensor.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_compiler/test_world.h"
#include "kg_core/base/temporary_folder.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr double kBytesPerCell = 17.0;

struct Size {
  int rows;
  int cols;
  std::string Name() const {
    return std::to_string(cols) + "x" + std::to_string(rows);
  }
};

// The border is forbidden: there OpenCV and the pass differ by design.
struct World {
  explicit World(Size size)
      : grid(EvenGrid(-98.0, 18.1, 21.6 / size.cols, size.rows, size.cols)) {
    std::mt19937 rng(1);
    kg_core::Raster value(grid.size()), prior(grid.size());
    kg_core::Mask hard(grid.size(), 0), soft(grid.size(), 0);
    for (int r = 0; r < size.rows; ++r) {
      for (int c = 0; c < size.cols; ++c) {
        const std::size_t i = grid.Index({r, c});
        value[i] =
            static_cast<float>(2.0 + std::sin(c * 0.02) + std::cos(r * 0.03) +
                               0.1 * (rng() % 1000) / 1000.0);
        prior[i] = static_cast<float>(0.3 * std::sin(c * 0.01 - r * 0.02));
        hard[i] = r == 0 || c == 0 || r + 1 == size.rows ||
                  c + 1 == size.cols || (r / 40 + c / 60) % 9 == 0;
        soft[i] = (r / 30 + c / 50) % 3 == 0;
      }
    }
    rasters = TestRasters(grid, value, kg_core::Mask(grid.size(), 0));
    rasters.prior_rasters["ex:p"] =
        std::make_shared<kg_core::Raster>(std::move(prior));
    rasters.constraint_masks["ex:hard"] =
        std::make_shared<kg_core::Mask>(std::move(hard));
    rasters.constraint_masks["ex:soft"] =
        std::make_shared<kg_core::Mask>(std::move(soft));
    mission.windows = {TestWindow(0, 0.8)};
    mission.agents = {TestAgent("alpha")};
    kg_core::Policy& policy = mission.agents[0].policy;
    policy.gamma_front = 0.5;
    policy.beta = {{"ex:p", 0.7}};
    policy.front_operator = kg_core::FrontOperator::kCentral;
    mission.priors.push_back({"ex:p",
                              "p",
                              std::nullopt,
                              0.0,
                              {},
                              {},
                              kg_core::RasterRef{"ex:file", "p", 0}});
    for (const char* iri : {"ex:hard", "ex:soft"}) {
      kg_core::Constraint zone;
      zone.iri = iri;
      zone.mask = kg_core::RasterRef{"ex:file", iri, 0};
      zone.kind = mission.constraints.empty() ? kg_core::ConstraintKind::kNoGo
                                              : kg_core::ConstraintKind::kSoft;
      zone.attenuation = 0.4;
      mission.constraints.push_back(zone);
    }
    tensor = CompileTensor(Inputs(), nullptr);
    field = *dynamic_cast<const CompiledTensor&>(*tensor.content).field();
    field.masked = Bands<float>(size.rows, size.cols);
    fused.resize(grid.size());
  }

  TensorInputs Inputs() const {
    return {
        &mission, &mission.agents[0], &mission.windows[0], &rasters, nullptr,
        nullptr};
  }

  void Lazy(int row, int row_end) {
    ComputeRows(rasters, row, row_end, &field);
  }
  void Lazy() { Lazy(0, grid.rows()); }
  // The pass, and U as a raster.
  void Materialised() {
    Lazy();
    RowScale n = FitScale(field, mission.agents[0].policy, 1.0f, nullptr);
    n.after = 0.8f;
    const bool is_large = grid.size() > 4'000'000;
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); c += kTileCols) {
        const int count = std::min(kTileCols, grid.cols() - c);
        float* to = &fused[grid.Index({r, c})];
        float u[kTileCols];
        NormaliseOpen(field.masked.Row(r) + c, field.state.Row(r) + c, n, count,
                      is_large ? u : to);
        if (is_large) Stream(u, count, to);
      }
    }
    StreamEnd();
  }

  kg_core::Grid grid;
  kg_core::Mission mission;
  WindowRasters rasters;
  MissionTensor tensor;
  BlendedField field;
  kg_core::Raster fused;
};

// Of this thread alone, so that other programs' turns do not count.
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

template <typename A, typename B>
double PairedCpuRatio(int rounds, const A& a, const B& b) {
  std::vector<double> ratios;
  for (int i = 0; i < rounds; ++i) {
    const double a_s = CpuSeconds(a);
    ratios.push_back(CpuSeconds(b) / a_s);
  }
  return Median(std::move(ratios));
}

// a = b + s c, the better of ordinary stores and those past the caches.
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

// What a user of OpenCV writes, one call after the other.
class OpenCvSteps {
 public:
  explicit OpenCvSteps(const World& world) : w_(world) {
    const kg_core::Grid& grid = w_.grid;
    value_ = Of(w_.rasters.value);
    prior_ = Of(*w_.rasters.prior_rasters.at("ex:p"));
    const kg_core::Mask& soft = *w_.rasters.constraint_masks.at("ex:soft");
    const kg_core::Mask& hard = *w_.rasters.constraint_masks.at("ex:hard");
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
            static_cast<float>(1e3 * kg_core::LocalScale(lat_deg).lon_deg /
                               (grid.lon_deg()[c + 1] - grid.lon_deg()[c - 1]));
      }
    }
    north_ = cv::Mat(grid.rows(), grid.cols(), CV_32F, cv::Scalar(0));
    for (int r = 1; r + 1 < grid.rows(); ++r) {
      double km = 0.0;
      for (const int s : {r - 1, r}) {
        const double a = grid.lat_deg()[s], b = grid.lat_deg()[s + 1];
        km += (b - a) / kg_core::LocalScale(0.5 * (a + b)).lat_deg / 1e3;
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
  cv::Mat Of(const kg_core::Raster& raster) const {
    return cv::Mat(w_.grid.rows(), w_.grid.cols(), CV_32F,
                   const_cast<float*>(raster.data()));
  }
  const World& w_;
  cv::Mat value_, prior_, soft_, open_, closed_, east_, north_;
  cv::Mat gx_, gy_, front_, v_, u_;
};

double MaxDifference(const cv::Mat& a, const kg_core::Raster& b) {
  double most = 0.0;
  const float* values = a.ptr<float>();
  for (std::size_t i = 0; i < b.size(); ++i) {
    most = std::max(most, std::abs(static_cast<double>(values[i]) - b[i]));
  }
  return most;
}

void PinTo(unsigned core) {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(core, &cores);
  pthread_setaffinity_np(pthread_self(), sizeof(cores), &cores);
}

// Seconds of `repeats` passes shared by threads that keep to their rows and
// their core.
double ThreadedSeconds(World* world, int threads, int repeats) {
  return Seconds([&] {
    std::vector<std::thread> workers;
    const int bands = world->field.tiling.bands();
    for (int t = 0; t < threads; ++t) {
      workers.emplace_back([=] {
        PinTo(static_cast<unsigned>(t));
        const int row = bands * t / threads * kBandRows;
        const int end =
            std::min(bands * (t + 1) / threads * kBandRows, world->grid.rows());
        for (int i = 0; i < repeats; ++i) world->Lazy(row, end);
      });
    }
    for (std::thread& worker : workers) worker.join();
  });
}

template <typename Work>
double Share(Triad* triad, const World& world, int rounds, const Work& work) {
  std::vector<double> shares;
  const double cells = static_cast<double>(world.grid.size());
  for (int i = 0; i < rounds; ++i) {
    const double limit = 12.0 * cells / triad->Best_s();
    shares.push_back(100.0 * kBytesPerCell * cells / CpuSeconds(work) / limit);
  }
  return Median(shares);
}

// Of one 40 x 40 cell zone that comes and goes in one window.
void MeasureUpdate(World* world, int rounds) {
  const kg_core::LonLat a = world->grid.Centre({100, 100});
  const kg_core::LonLat b = world->grid.Centre({139, 139});
  kg_core::Mission with = world->mission;
  with.constraints.push_back(
      AreaConstraint("ex:new", kg_core::ConstraintKind::kSoft,
                     Box(a.lon_deg, a.lat_deg, b.lon_deg, b.lat_deg)));
  with.constraints.back().attenuation = 0.5;
  TensorInputs in = world->Inputs();
  in.mission = &with;
  in.agent = &with.agents[0];
  std::vector<double> seconds;
  std::size_t cells = 0;
  for (int i = 0; i < rounds; ++i) {
    seconds.push_back(Seconds(
        [&] { cells = CompileTensor(in, &world->tensor).cells_computed; }));
  }
  std::printf(
      "         a soft zone of 40 x 40 cells in one window: %.4f ms, %zu cells "
      "made again of %zu\n",
      1e3 * Median(seconds), cells, world->grid.size());
}

void WriteFile(const std::string& path, const void* data, std::size_t bytes) {
  std::ofstream(path, std::ios::binary)
      .write(static_cast<const char*>(data),
             static_cast<std::streamsize>(bytes));
}

// Whole processes, numpy's and ours, in turn.
void MeasureNumpy(World* world, Size size, const char* self, bool is_quick) {
  const char* numpy = std::getenv("KG_TENSOR_BENCH_NUMPY");
  if (!numpy) {
    std::printf("         numpy is not compared: no KG_TENSOR_BENCH_NUMPY\n");
    return;
  }
  const kg_core::TemporaryFolder folder;
  const std::string path = folder / "";
  const std::size_t floats = world->grid.size() * sizeof(float);
  WriteFile(path + "/value", world->rasters.value.data(), floats);
  WriteFile(path + "/prior", world->rasters.prior_rasters["ex:p"]->data(),
            floats);
  WriteFile(path + "/soft", world->rasters.constraint_masks["ex:soft"]->data(),
            world->grid.size());
  WriteFile(path + "/hard", world->rasters.constraint_masks["ex:hard"]->data(),
            world->grid.size());
  WriteFile(path + "/fused", world->fused.data(), floats);
  const int count =
      std::max(2, static_cast<int>((is_quick ? 2e6 : 1.5e8) /
                                   static_cast<double>(world->grid.size())));
  const std::string arguments = " '" + path + "' " + std::to_string(size.rows) +
                                " " + std::to_string(size.cols) + " " +
                                std::to_string(count);
  const std::string ours = "'" + std::string(self) + "' --repeat" + arguments;
  int failed = 0;
  const double ratio = PairedRatio(
      is_quick ? 1 : 5, [&] { failed |= std::system(ours.c_str()); },
      [&] { failed |= std::system((numpy + arguments).c_str()); });
  if (failed) {
    std::printf("         numpy is not compared: its program failed\n");
    return;
  }
  Report({2, "numpy / pass, whole processes, " + size.Name(), 10.0, true, "x"},
         ratio);
}

void Measure(Size size, bool is_quick, const char* self) {
  World world(size);
  const int rounds = is_quick ? 3 : size.rows > 1000 ? 15 : 301;
  Triad triad(world.grid.size());
  const bool is_large = size.rows > 1000 || is_quick;
  world.Materialised();
  const double lazy = Share(&triad, world, rounds, [&] { world.Lazy(); });
  const double whole =
      Share(&triad, world, rounds, [&] { world.Materialised(); });
  if (is_large) {
    Report({1, "pass, share of triad bandwidth, " + size.Name(), 80, true, "%"},
           lazy);
    Report({1, "pass and U, share of triad, " + size.Name(), 62, true, "%"},
           whole);
  } else {
    std::printf("         pass %.1f %%, with U %.1f %% of triad, %s\n", lazy,
                whole, size.Name().c_str());
  }
  std::printf("         pass %.0f Mcell/s, %s\n",
              1e-6 * static_cast<double>(world.grid.size()) /
                  CpuSeconds([&] { world.Lazy(); }),
              size.Name().c_str());
  OpenCvSteps steps(world);
  const double ratio = PairedCpuRatio(
      rounds, [&] { world.Materialised(); }, [&] { steps.Run(); });
  Report({2, "OpenCV steps / pass and U, " + size.Name(), 5.0, true, "x"},
         ratio);
  Report({2, "largest difference from OpenCV's U, " + size.Name(), 1e-6, false,
          ""},
         MaxDifference(steps.Run(), world.fused));
  MeasureNumpy(&world, size, self, is_quick);
  const int repeats = is_quick ? 2 : size.rows > 1000 ? 10 : 500;
  const double speedup = PairedRatio(
      is_quick ? 1 : 9, [&] { ThreadedSeconds(&world, 2, repeats); },
      [&] { ThreadedSeconds(&world, 1, repeats); });
  Report({3, "2 threads on cores of their own, " + size.Name(), 1.8, true, "x"},
         speedup);
  if (size.rows >= 200) MeasureUpdate(&world, rounds);
}

template <typename T>
std::vector<T> ReadFile(const std::string& path, std::size_t size) {
  std::vector<T> values(size);
  std::ifstream(path, std::ios::binary)
      .read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(size * sizeof(T)));
  return values;
}

// Reads what numpy's side reads, and makes U as often.
int Repeat(const std::string& path, Size size, int count) {
  World world(size);
  const std::size_t cells = world.grid.size();
  world.rasters.value = ReadFile<float>(path + "/value", cells);
  const std::vector<float> wanted = ReadFile<float>(path + "/fused", cells);
  for (int i = 0; i < count; ++i) world.Materialised();
  return world.fused == wanted ? 0 : 1;
}

int Main(int argc, char** argv) {
  cv::setNumThreads(1);
  if (argc == 6 && std::strcmp(argv[1], "--repeat") == 0) {
    return Repeat(argv[2], {std::atoi(argv[3]), std::atoi(argv[4])},
                  std::atoi(argv[5]));
  }
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
#if defined(__OPTIMIZE__) && defined(NDEBUG)
  const bool is_release = true;
#else
  const bool is_release = false;
#endif
  Report({3, "built optimised and without assertions", 1, true, ""},
         is_release ? 1.0 : 0.0);
  if (is_quick) {
    Measure({60, 90}, true, argv[0]);
    return 0;
  }
  Measure({385, 541}, false, argv[0]);
  Measure({3298, 4500}, false, argv[0]);
  return 0;
}

}  // namespace
}  // namespace kg_compiler

int main(int argc, char** argv) { return kg_compiler::Main(argc, argv); }
