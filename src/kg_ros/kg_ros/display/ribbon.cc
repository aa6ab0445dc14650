#include "kg_ros/display/ribbon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry_msgs/Point.h"

namespace kg_ros {
namespace {

using geometry_msgs::Point;
using visualization_msgs::Marker;

constexpr double kSquareHeight_m = 10.0;
// Maximum turn between legs that are merged.
constexpr double kStraight_rad = 0.01;

using Segment = std::pair<Point, Point>;

double Heading_rad(const Segment& segment) {
  return std::atan2(segment.second.y - segment.first.y,
                    segment.second.x - segment.first.x);
}

bool GoesOn(const Segment& one, const Segment& next) {
  const double gap_m =
      std::hypot(next.first.x - one.second.x, next.first.y - one.second.y);
  const double turn_rad =
      std::remainder(Heading_rad(next) - Heading_rad(one), 2.0 * M_PI);
  return gap_m == 0.0 && std::abs(turn_rad) < kStraight_rad;
}

// Segments of nonzero length; straight runs are merged.
std::vector<Segment> Segments(const Marker& marker) {
  const std::size_t stride = marker.type == Marker::LINE_LIST ? 2 : 1;
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < marker.points.size(); i += stride) {
    const Segment next{marker.points[i], marker.points[i + 1]};
    if (next.first.x == next.second.x && next.first.y == next.second.y) {
      continue;
    }
    if (!segments.empty() && GoesOn(segments.back(), next)) {
      segments.back().second = next.second;
    } else {
      segments.push_back(next);
    }
  }
  return segments;
}

// Point at `along` and `across` from `origin` in the segment's frame [m].
Point Beside(const Point& origin, double heading_rad, double along,
             double across) {
  Point point = origin;
  point.x += along * std::cos(heading_rad) - across * std::sin(heading_rad);
  point.y += along * std::sin(heading_rad) + across * std::cos(heading_rad);
  return point;
}

// Two triangles, extended by a quarter of the width at both ends to close
// joints.
void AddRibbon(const Segment& segment, double width_m,
               std::vector<Point>* points) {
  const double heading = Heading_rad(segment);
  const double half = width_m / 2.0;
  const Point a = Beside(segment.first, heading, -half / 2.0, half);
  const Point b = Beside(segment.first, heading, -half / 2.0, -half);
  const Point c = Beside(segment.second, heading, half / 2.0, -half);
  const Point d = Beside(segment.second, heading, half / 2.0, half);
  for (const Point& corner : {a, b, c, a, c, d}) points->push_back(corner);
}

void FlattenLines(Marker* marker) {
  std::vector<Point> points;
  for (const Segment& segment : Segments(*marker)) {
    AddRibbon(segment, marker->scale.x, &points);
  }
  marker->type = Marker::TRIANGLE_LIST;
  marker->points = std::move(points);
  marker->scale.x = marker->scale.y = marker->scale.z = 1.0;
}

}  // namespace

void Flatten(Marker* marker) {
  if (marker->type == Marker::LINE_STRIP || marker->type == Marker::LINE_LIST) {
    FlattenLines(marker);
  } else if (marker->type == Marker::POINTS) {
    marker->type = Marker::CUBE_LIST;
    marker->scale.z = kSquareHeight_m;
  }
}

void RemoveEmptyLists(visualization_msgs::MarkerArray* markers) {
  auto& list = markers->markers;
  list.erase(std::remove_if(list.begin(), list.end(),
                            [](const Marker& marker) {
                              return marker.type == Marker::TRIANGLE_LIST &&
                                     marker.points.empty();
                            }),
             list.end());
}

}  // namespace kg_ros
