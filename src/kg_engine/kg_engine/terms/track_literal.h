// The way of an agent within one window <-> the literals of a fact.
//
//   ex:pathWKT   "LINESTRING(-90.9 25.7, -90.8 25.7)"^^geo:wktLiteral
//   ex:pathTimes "1780358400 1780401600"
//
// Positions are CRS84 with 7 decimals (1 cm), times Unix seconds with one
// decimal. A track that passes the antimeridian is cut there and becomes a
// MULTILINESTRING; both sides of a cut bear its time.

#ifndef KG_ENGINE_TERMS_TRACK_LITERAL_H_
#define KG_ENGINE_TERMS_TRACK_LITERAL_H_

#include <string>
#include <vector>

#include "kg_compiler/traversal/traversal.h"

namespace kg_engine {

using Track = std::vector<kg_compiler::TimedPoint>;

// Longitudes go the shorter way round. `share` in [0, 1].
kg_compiler::TimedPoint Between(const kg_compiler::TimedPoint& a,
                                const kg_compiler::TimedPoint& b, double share);

// What lies within [from_s, to_s], with points of its own at both ends where
// the track goes on beyond them. Empty if nothing does.
Track CutTrack(const Track& track, double from_s, double to_s);

// Leaves out points so that the agent's place at any time moves by at most
// `tolerance_m`. Keeps both ends.
Track SimplifyTrack(const Track& track, double tolerance_m);

// Parts of which none passes the antimeridian, each of two points or more; a
// track of a single point is one part. Ends at a cut lie on 180 and -180.
std::vector<Track> CutAtAntimeridian(const Track& track);

struct TrackLiteral {
  std::string wkt;    // Empty for an empty track.
  std::string times;  // As many as the WKT has points.
};
TrackLiteral ToLiteral(const std::vector<Track>& parts);

// Throws kg_base::InputError if the two do not fit, or times go back.
std::vector<Track> FromLiteral(const TrackLiteral& literal);

}  // namespace kg_engine

#endif  // KG_ENGINE_TERMS_TRACK_LITERAL_H_
