// Independent implementation of Eq. 1 with OpenCV: whole matrices of doubles,
// step by step, on random worlds with even grids. The data plane is used only
// through CompileTensor(); areas, scales and buffers are computed here from
// their definitions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_mission::ConstraintKind;
using kg_mission::Mission;
using kg_mission::Policy;

// WGS84's radii of curvature as kilometres per degree.
constexpr double kEquator_km = 6378.137;
constexpr double kEccentricity2 = 6.69437999014e-3;
double Bend(double lat_deg) {
  const double s = std::sin(lat_deg * CV_PI / 180.0);
  return 1.0 - kEccentricity2 * s * s;
}
double EastKm(double lat_deg) {
  const double rad = CV_PI / 180.0;
  return kEquator_km / std::sqrt(Bend(lat_deg)) * std::cos(lat_deg * rad) * rad;
}
double NorthKm(double lat_deg) {
  return kEquator_km * (1.0 - kEccentricity2) / std::pow(Bend(lat_deg), 1.5) *
         CV_PI / 180.0;
}

using Polygon = std::vector<cv::Point2d>;  // Longitude, latitude.

Polygon RandomPolygon(std::mt19937& rng, const kg_base::Grid& grid) {
  const cv::Point2d middle(Uniform(rng, grid.west_deg(), grid.east_deg()),
                           Uniform(rng, grid.south_deg(), grid.north_deg()));
  Polygon polygon;
  for (int i = 0; i < 7; ++i) {
    const double turn = (i + Uniform(rng, 0.0, 0.9)) * 2.0 * CV_PI / 7.0;
    const double reach_deg = Uniform(rng, 0.1, 0.5);
    polygon.push_back(middle +
                      reach_deg * cv::Point2d(std::cos(turn), std::sin(turn)));
  }
  return polygon;
}

kg_base::Geometry GeometryOf(const Polygon& polygon) {
  std::ostringstream wkt;
  wkt.precision(17);
  wkt << "POLYGON((";
  for (const cv::Point2d& at : polygon) wkt << at.x << " " << at.y << ",";
  wkt << polygon[0].x << " " << polygon[0].y << "))";
  return kg_base::Geometry::FromWkt(wkt.str());
}

bool IsInside(const Polygon& polygon, const kg_base::LonLat& at) {
  bool is_odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const cv::Point2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y > at.lat_deg) == (b.y > at.lat_deg)) continue;
    const double x = a.x + (at.lat_deg - a.y) / (b.y - a.y) * (b.x - a.x);
    is_odd ^= at.lon_deg < x;
  }
  return is_odd;
}

// A mission with all terms of Eq. 1, and its facts as matrices.
struct World {
  kg_base::Grid grid;
  Mission mission;
  WindowRasters rasters;
  std::vector<Polygon> areas;  // Areas of priors without a raster, in order.
  std::vector<std::pair<cv::Mat, double>> soft;  // (inside, factor).
  cv::Mat open;

  const Policy& policy() const { return mission.agents[0].policy; }
  cv::Mat New(double x = 0.0) const {
    return cv::Mat(grid.rows(), grid.cols(), CV_64F, cv::Scalar(x));
  }
  cv::Mat Make(const std::function<double(int, int)>& at) const {
    cv::Mat m = New();
    for (int r = 0; r < m.rows; ++r) {
      for (int c = 0; c < m.cols; ++c) m.at<double>(r, c) = at(r, c);
    }
    return m;
  }
  cv::Mat Bytes(const kg_base::Mask& mask) const {
    return cv::Mat(grid.rows(), grid.cols(), CV_8U,
                   const_cast<unsigned char*>(mask.data())) != 0;
  }
  cv::Mat Bytes(const Polygon& polygon) const {
    return Make([&](int r, int c) {
             return IsInside(polygon, grid.Centre({r, c})) ? 1.0 : 0.0;
           }) > 0.5;
  }
};

kg_base::Raster RandomValues(std::mt19937& rng, const kg_base::Grid& grid,
                             double gaps) {
  kg_base::Raster value = RandomRaster(rng, grid.size(), -0.5, 3.0);
  for (float& x : value) {
    if (Uniform(rng, 0, 1) < gaps) x = kGap;
  }
  return value;
}

void AddMaskZone(const std::string& iri, const kg_mission::Constraint& zone,
                 kg_base::Mask mask, World* w) {
  w->mission.constraints.push_back(zone);
  w->mission.constraints.back().iri = iri;
  w->mission.constraints.back().mask = kg_mission::RasterRef{"ex:file", iri, 0};
  w->rasters.constraint_masks[iri] =
      std::make_shared<const kg_base::Mask>(std::move(mask));
}

// The mask dilated by the zone's buffer: Euclidean radius of 1.5 cells, or a
// square.
cv::Mat Grown(const cv::Mat& mask, const kg_mission::Constraint& zone) {
  if (zone.buffer_cells == 0.0) return mask;
  const int reach = static_cast<int>(zone.buffer_cells);
  cv::Mat disc(2 * reach + 1, 2 * reach + 1, CV_8U, cv::Scalar(1));
  if (zone.buffer_metric == kg_mission::BufferMetric::kEuclidean) {
    for (int r = -reach; r <= reach; ++r) {
      for (int c = -reach; c <= reach; ++c) {
        disc.at<unsigned char>(r + reach, c + reach) =
            std::sqrt(r * r + c * c) <= zone.buffer_cells;
      }
    }
  }
  cv::Mat grown;
  cv::dilate(mask, grown, disc, {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
  return grown;
}

void AddHardZones(std::mt19937& rng, World* w) {
  w->open = w->Bytes(w->rasters.land) == 0;
  for (int i = 0; i < 2; ++i) {
    kg_mission::Constraint zone;
    zone.kind = ConstraintKind::kNoGo;
    zone.buffer_cells = i == 0 ? 0.0 : 2.5;
    const kg_base::Mask mask = RandomMask(rng, w->grid.size(), 0.01);
    w->open.setTo(0, Grown(w->Bytes(mask), zone));
    AddMaskZone("ex:hard" + std::to_string(i), zone, mask, w);
  }
}

// Two masks and an area, so that zones overlap.
void AddSoftZones(std::mt19937& rng, World* w) {
  const auto factor = [&] { return Uniform(rng, 0.1, 0.9); };
  for (int i = 0; i < 2; ++i) {
    kg_mission::Constraint zone;
    zone.kind = ConstraintKind::kSoft;
    zone.attenuation = factor();
    zone.buffer_cells = i;
    zone.buffer_metric = kg_mission::BufferMetric::kChebyshev;
    const kg_base::Mask mask = RandomMask(rng, w->grid.size(), 0.2);
    w->soft.push_back({Grown(w->Bytes(mask), zone), zone.attenuation});
    AddMaskZone("ex:soft" + std::to_string(i), zone, mask, w);
  }
  const Polygon polygon = RandomPolygon(rng, w->grid);
  kg_mission::Constraint zone =
      AreaConstraint("ex:soft2", ConstraintKind::kSoft, GeometryOf(polygon));
  zone.attenuation = factor();
  w->soft.push_back({w->Bytes(polygon), zone.attenuation});
  w->mission.constraints.push_back(std::move(zone));
}

void AddPriors(std::mt19937& rng, World* w) {
  Policy& policy = w->mission.agents[0].policy;
  for (const char* iri : {"ex:p0", "ex:p1"}) {
    w->areas.push_back(RandomPolygon(rng, w->grid));
    w->mission.priors.push_back(
        {iri, "", GeometryOf(w->areas.back()), 0.0, {}, {}});
    policy.beta[iri] = Uniform(rng, -1, 1);
  }
  w->mission.priors[1].edge_m = 7000.0;
  w->mission.priors.push_back({"ex:p2", "", {}, 0.0, {}, {}});
  w->mission.priors[2].raster = kg_mission::RasterRef{"ex:file", "p2", 0};
  w->rasters.prior_rasters["ex:p2"] =
      std::make_shared<const kg_base::Raster>(RandomValues(rng, w->grid, 0.05));
  policy.beta["ex:p2"] = Uniform(rng, -1, 1);
}

void AddEvents(std::mt19937& rng, World* w) {
  for (int i = 0; i < 3; ++i) {
    w->mission.events.push_back(
        {"ex:e" + std::to_string(i),
         {Uniform(rng, w->grid.west_deg(), w->grid.east_deg()),
          Uniform(rng, w->grid.south_deg(), w->grid.north_deg())},
         Uniform(rng, 0.5, 2.0),
         1,
         Uniform(rng, 3e3, 2e4),
         {0}});
  }
}

// Cycles through every option; sizes leave partial vectors and tiles.
World RandomWorld(std::mt19937& rng, int round) {
  World w;
  w.grid = EvenGrid(-92.0, 24.0, 0.04, 17 + round % 5, 30 + 53 * (round % 6));
  w.mission.windows = {TestWindow(0, Uniform(rng, 0.3, 0.9))};
  w.mission.agents = {TestAgent("alpha")};
  Policy& policy = w.mission.agents[0].policy;
  policy.alpha_base = Uniform(rng, 0.2, 2.0);
  policy.gamma_front = round % 7 == 6 ? 0.0 : Uniform(rng, 0.2, 2.0);
  policy.beta_poi = Uniform(rng, -1.0, 1.0);
  policy.front_operator = static_cast<kg_mission::FrontOperator>(round % 2);
  policy.normalisation = static_cast<kg_mission::Normalisation>(round / 2 % 3);
  policy.soft_overlap = static_cast<kg_mission::SoftOverlap>(round / 3 % 2);
  policy.confidence_mode =
      static_cast<kg_mission::ConfidenceMode>(round / 5 % 2);
  policy.layer_scale = static_cast<kg_mission::LayerScale>(round / 4 % 3);
  policy.paper_literal = round % 11 == 10;
  const double gaps = round % 3 == 0 ? 0.0 : 0.06;
  w.rasters = TestRasters(w.grid, RandomValues(rng, w.grid, gaps),
                          RandomMask(rng, w.grid.size(), 0.03));
  w.rasters.full_scale = 2.5;
  w.rasters.front_full_scale = 0.4;
  AddHardZones(rng, &w);
  AddSoftZones(rng, &w);
  AddPriors(rng, &w);
  AddEvents(rng, &w);
  return w;
}

cv::Mat Filtered(const cv::Mat& m, const cv::Mat& kernel) {
  cv::Mat filtered;
  cv::filter2D(m, filtered, CV_64F, kernel, {-1, -1}, 0, cv::BORDER_CONSTANT);
  return filtered;
}

// Values with gaps set to 0, and a mask that is 1 where there is data.
struct Known {
  cv::Mat values, is_there;
};

Known KnownOf(const World& w, const kg_base::Raster& raster) {
  Known known;
  cv::Mat(w.grid.rows(), w.grid.cols(), CV_32F,
          const_cast<float*>(raster.data()))
      .convertTo(known.values, CV_64F);
  const cv::Mat there = known.values == known.values;
  known.values.setTo(0.0, ~there);
  there.convertTo(known.is_there, CV_64F, 1.0 / 255.0);
  return known;
}

// Distances [km] from a cell to the previous and the next one.
struct Steps {
  cv::Mat before, after;
};

// Mean slope [B/km] along one axis, for Sobel over three parallel lines with
// weights 1, 2, 1; only differences with data count.
cv::Mat Slope(const Known& b, const Steps& km, bool is_east, bool is_sobel) {
  const auto along = [&](double low, double own, double high) {
    const cv::Mat kernel = (cv::Mat_<double>(1, 3) << low, own, high);
    return is_east ? kernel : cv::Mat(kernel.t());
  };
  const cv::Mat has_low = Filtered(b.is_there, along(1, 0, 0)) > 0.5;
  const cv::Mat has_high = Filtered(b.is_there, along(0, 0, 1)) > 0.5;
  const cv::Mat has_own = b.is_there > 0.5;
  cv::Mat slope(b.values.size(), CV_64F, cv::Scalar(0.0));
  cv::Mat(Filtered(b.values, along(-1, 1, 0)) / km.before)
      .copyTo(slope, has_low & has_own & ~has_high);
  cv::Mat(Filtered(b.values, along(0, -1, 1)) / km.after)
      .copyTo(slope, has_high & has_own & ~has_low);
  cv::Mat(Filtered(b.values, along(-1, 0, 1)) / (km.before + km.after))
      .copyTo(slope, has_low & has_high);
  const cv::Mat has_slope =
      (has_low & has_high) | (has_own & (has_low | has_high));
  cv::Mat weight;
  has_slope.convertTo(weight, CV_64F, 1.0 / 255.0);
  const double side = is_sobel ? 1.0 : 0.0;
  cv::Mat across = (cv::Mat_<double>(3, 1) << side, 2.0, side);
  if (!is_east) across = across.t();
  const cv::Mat sum = Filtered(slope, across);
  return sum / cv::max(Filtered(weight, across), 1.0);
}

cv::Mat Front(const World& w, const Known& b) {
  const bool is_sobel =
      w.policy().front_operator == kg_mission::FrontOperator::kSobel;
  const std::vector<double>& lat = w.grid.lat_deg();
  const double step = w.grid.lon_deg()[1] - w.grid.lon_deg()[0];
  const auto north = [&](int r) { return NorthKm(lat[r] + 0.5 * step) * step; };
  const cv::Mat east =
      w.Make([&](int r, int) { return EastKm(lat[r]) * step; });
  const Steps rows = {
      w.Make([&](int r, int) { return north(std::max(r - 1, 0)); }),
      w.Make([&](int r, int) { return north(r); })};
  cv::Mat front;
  cv::magnitude(Slope(b, {east, east}, true, is_sobel),
                Slope(b, rows, false, is_sobel), front);
  return front.mul(b.is_there);
}

double MaxOpen(const cv::Mat& m, const cv::Mat& mask) {
  double most = 0.0;
  cv::minMaxLoc(m, nullptr, &most, nullptr, nullptr, mask);
  return most;
}

cv::Mat Layer01(const World& w, const cv::Mat& layer, double stated) {
  if (w.policy().paper_literal) return layer;
  const cv::Mat positive = cv::max(layer, 0.0);
  switch (w.policy().layer_scale) {
    case kg_mission::LayerScale::kWindow:
      return positive / MaxOpen(positive, w.open);
    case kg_mission::LayerScale::kFixed:
      return positive / stated;
    default:
      return positive;
  }
}

// exp(-d^2 / (2 edge^2)) with d from the nearest cell inside; eastward lengths
// use the scale of that cell's row.
cv::Mat SoftEdge(const World& w, const cv::Mat& inside, double edge_km) {
  const std::vector<double>& lat = w.grid.lat_deg();
  const std::vector<double>& lon = w.grid.lon_deg();
  std::vector<cv::Point> cells;
  cv::findNonZero(inside, cells);
  return w.Make([&](int r, int c) {
    double least = 1e30;
    for (const cv::Point& at : cells) {
      const double dx = (lon[c] - lon[at.x]) * EastKm(lat[at.y]);
      const double dy =
          (lat[r] - lat[at.y]) * NorthKm(0.5 * (lat[r] + lat[at.y]));
      least = std::min(least, dx * dx + dy * dy);
    }
    return std::exp(-0.5 * least / (edge_km * edge_km));
  });
}

cv::Mat Prior(const World& w, const kg_mission::PriorLayer& prior,
              const Polygon* polygon) {
  if (prior.raster) {
    return KnownOf(w, *w.rasters.prior_rasters.at(prior.iri)).values;
  }
  const cv::Mat inside = w.Bytes(*polygon);
  if (prior.edge_m > 0.0) return SoftEdge(w, inside, prior.edge_m / 1000.0);
  cv::Mat p;
  inside.convertTo(p, CV_64F, 1.0 / 255.0);
  return p;
}

cv::Mat Bump(const World& w, const kg_mission::Event& event) {
  cv::Mat bump = w.Make([&](int r, int c) {
    const kg_base::LonLat at = w.grid.Centre({r, c});
    const double middle = 0.5 * (at.lat_deg + event.position.lat_deg);
    const double x = (at.lon_deg - event.position.lon_deg) * EastKm(middle);
    const double y = (at.lat_deg - event.position.lat_deg) * NorthKm(middle);
    return -0.5 * (x * x + y * y) / std::pow(event.radius_m / 1000.0, 2);
  });
  cv::exp(bump, bump);
  return bump;
}

cv::Mat Blended(const World& w) {
  const Known b = KnownOf(w, w.rasters.value);
  const Policy& policy = w.policy();
  cv::Mat v;
  cv::addWeighted(Layer01(w, b.values, *w.rasters.full_scale),
                  policy.alpha_base,
                  Layer01(w, Front(w, b), *w.rasters.front_full_scale),
                  policy.gamma_front, 0.0, v);
  for (std::size_t i = 0; i < w.mission.priors.size(); ++i) {
    const kg_mission::PriorLayer& prior = w.mission.priors[i];
    const Polygon* polygon = i < w.areas.size() ? &w.areas[i] : nullptr;
    cv::scaleAdd(Prior(w, prior, polygon), policy.beta.at(prior.iri), v, v);
  }
  for (const kg_mission::Event& event : w.mission.events) {
    cv::scaleAdd(Bump(w, event), policy.beta_poi * event.value, v, v);
  }
  return v;
}

cv::Mat Softness(const World& w) {
  cv::Mat softness = w.New(1.0);
  for (const auto& [inside, factor] : w.soft) {
    cv::Mat own = w.New(1.0);
    own.setTo(factor, inside);
    softness = w.policy().soft_overlap == kg_mission::SoftOverlap::kProduct
                   ? cv::Mat(softness.mul(own))
                   : cv::Mat(cv::min(softness, own));
  }
  return softness;
}

double NearestRank(const cv::Mat& y, const cv::Mat& mask) {
  cv::Mat1d held;
  for (int r = 0; r < y.rows; ++r) {
    for (int c = 0; c < y.cols; ++c) {
      if (mask.at<unsigned char>(r, c)) held.push_back(y.at<double>(r, c));
    }
  }
  cv::sort(held, held, cv::SORT_EVERY_COLUMN | cv::SORT_ASCENDING);
  return held(static_cast<int>(std::ceil(0.98 * held.rows)) - 1);
}

cv::Mat Normalised(const cv::Mat& y, const cv::Mat& mask,
                   kg_mission::Normalisation kind) {
  double low = 0.0, top = 0.0;
  cv::minMaxLoc(y, &low, &top, nullptr, nullptr, mask);
  if (kind != kg_mission::Normalisation::kMinMax) low = 0.0;
  if (kind == kg_mission::Normalisation::kPercentile) {
    top = NearestRank(y, mask);
  }
  const cv::Mat x = (y - low) / (top - low);
  return cv::min(cv::max(x, 0.0), 1.0);
}

cv::Mat Fused(const World& w) {
  const Policy& policy = w.policy();
  const double confidence = w.mission.windows[0].confidence;
  cv::Mat v = Blended(w), u;
  if (policy.paper_literal) {
    const cv::Mat water = w.Bytes(w.rasters.land) == 0;
    v = v.mul(Softness(w)) * confidence;
    v.setTo(0.0, ~w.open);
    u = Normalised(v, water, kg_mission::Normalisation::kMinMax);
    u.setTo(0.0, ~water);
    return u;
  }
  v = cv::max(v, 0.0).mul(Softness(w));
  const bool is_pre =
      policy.confidence_mode == kg_mission::ConfidenceMode::kPre;
  if (is_pre) v *= confidence;
  u = Normalised(v, w.open, policy.normalisation);
  if (!is_pre) u *= confidence;
  u.setTo(0.0, ~w.open);
  return u;
}

TEST(Eq1OpenCv, TensorsAreWhatOpenCvMakesStepByStep) {
  std::mt19937 rng(20260611);
  for (int round = 0; round < 120; ++round) {
    const World w = RandomWorld(rng, round);
    const MissionTensor tensor = CompileTensor(w.mission, w.mission.agents[0],
                                               w.mission.windows[0], w.rasters);
    const kg_base::Raster got = tensor.Get(Layer::kFused);
    const cv::Mat wanted = Fused(w);
    ASSERT_GT(MaxOpen(wanted, cv::Mat()), 0.2) << round;
    for (std::size_t i = 0; i < got.size(); ++i) {
      ASSERT_NEAR(wanted.ptr<double>()[i], got[i], 1e-6)
          << "round " << round << ", cell " << i;
    }
  }
}

}  // namespace
}  // namespace kg_compiler
