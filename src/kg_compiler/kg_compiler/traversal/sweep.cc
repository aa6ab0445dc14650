#include "kg_compiler/traversal/sweep.h"

#include <algorithm>
#include <cmath>

namespace kg_compiler {
namespace {

// Tolerance: shared edges belong to both sides.
constexpr double kTouch = 1e-9;
constexpr double kSteepest = 0.6;  // Largest slope at which the cubic is used.
// Least fraction of the motion normal to the front.
constexpr double kSlantest = 0.2;
constexpr double kNoLength = 1e-12;  // [cells]
constexpr double kRefined = 1e-3;    // [cells]

double Clamp01(double x) { return std::min(std::max(x, 0.0), 1.0); }

CellOffset Normalised(const CellOffset& a) { return (1.0 / a.norm()) * a; }

}  // namespace

CellOffset NormalOf(const FlowSampler& flow, const ExtremalState& at) {
  return {at.p_lon * flow.DegPerCol(at.col), at.p_lat * flow.DegPerRow(at.row)};
}

std::optional<ExtremalState> Halfway(const FlowSampler& flow,
                                     const ExtremalState& a,
                                     const ExtremalState& b) {
  const CellOffset na = Normalised(NormalOf(flow, a));
  const CellOffset nb = Normalised(NormalOf(flow, b));
  const CellOffset chord = PlaceOf(b) - PlaceOf(a);
  const double length = chord.norm();
  CellOffset middle = PlaceOf(a) + 0.5 * chord;
  CellOffset normal = na + nb;
  if (length > kNoLength) {
    // Tangents along the chord, at right angles to the normals.
    CellOffset ta{-na.y(), na.x()}, tb{-nb.y(), nb.x()};
    if (ta.dot(chord) < 0.0) ta = -1.0 * ta;
    if (tb.dot(chord) < 0.0) tb = -1.0 * tb;
    if (!(ta.dot(chord) > 0.5 * length && tb.dot(chord) > 0.5 * length)) {
      return std::nullopt;
    }
    middle = middle + (0.125 * length) * (ta - tb);
    const CellOffset tangent = (1.5 / length) * chord - 0.25 * (ta + tb);
    const CellOffset across{-tangent.y(), tangent.x()};
    // Orient the normal towards the motion of the extremals.
    const double side = across.dot(normal) < 0.0 ? -1.0 : 1.0;
    normal = side * across;
  }
  if (!(normal.norm() > 1e-3)) return std::nullopt;
  ExtremalState half{middle.x(), middle.y(), 0.0, 0.0};
  half.p_lon = normal.x() / flow.DegPerCol(half.col);
  half.p_lat = normal.y() / flow.DegPerRow(half.row);
  return half;
}

double FrontSweep::Bow::Ahead(double s) const {
  const double r = 1.0 - s;
  return length * s * r * (slope_a * r - slope_b * s);
}

FrontSweep::Bow FrontSweep::BowOf(const CellOffset& chord,
                                  const CellOffset& normal_a,
                                  const CellOffset& normal_b) const {
  Bow bow;
  bow.length = chord.norm();
  if (!(bow.length > kNoLength)) return {};
  CellOffset ahead{-chord.y(), chord.x()};
  if (ahead.dot(motion_) < 0.0) ahead = -1.0 * ahead;
  const double a = normal_a.dot(ahead), b = normal_b.dot(ahead);
  if (!(a > 0.0 && b > 0.0)) return {bow.length, HUGE_VAL, HUGE_VAL};
  bow.slope_a = -normal_a.dot(chord) / a;
  bow.slope_b = -normal_b.dot(chord) / b;
  return bow;
}

FrontSweep::FrontSweep(const FlowSampler& flow, const ExtremalStrand& a,
                       const ExtremalStrand& b, double length_s)
    : a0_(PlaceOf(a.begin)),
      a1_(PlaceOf(a.end)),
      b0_(PlaceOf(b.begin)),
      b1_(PlaceOf(b.end)),
      begin_edge_(b0_ - a0_),
      motion_(a1_ - a0_),
      twist_((b1_ - a1_) - begin_edge_),
      length_s_(length_s) {
  // Invert the linear map of each triangle once, for all calls of Find().
  const CellOffset end_edge = b1_ - a1_;
  const double det_a = Cross(begin_edge_, b1_ - a0_);
  const double det_b = Cross(b1_ - a0_, motion_);
  if (std::abs(det_a) > kNoLength) inverse_a_ = 1.0 / det_a;
  if (std::abs(det_b) > kNoLength) inverse_b_ = 1.0 / det_b;
  // The mean motion of both ends defines the forward direction of the bows.
  motion_ = 0.5 * (motion_ + (b1_ - b0_));
  begin_bow_ =
      BowOf(begin_edge_, NormalOf(flow, a.begin), NormalOf(flow, b.begin));
  end_bow_ = BowOf(end_edge, NormalOf(flow, a.end), NormalOf(flow, b.end));
  const double across =
      end_bow_.length > kNoLength
          ? std::abs(Cross(end_edge, motion_)) / end_bow_.length
          : 0.0;
  // Speed of the front along its normal, if it moves mostly along the normal
  // and is smooth enough for a cubic; otherwise the chord is used.
  if (across > kSlantest * motion_.norm() && Slope() < kSteepest) {
    s_per_cell_ = length_s_ / across;
  }
  motion_ = a1_ - a0_;
}

double FrontSweep::Slope() const {
  return std::max(
      std::max(std::abs(begin_bow_.slope_a), std::abs(begin_bow_.slope_b)),
      std::max(std::abs(end_bow_.slope_a), std::abs(end_bow_.slope_b)));
}

CellOffset FrontSweep::low() const {
  return {std::min(std::min(a0_.x(), a1_.x()), std::min(b0_.x(), b1_.x())),
          std::min(std::min(a0_.y(), a1_.y()), std::min(b0_.y(), b1_.y()))};
}

CellOffset FrontSweep::high() const {
  return {std::max(std::max(a0_.x(), a1_.x()), std::max(b0_.x(), b1_.x())),
          std::max(std::max(a0_.y(), a1_.y()), std::max(b0_.y(), b1_.y()))};
}

// Two triangles, on either side of the diagonal from a0 to b1.
std::optional<FrontSweep::Share> FrontSweep::Find(
    const CellOffset& place) const {
  const CellOffset d = place - a0_, diagonal = b1_ - a0_;
  const double aside = Cross(d, diagonal);  // Which side of the diagonal?
  const double b0 = aside * inverse_a_;
  if (inverse_a_ != 0.0 && b0 >= -kTouch) {
    const double b1 = Cross(begin_edge_, d) * inverse_a_;
    if (b1 >= -kTouch && b0 + b1 <= 1.0 + kTouch) {
      return Refine(place, {b0 + b1, b1});
    }
  }
  const double a1 = -aside * inverse_b_;
  if (inverse_b_ != 0.0 && a1 >= -kTouch) {
    const double b1 = Cross(d, motion_) * inverse_b_;
    if (b1 >= -kTouch && b1 + a1 <= 1.0 + kTouch) {
      return Refine(place, {b1, b1 + a1});
    }
  }
  return std::nullopt;
}

// Newton's method for X(s, w) = place.
FrontSweep::Share FrontSweep::Refine(const CellOffset& place,
                                     Share share) const {
  for (int i = 0; i < 2; ++i) {
    const CellOffset by_s = begin_edge_ + share.along * twist_;
    const CellOffset by_w = motion_ + share.across * twist_;
    const double det = Cross(by_s, by_w);
    if (!(std::abs(det) > kNoLength)) break;
    const CellOffset miss =
        place - (a0_ + share.across * begin_edge_ + share.along * by_w);
    share.across = Clamp01(share.across + Cross(miss, by_w) / det);
    share.along = Clamp01(share.along + Cross(by_s, miss) / det);
  }
  return share;
}

double FrontSweep::Time_s(Share share) const {
  const double ahead = (1.0 - share.along) * begin_bow_.Ahead(share.across) +
                       share.along * end_bow_.Ahead(share.across);
  return share.along * length_s_ -
         (s_per_cell_ > 0.0 ? ahead * s_per_cell_ : 0.0);
}

}  // namespace kg_compiler
