#include "kg_compiler/traversal/extremal.h"

namespace kg_compiler {
namespace {

// State vector (col, row, p_lon, p_lat).
Eigen::Vector4d ToVector(const ExtremalState& at) {
  return {at.col, at.row, at.p_lon, at.p_lat};
}

ExtremalState ToState(const Eigen::Vector4d& at) {
  return {at[0], at[1], at[2], at[3]};
}

}  // namespace

ExtremalState SetOut(const FlowSampler& flow, kg_base::GridPoint from,
                     double heading_rad) {
  const kg_base::LonLat scale = flow.Scale(from.row);
  const double unit = scale.lon_deg;  // Normalises |p| to about 1.
  return {from.col, from.row, std::cos(heading_rad) / scale.lon_deg * unit,
          std::sin(heading_rad) / scale.lat_deg * unit};
}

double HeadingOf(const FlowSampler& flow, const ExtremalState& at) {
  const kg_base::LonLat scale = flow.Scale(at.row);
  return std::atan2(scale.lat_deg * at.p_lat, scale.lon_deg * at.p_lon);
}

ExtremalStepper::Step::Step(const FlowSampler& flow, double begin_s,
                            double length_s)
    : length_s(length_s),
      begin(flow.At(begin_s)),
      middle(flow.At(begin_s + 0.5 * length_s)),
      end(flow.At(begin_s + length_s)) {}

Eigen::Vector4d ExtremalStepper::Rate(const ExtremalState& at,
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
  const Eigen::Vector4d x = ToVector(from);
  const Eigen::Vector4d k1 = Rate(from, step.begin);
  const Eigen::Vector4d k2 = Rate(ToState(x + 0.5 * h * k1), step.middle);
  const Eigen::Vector4d k3 = Rate(ToState(x + 0.5 * h * k2), step.middle);
  const Eigen::Vector4d k4 = Rate(ToState(x + h * k3), step.end);
  return ToState(x + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4));
}

kg_base::GridPoint ExtremalStepper::Velocity(
    const ExtremalState& at, const FlowSampler::Moment& moment) const {
  const Eigen::Vector4d rate = Rate(at, moment);
  return {rate[1], rate[0]};
}

}  // namespace kg_compiler
