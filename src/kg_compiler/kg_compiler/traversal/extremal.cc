#include "kg_compiler/traversal/extremal.h"

namespace kg_compiler {
namespace {

ExtremalState Along(const ExtremalState& from, const ExtremalState& rate,
                    double s) {
  return {from.col + s * rate.col, from.row + s * rate.row,
          from.p_lon + s * rate.p_lon, from.p_lat + s * rate.p_lat};
}

}  // namespace

ExtremalState SetOut(const FlowSampler& flow, kg_core::GridPoint from,
                     double heading_rad) {
  const kg_core::LonLat scale = flow.Scale(from.row);
  const double unit = scale.lon_deg;  // So that |p| is about 1.
  return {from.col, from.row, std::cos(heading_rad) / scale.lon_deg * unit,
          std::sin(heading_rad) / scale.lat_deg * unit};
}

double HeadingOf(const FlowSampler& flow, const ExtremalState& at) {
  const kg_core::LonLat scale = flow.Scale(at.row);
  return std::atan2(scale.lat_deg * at.p_lat, scale.lon_deg * at.p_lon);
}

ExtremalStepper::Step::Step(const FlowSampler& flow, double begin_s,
                            double length_s)
    : length_s(length_s),
      begin(flow.At(begin_s)),
      middle(flow.At(begin_s + 0.5 * length_s)),
      end(flow.At(begin_s + length_s)) {}

ExtremalState ExtremalStepper::Rate(const ExtremalState& at,
                                    const FlowSampler::Moment& moment) const {
  const FlowSampler::Sample c = flow_(moment, at.col, at.row);
  const double east = c.lon_per_m * at.p_lon;
  const double north = c.lat_per_m * at.p_lat;
  const double own = speed_mps_ / std::sqrt(east * east + north * north);
  const double ground_east = c.east + own * east;
  const double ground_north = c.north + own * north;
  const double bend = at.p_lon * c.lon_per_m_row * ground_east +
                      at.p_lat * c.lat_per_m_row * ground_north;
  return {ground_east * c.lon_per_m * c.cols_per_deg,
          ground_north * c.lat_per_m * c.rows_per_deg,
          -(east * c.east_col + north * c.north_col) * c.cols_per_deg,
          -(east * c.east_row + north * c.north_row + bend) * c.rows_per_deg};
}

ExtremalState ExtremalStepper::Advance(const ExtremalState& from,
                                       const Step& step) const {
  const double h = step.length_s;
  const ExtremalState k1 = Rate(from, step.begin);
  const ExtremalState k2 = Rate(Along(from, k1, 0.5 * h), step.middle);
  const ExtremalState k3 = Rate(Along(from, k2, 0.5 * h), step.middle);
  const ExtremalState k4 = Rate(Along(from, k3, h), step.end);
  const double w = h / 6.0;
  return {from.col + w * (k1.col + 2.0 * (k2.col + k3.col) + k4.col),
          from.row + w * (k1.row + 2.0 * (k2.row + k3.row) + k4.row),
          from.p_lon + w * (k1.p_lon + 2.0 * (k2.p_lon + k3.p_lon) + k4.p_lon),
          from.p_lat + w * (k1.p_lat + 2.0 * (k2.p_lat + k3.p_lat) + k4.p_lat)};
}

kg_core::GridPoint ExtremalStepper::Velocity(
    const ExtremalState& at, const FlowSampler::Moment& moment) const {
  const ExtremalState rate = Rate(at, moment);
  return {rate.row, rate.col};
}

}  // namespace kg_compiler
