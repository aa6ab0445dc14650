// Converts an agent's track within one window to and from the literals of a
// fact.
//
//   ex:pathWKT   "LINESTRING(-90.9 25.7, -90.8 25.7)"^^geo:wktLiteral
//   ex:pathTimes "1780358400 1780401600"
//
// Positions are CRS84 with 7 decimals (1 cm), times Unix seconds with one
// decimal. A track that crosses the antimeridian is cut there and becomes a
// MULTILINESTRING; both sides of a cut have the same time.

#ifndef KG_ENGINE_TERMS_TRACK_LITERAL_H_
#define KG_ENGINE_TERMS_TRACK_LITERAL_H_

#include <string>
#include <vector>

#include "kg_compiler/traversal/traversal.h"

namespace kg_engine {

using Track = std::vector<kg_compiler::TimedPoint>;

// Linear interpolation, across the antimeridian if shorter. `share` in [0, 1].
kg_compiler::TimedPoint Between(const kg_compiler::TimedPoint& a,
                                const kg_compiler::TimedPoint& b, double share);

// The part of a track within [from_s, to_s], with interpolated points at both
// ends where the track continues beyond. Empty if there is none.
Track CutTrack(const Track& track, double from_s, double to_s);

// Removes points so that the position at any time changes by at most
// `tolerance_m`. Keeps both ends.
Track SimplifyTrack(const Track& track, double tolerance_m);

// Splits a track into parts that do not cross the antimeridian, of two or more
// points each; a track of a single point is one part. Ends at a cut are at 180
// and -180 degrees.
std::vector<Track> CutAtAntimeridian(const Track& track);

struct TrackLiteral {
  std::string wkt;    // Empty for an empty track.
  std::string times;  // One time per WKT point.
};
TrackLiteral ToLiteral(const std::vector<Track>& parts);

// Throws kg_base::InputError if the counts differ, or times decrease.
std::vector<Track> FromLiteral(const TrackLiteral& literal);

}  // namespace kg_engine

#endif  // KG_ENGINE_TERMS_TRACK_LITERAL_H_
