// Benchmark: the data plane's pass against memory bandwidth, OpenCV step by
// step, numpy and threads (targets 1, 2 and 3).
//
//   tensor_bench [--quick]
//   tensor_bench --repeat FOLDER COUNT     (the C++ side of a numpy pair)
//
// One mission on two grids: B with its frontness (central differences), a prior
// that is a raster, a soft zone and a hard one. Compulsory traffic is counted
// as B 4 + prior 4 + soft 4 + hard 1 + U 4 = 17 bytes per cell; the soft zone
// is stored in one byte, so 14 bytes are transferred. KG_TENSOR_BENCH_NUMPY is
// the command of the numpy side (scripts/bench_tensor_numpy.py); without it
// that comparison is skipped.

#include <pthread.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <string>
#include <thread>
#include <vector>

#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/testing/bench_report.h"
#include "kg_compiler/data_plane/testing/tensor_bench_peers.h"
#include "kg_compiler/data_plane/testing/tensor_bench_world.h"

namespace kg_compiler {
namespace {

using kg_base::Median;
using kg_base::PairedRatio;
using kg_base::PairedRatioBy;
using kg_base::Report;
using kg_base::Seconds;

constexpr double kBytesPerCell = 17.0;

template <typename A, typename B>
double PairedCpuRatio(int rounds, const A& a, const B& b) {
  return PairedRatioBy([](const auto& work) { return CpuSeconds(work); },
                       rounds, a, b);
}

double MaxDifference(const cv::Mat& a, const kg_base::Raster& b) {
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

// Time [s] of `repeats` passes divided among threads, each pinned to a core and
// with a fixed range of rows.
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

// Update after adding one zone of 40 x 40 cells in one window.
void MeasureUpdate(World* world, int rounds) {
  const kg_base::LonLat a = world->grid.Centre({100, 100});
  const kg_base::LonLat b = world->grid.Centre({139, 139});
  kg_mission::Mission with = world->mission;
  with.constraints.push_back(
      AreaConstraint("ex:new", kg_mission::ConstraintKind::kSoft,
                     Box(a.lon_deg, a.lat_deg, b.lon_deg, b.lat_deg)));
  with.constraints.back().attenuation = 0.5;
  TensorInputs in = world->Inputs();
  in.mission = &with;
  in.agent = &with.agents[0];
  // Each round updates from the tensor without the zone.
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

// Alternates whole processes, numpy's and ours.
void MeasureNumpy(World* world, Size size, const char* self, bool is_quick) {
  const char* numpy = std::getenv("KG_TENSOR_BENCH_NUMPY");
  if (!numpy) {
    std::printf("         numpy is not compared: no KG_TENSOR_BENCH_NUMPY\n");
    return;
  }
  const kg_base::TemporaryFolder folder;
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
  // Enough repetitions that process start-up is negligible (1.5e8 cells).
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
  // Target 1: share of the memory bandwidth, required for large grids only.
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
  // Target 2: OpenCV and numpy.
  OpenCvSteps steps(world);
  const double ratio = PairedCpuRatio(
      rounds, [&] { world.Materialised(); }, [&] { steps.Run(); });
  Report({2, "OpenCV steps / pass and U, " + size.Name(), 5.0, true, "x"},
         ratio);
  Report({2, "largest difference from OpenCV's U, " + size.Name(), 1e-6, false,
          ""},
         MaxDifference(steps.Run(), world.fused));
  MeasureNumpy(&world, size, self, is_quick);
  // Target 3: threads.
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

// Reads the same input as the numpy side and computes U `count` times.
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
