#include "kg_compiler/traversal/fan.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/units.h"
#include "kg_compiler/traversal/leg.h"

namespace kg_compiler {
namespace {

constexpr int kFirstRays = 24;
constexpr int kDeepest = 7;  // Halvings between two neighbours in one step.
constexpr std::size_t kMaxRays = 20000;

// Lengths in cells.
constexpr double kFirstStep = 0.75;
constexpr double kMaxStep = 6.0;
constexpr double kStepsToOneCell = 40.0;  // Steps grow from here on.
constexpr double kWidest = 4.0;           // Largest gap between neighbours
constexpr double kWidestBent = 1.5;       // ... where the front bends by
constexpr double kBent = 0.3;             // this slope.
constexpr double kWidestNearClosed = 0.7;
constexpr double kWidestAtDead = 0.1;
constexpr double kLate = 0.7;    // Share of a step by which a ray may be late.
constexpr double kFillIn = 1.0;  // Gaps up to this are filled by interpolation.
constexpr std::size_t kMaxReplayed = 50;  // Steps; beyond: always interpolate.
constexpr double kWidestSharp = 0.4;      // ... where it bends by kSharp.
constexpr double kSharp = 0.3;
constexpr double kThinner = 1.0;   // A ray is dropped between two this close
constexpr double kThinBend = 0.2;  // whose front bends by less than this.

// Work of one fan, in steps of single rays. A front passes each cell once, with
// a few rays per cell and a few steps: with a hundred times the grid, rays are
// held in an eddy beside a coast by a current that far exceeds the agent, and
// would run there until the deadline.
std::size_t MaxWork(const kg_base::Grid& grid) {
  return 200000 + 100 * grid.size();
}
// Cost of a step besides its rays, counted in rays.
constexpr std::size_t kWorkPerStep = 100;

bool Finite(const ExtremalState& at) {
  return std::isfinite(at.col + at.row + at.p_lon + at.p_lat);
}

}  // namespace

ExtremalFan::ExtremalFan(const VoyageRequest& voyage)
    : voyage_(voyage),
      flow_(voyage),
      helm_(flow_, voyage.motion.cruise_mps),
      grid_(flow_.grid()),
      sight_(voyage.world, {0, grid_.rows(), 0, grid_.cols()}),
      arrivals_(grid_),
      latest_s_(LatestArrival_s(voyage.motion, voyage.departure)) {}

bool ExtremalFan::Begin() {
  const auto from = grid_.Locate(voyage_.departure.from);
  if (!from || !(latest_s_ > 0.0) || !(voyage_.motion.cruise_mps > 0.0)) {
    return false;
  }
  const kg_base::Cell cell = CellOf(grid_, *from);
  low_ = high_ = {from->col, from->row};
  if (!sight_.IsOpen(cell)) return false;
  reach_.roots.push_back({*from, 0.0, -1, 0.0});
  for (int i = 0; i <= kFirstRays; ++i) {
    const double heading_rad = 2.0 * kg_base::kPi * i / kFirstRays;
    rays_.push_back({SetOut(flow_, *from, heading_rad), heading_rad, 0, true});
    const kg_base::GridPoint v = helm_.Velocity(rays_.back().at, flow_.At(0.0));
    fastest_ = std::max(fastest_, CellOffset{v.col, v.row}.norm());
  }
  rays_.back().linked = false;
  return true;
}

double ExtremalFan::StepLength_s() const {
  const double far = static_cast<double>(steps_.size()) / kStepsToOneCell;
  const double cells = std::clamp(far * far, kFirstStep, kMaxStep);
  const double length_s = cells / fastest_;
  const double slice_s = flow_.NextSlice_s(now_s_) - now_s_;
  const double rest_s = latest_s_ - now_s_;
  // Steps end on the field's slices, where its time derivative jumps, unless
  // that would shorten the step to less than 0.3 of its length. A step that
  // ends within 0.1 % of the remaining time is extended to the end, so that no
  // step of rounding-error length remains.
  const double wanted_s =
      slice_s > 0.3 * length_s && slice_s < length_s ? slice_s : length_s;
  return wanted_s > 0.999 * rest_s ? rest_s : wanted_s;
}

ReachMap ExtremalFan::Run() {
  if (Begin()) {
    while (!rays_.empty() && now_s_ < latest_s_ && work_ < MaxWork(grid_)) {
      reach_.cells_per_s = std::max(reach_.cells_per_s, fastest_);
      const double length_s = StepLength_s();
      fastest_ = 1e-9;
      Advance(length_s);
    }
  }
  reach_.cells = arrivals_.Reached();
  reach_.read = ReadBox();
  return std::move(reach_);
}

void ExtremalFan::Advance(double length_s) {
  const double end_s =
      length_s >= latest_s_ - now_s_ ? latest_s_ : now_s_ + length_s;
  const ExtremalStepper::Step step(flow_, now_s_, end_s - now_s_);
  work_ += kWorkPerStep + rays_.size();
  margin_s_ = kLate * length_s;
  next_.clear();
  restarts_.clear();
  grazes_.clear();
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    if (i > 0 && rays_[i - 1].linked) continue;
    AdvanceChain({&step, now_s_, rays_[i].root}, rays_, i);
  }
  Restarts(end_s);
  now_s_ = end_s;
  steps_.push_back(step);
  Thin();
}

void ExtremalFan::AdvanceChain(const Stride& stride,
                               const std::vector<Ray>& rays,
                               std::size_t first) {
  ExtremalStrand last =
      Advance(stride, rays[first].at, rays[first].heading_rad);
  Keep(stride, last);
  FindCornersBeside(stride, last);
  for (std::size_t i = first; rays[i].linked; ++i) {
    const ExtremalStrand strand =
        Advance(stride, rays[i + 1].at, rays[i + 1].heading_rad);
    Between(stride, last, strand, 0);
    Keep(stride, strand);
    last = strand;
  }
  FindCornersBeside(stride, last);
}

ExtremalStrand ExtremalFan::Advance(const Stride& stride,
                                    const ExtremalState& from,
                                    double heading_rad) {
  ExtremalStrand strand{from, helm_.Advance(from, *stride.step), heading_rad,
                        false};
  if (!Finite(strand.end)) strand.end = from;
  // Clamp to one cell beyond the grid: the extrapolated field is meaningless
  // farther out.
  strand.end.col = std::clamp(strand.end.col, -1.0, grid_.cols() + 0.0);
  strand.end.row = std::clamp(strand.end.row, -1.0, grid_.rows() + 0.0);
  Touch(PlaceOf(from));
  Touch(PlaceOf(strand.end));
  if (stride.step->length_s > 0.0) {
    const double cells = (PlaceOf(strand.end) - PlaceOf(from)).norm();
    fastest_ = std::max(fastest_, cells / stride.step->length_s);
  }
  const kg_base::GridPoint end{strand.end.row, strand.end.col};
  strand.dead =
      !sight_.Contains(end) || !sight_.IsClear({from.row, from.col}, end);
  return strand;
}

// Keeps a live ray for the next step, not yet linked to its neighbour.
void ExtremalFan::Keep(const Stride& stride, const ExtremalStrand& strand) {
  if (strand.dead) return;
  next_.push_back({strand.end, strand.heading_rad, stride.root, false});
}

bool ExtremalFan::IsWide(const ExtremalStrand& a, const ExtremalStrand& b,
                         const FrontSweep& sweep) {
  if (next_.size() >= kMaxRays) return false;
  const double begin = (PlaceOf(b.begin) - PlaceOf(a.begin)).norm();
  const double end = (PlaceOf(b.end) - PlaceOf(a.end)).norm();
  if (a.dead != b.dead) return std::max(begin, end) > kWidestAtDead;
  const bool near_closed =
      sight_.NearClosed(CellOf(grid_, {a.begin.row, a.begin.col})) ||
      sight_.NearClosed(CellOf(grid_, {b.begin.row, b.begin.col}));
  if (a.dead) return std::max(begin, end) > kWidestBent;
  if (near_closed) return end > kWidestNearClosed;
  const double slope = sweep.Slope();
  return end > kWidest || (end > kWidestBent && slope > kBent) ||
         (end > kWidestSharp && slope > kSharp);
}

ExtremalState ExtremalFan::Replay(int root, double heading_rad) const {
  ExtremalState at = SetOut(flow_, reach_.roots[root].place, heading_rad);
  std::size_t next = 0;
  if (root > 0) {
    const FirstStep& first = first_steps_[root - 1];
    if (first.next > steps_.size()) return at;  // Begun in this step.
    at = helm_.Advance(at, first.step);
    next = first.next;
  }
  for (std::size_t i = next; i < steps_.size(); ++i) {
    at = helm_.Advance(at, steps_[i]);
  }
  return at;
}

// New ray between two neighbours: if they are far apart, the true extremal at
// the mean of their headings at the root; if close, the midpoint of the front.
std::optional<ExtremalState> ExtremalFan::Insert(
    const Stride& stride, const ExtremalStrand& a,
    const ExtremalStrand& b) const {
  const double gap = (PlaceOf(b.begin) - PlaceOf(a.begin)).norm();
  if (gap > kFillIn && steps_.size() <= kMaxReplayed) {
    const ExtremalState at =
        Replay(stride.root, 0.5 * (a.heading_rad + b.heading_rad));
    if ((PlaceOf(at) - PlaceOf(a.begin)).norm() < 1.5 * gap &&
        (PlaceOf(at) - PlaceOf(b.begin)).norm() < 1.5 * gap) {
      return at;
    }
  }
  return Halfway(flow_, a.begin, b.begin);
}

void ExtremalFan::Between(const Stride& stride, const ExtremalStrand& a,
                          const ExtremalStrand& b, int depth) {
  const FrontSweep sweep(flow_, a, b, stride.step->length_s);
  // Recursion: halve until the front between two neighbours is a cubic.
  if (depth < kDeepest && IsWide(a, b, sweep)) {
    const auto half = Insert(stride, a, b);
    if (half && sight_.IsOpen(CellOf(grid_, {half->row, half->col}))) {
      const ExtremalStrand middle =
          Advance(stride, *half, 0.5 * (a.heading_rad + b.heading_rad));
      Between(stride, a, middle, depth + 1);
      Keep(stride, middle);
      Between(stride, middle, b, depth + 1);
      return;
    }
  }
  Paint(stride, a, b, sweep);
  if (!a.dead && !b.dead && !next_.empty()) next_.back().linked = true;
  // Exactly one of the two was stopped: at a corner, or along an edge that the
  // other one grazes.
  if (a.dead == b.dead) return;
  FindCornersBeside(stride, a.dead ? b : a);
  FindGraze(stride, a.dead ? b : a, a.dead ? a : b);
}

void ExtremalFan::Touch(const CellOffset& at) {
  low_ = {std::min(low_.x(), at.x()), std::min(low_.y(), at.y())};
  high_ = {std::max(high_.x(), at.x()), std::max(high_.y(), at.y())};
}

void ExtremalFan::Paint(const Stride& stride, const ExtremalStrand& a,
                        const ExtremalStrand& b, const FrontSweep& sweep) {
  const CellOffset low = sweep.low(), high = sweep.high();
  const int row0 = std::max(static_cast<int>(std::ceil(low.y() - 0.5)), 0);
  const int col0 = std::max(static_cast<int>(std::ceil(low.x() - 0.5)), 0);
  const int row1 =
      std::min(static_cast<int>(std::floor(high.y() + 0.5)), grid_.rows() - 1);
  const int col1 =
      std::min(static_cast<int>(std::floor(high.x() + 0.5)), grid_.cols() - 1);
  if (row0 > row1 || col0 > col1) return;  // Beyond the outer edges.
  const bool near_closed =
      a.dead || b.dead || NearClosed({row0, col0}, {row1, col1});
  for (int row = row0; row <= row1; ++row) {
    for (int col = col0; col <= col1; ++col) {
      PaintCell(stride, a, b, sweep, {row, col}, near_closed);
      if (near_closed) FindCorners(stride, a, b, sweep, {row, col});
    }
  }
}

bool ExtremalFan::NearClosed(kg_base::Cell low, kg_base::Cell high) {
  for (int row = low.row;;
       row = std::min(row + LineOfSight::kBlock, high.row)) {
    for (int col = low.col;;
         col = std::min(col + LineOfSight::kBlock, high.col)) {
      if (sight_.NearClosed({row, col})) return true;
      if (col >= high.col) break;
    }
    if (row >= high.row) return false;
  }
}

void ExtremalFan::PaintCell(const Stride& stride, const ExtremalStrand& a,
                            const ExtremalStrand& b, const FrontSweep& sweep,
                            kg_base::Cell cell, bool near_closed) {
  const CellOffset place{static_cast<double>(cell.col),
                         static_cast<double>(cell.row)};
  const auto share = sweep.Find(place);
  if (!share) return;
  const double time_s = stride.begin_s + sweep.Time_s(*share);
  if (!(time_s <= latest_s_)) return;
  ArrivalTiles::Node& node = arrivals_.At(cell);
  if (!(time_s < node.arrival_s) || !sight_.IsOpen(cell)) return;
  if (near_closed) {
    // The straight line from the front at the step's begin must be clear.
    const CellOffset from = sweep.BeginAt(share->across);
    if (!sight_.IsClear({from.y(), from.x()}, {place.y(), place.x()})) return;
  }
  node.arrival_s = time_s;
  node.root = stride.root;
  node.heading_rad = static_cast<float>(
      a.heading_rad + share->across * (b.heading_rad - a.heading_rad));
  node.spread_rad = static_cast<float>(std::abs(b.heading_rad - a.heading_rad));
}

// True if all four surrounding centres were reached earlier by more than
// margin_s_: this ray cannot improve any arrival any more.
bool ExtremalFan::IsLate(const ExtremalState& at) const {
  const int row = kg_base::HeldFloor(at.row, grid_.rows() - 2);
  const int col = kg_base::HeldFloor(at.col, grid_.cols() - 2);
  const double late_s = now_s_ - margin_s_;
  return arrivals_.Arrival_s({row, col}) < late_s &&
         arrivals_.Arrival_s({row, col + 1}) < late_s &&
         arrivals_.Arrival_s({row + 1, col}) < late_s &&
         arrivals_.Arrival_s({row + 1, col + 1}) < late_s;
}

// True if the front between two rays is short and straight enough to need no
// ray between them.
bool ExtremalFan::IsThin(const ExtremalState& a, const ExtremalState& b) const {
  const CellOffset na = NormalOf(flow_, a), nb = NormalOf(flow_, b);
  return (PlaceOf(b) - PlaceOf(a)).norm() < kThinner && na.dot(nb) > 0.0 &&
         std::abs(Cross(na, nb)) < kThinBend * na.dot(nb);
}

// Drops rays that are late and rays between close neighbours.
void ExtremalFan::Thin() {
  rays_.clear();
  bool linked = false;  // Is the next a neighbour of the last one kept?
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const Ray& ray = next_[i];
    if (IsLate(ray.at)) {
      if (linked) rays_.back().linked = false;
      linked = false;
      continue;
    }
    const bool between =
        linked && ray.linked && !IsLate(next_[i + 1].at) && next_[i + 1].linked;
    if (between &&
        !sight_.NearClosed(CellOf(grid_, {ray.at.row, ray.at.col}))) {
      if (IsThin(rays_.back().at, next_[i + 1].at)) continue;
    }
    rays_.push_back(ray);
    linked = ray.linked;
  }
}

// Box of all cells read: the field samples of the extremals, and the blocks of
// cells inspected around their tracks.
CellBox ExtremalFan::ReadBox() const {
  const auto down = [](double at, int felt) {
    const int cell = static_cast<int>(std::floor(at)) - 2;
    const int seen =
        std::max(cell, 0) / LineOfSight::kBlock * LineOfSight::kBlock - 1;
    return std::max(std::min(seen, felt), 0);
  };
  const auto up = [](double at, int felt, int size) {
    const int cell = static_cast<int>(std::ceil(at)) + 2;
    const int seen = (cell / LineOfSight::kBlock + 1) * LineOfSight::kBlock + 1;
    return std::min(std::max(seen, felt), size);
  };
  const CellBox& felt = flow_.felt();
  return {down(low_.y(), felt.row), up(high_.y(), felt.row_end, grid_.rows()),
          down(low_.x(), felt.col), up(high_.x(), felt.col_end, grid_.cols())};
}

}  // namespace kg_compiler
