#include "kg_compiler/traversal/leg.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/traversal/sight.h"

namespace kg_compiler {
namespace {

constexpr double kMaxStep_s = 600.0;

// Metres per degree along a leg: parabola through its ends and its middle
// (error below 1e-6 for legs within two degrees of latitude).
class LegScale {
 public:
  LegScale(kg_base::LonLat from, kg_base::LonLat to)
      : a_(At(from.lat_deg)),
        m_(At(0.5 * (from.lat_deg + to.lat_deg))),
        b_(At(to.lat_deg)) {}

  // Metres east per degree of longitude, and north per degree of latitude.
  Eigen::Vector2d operator()(double s) const {
    const double wa = (1.0 - s) * (1.0 - 2.0 * s);
    const double wm = 4.0 * s * (1.0 - s);
    const double wb = s * (2.0 * s - 1.0);
    return wa * a_ + wm * m_ + wb * b_;
  }

 private:
  static Eigen::Vector2d At(double lat_deg) {
    const kg_base::DegreesPerMetre scale = kg_base::LocalScale(lat_deg);
    return {1.0 / scale.lon_deg, 1.0 / scale.lat_deg};
  }
  Eigen::Vector2d a_, m_, b_;  // Scale at the begin, the middle and the end.
};

// Progress along a leg, parameterised by s in [0, 1].
class LegProgress {
 public:
  LegProgress(const LegFlyer& flyer, const TrackLeg& leg, double speed_mps,
              double slack)
      : flyer_(flyer),
        from_(leg.from),
        lon_(leg.to.lon_deg - leg.from.lon_deg),
        lat_(leg.to.lat_deg - leg.from.lat_deg),
        scale_(leg.from, leg.to),
        speed_mps_(speed_mps),
        most_across_mps_((1.0 - slack) * speed_mps),
        least_mps_(slack * speed_mps) {}

  std::optional<kg_base::GridPoint> At(double s) const {
    return flyer_.grid().Locate(
        {from_.lon_deg + s * lon_, from_.lat_deg + s * lat_});
  }

  // ds/dt [1/s] at s and time_s; nullopt if the leg cannot be held there.
  std::optional<double> Rate(kg_base::GridPoint at, double s,
                             double time_s) const {
    const std::optional<kg_base::Velocity> c = flyer_.Current(at, time_s);
    if (!c) return std::nullopt;
    const Eigen::Vector2d leg_m =
        Eigen::Vector2d(lon_, lat_).cwiseProduct(scale_(s));
    const double length_m = leg_m.norm();
    const Eigen::Vector2d ahead = leg_m / length_m;
    const Eigen::Vector2d current(c->east_mps, c->north_mps);
    const double along = current.dot(ahead);
    const double across = current.x() * ahead.y() - current.y() * ahead.x();
    if (!(std::abs(across) <= most_across_mps_)) return std::nullopt;
    const double ground_mps =
        along + std::sqrt(speed_mps_ * speed_mps_ - across * across);
    if (!(ground_mps >= least_mps_)) return std::nullopt;
    return ground_mps / length_m;
  }

 private:
  const LegFlyer& flyer_;
  kg_base::LonLat from_;
  double lon_, lat_;  // Difference from end to end [deg].
  LegScale scale_;
  double speed_mps_, most_across_mps_, least_mps_;
};

// Is the step from a cell to itself or to one of its 8 neighbours allowed? A
// diagonal step needs both cells beside the corner to be open.
bool MayCross(const LegFlyer& flyer, kg_base::Cell a, kg_base::Cell b) {
  if (a == b) return true;
  if (!flyer.IsOpen(b)) return false;
  if (a.row == b.row || a.col == b.col) return true;
  return flyer.IsOpen({a.row, b.col}) && flyer.IsOpen({b.row, a.col});
}

}  // namespace

double LatestArrival_s(const MotionModel& motion,
                       const VoyageDeparture& departure) {
  return std::min(departure.deadline_s - departure.time_s,
                  departure.base_travel_m / motion.cruise_mps);
}

LegFlyer::LegFlyer(const VoyageRequest& voyage, const CellBox* box)
    : world_(voyage.world),
      motion_(voyage.motion),
      box_(box ? Common(*box, WholeGrid(grid())) : WholeGrid(grid())),
      epoch_s_(voyage.departure.time_s),
      latest_s_(LatestArrival_s(voyage.motion, voyage.departure)) {}

std::optional<kg_base::Velocity> LegFlyer::Current(kg_base::GridPoint at,
                                                   double time_s) const {
  std::optional<kg_base::Velocity> c =
      world_.field->Sample(at, epoch_s_ + time_s);
  if (!c) return c;
  c->east_mps *= motion_.boost_gain;
  c->north_mps *= motion_.boost_gain;
  return c;
}

bool LegFlyer::IsOpen(kg_base::Cell cell) const {
  return Holds(box_, cell) && (*world_.open)[grid().Index(cell)] == 1;
}

double LegFlyer::HazardAt(kg_base::Cell cell) const {
  return world_.hazard ? world_.hazard->At(cell) : 0.0;
}

kg_base::Cell LegFlyer::CellOf(kg_base::GridPoint at) const {
  return kg_compiler::CellOf(grid(), at);
}

// Midpoint method (second order): the rate at the middle of each step, at the
// time predicted from the rate at its begin.
std::optional<LegEnd> LegFlyer::Fly(const TrackLeg& leg,
                                    const LegCare& care) const {
  const LegProgress progress(*this, leg, motion_.cruise_mps, care.slack);
  std::optional<kg_base::GridPoint> at = progress.At(0.0);
  const std::optional<kg_base::GridPoint> to = progress.At(1.0);
  if (!at || !to || !IsOpen(CellOf(*at))) return std::nullopt;
  LegEnd end{leg.depart_s, 0.0};
  if (leg.from == leg.to) return end;
  const double cells = std::hypot(to->row - at->row, to->col - at->col);
  const double longest =
      1.0 / std::max(1.0, std::ceil(cells / care.step_cells));
  // The last step ends exactly at s = 1: a remainder below 1e-9 is merged into
  // it.
  double s = 0.0;
  while (s < 1.0) {
    const std::optional<double> begin = progress.Rate(*at, s, end.arrive_s);
    if (!begin) return std::nullopt;
    double h = std::min(longest, 1.0 - s);
    if (1.0 - s - h < 1e-9) h = 1.0 - s;
    h = std::min(h, kMaxStep_s * *begin);
    const auto middle = progress.At(s + 0.5 * h);
    const auto next = progress.At(h == 1.0 - s ? 1.0 : s + h);
    if (!middle || !next) return std::nullopt;
    const std::optional<double> rate =
        progress.Rate(*middle, s + 0.5 * h, end.arrive_s + 0.5 * h / *begin);
    // Steps are shorter than a cell, so the next cell is this one or adjacent.
    if (!rate || !MayCross(*this, CellOf(*at), CellOf(*next))) {
      return std::nullopt;
    }
    const double dt_s = h / *rate;
    end.arrive_s += dt_s;
    end.hazard_s += dt_s * HazardAt(CellOf(*middle));
    if (!(end.arrive_s <= latest_s_)) return std::nullopt;
    s = h == 1.0 - s ? 1.0 : s + h;
    at = next;
  }
  // The leg must also be held at its very end.
  if (!progress.Rate(*at, 1.0, end.arrive_s)) return std::nullopt;
  return end;
}

}  // namespace kg_compiler
