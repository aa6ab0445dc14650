#include "kg_engine/terms/track_literal.h"

#include <cmath>
#include <random>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/geo/wkt.h"

namespace kg_engine {
namespace {

using kg_compiler::TimedPoint;

Track RandomWalk(std::mt19937& random, double lon_deg) {
  std::uniform_real_distribution<double> step(-0.02, 0.02), wait(60.0, 3600.0);
  Track track = {{{lon_deg, 25.0}, 1.78e9}};
  for (int i = 0; i < 60; ++i) {
    TimedPoint next = track.back();
    next.position.lon_deg += step(random);
    if (next.position.lon_deg >= 180.0) next.position.lon_deg -= 360.0;
    if (next.position.lon_deg < -180.0) next.position.lon_deg += 360.0;
    next.position.lat_deg += step(random);
    next.time_s += std::floor(wait(random));
    track.push_back(next);
  }
  return track;
}

// Position on a track, directly from the definition.
kg_base::LonLat PlaceAt(const Track& track, double time_s) {
  for (std::size_t i = 1; i < track.size(); ++i) {
    if (track[i].time_s < time_s) continue;
    const double span_s = track[i].time_s - track[i - 1].time_s;
    const double share =
        span_s > 0.0 ? (time_s - track[i - 1].time_s) / span_s : 0.0;
    return Between(track[i - 1], track[i], share).position;
  }
  return track.back().position;
}

TEST(TrackLiteral, ATrackReadsBackToACentimetreAndATenthOfASecond) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Track track = RandomWalk(random, -90.0);
    const auto parts = FromLiteral(ToLiteral({track}));
    ASSERT_EQ(parts.size(), 1u);
    ASSERT_EQ(parts[0].size(), track.size());
    for (std::size_t k = 0; k < track.size(); ++k) {
      EXPECT_LT(kg_base::Distance_m(parts[0][k].position, track[k].position),
                0.01);
      EXPECT_NEAR(parts[0][k].time_s, track[k].time_s, 0.05);
    }
  }
}

TEST(TrackLiteral, ASimplerTrackIsNeverFurtherOffThanTheTolerance) {
  std::mt19937 random(4);
  std::size_t before = 0, after = 0;
  for (int i = 0; i < 30; ++i) {
    const Track track = RandomWalk(random, i % 2 == 0 ? -90.0 : 179.99);
    const Track simple = SimplifyTrack(track, 500.0);
    before += track.size();
    after += simple.size();
    EXPECT_EQ(simple.front().time_s, track.front().time_s);
    EXPECT_EQ(simple.back().time_s, track.back().time_s);
    for (double share = 0.0; share <= 1.0; share += 0.001) {
      const double time_s =
          track.front().time_s +
          share * (track.back().time_s - track.front().time_s);
      EXPECT_LE(
          kg_base::Distance_m(PlaceAt(track, time_s), PlaceAt(simple, time_s)),
          501.0);
    }
  }
  EXPECT_LT(after, before);
}

TEST(TrackLiteral, ACutTrackIsWhereTheWholeOneIs) {
  std::mt19937 random(5);
  const Track track = RandomWalk(random, 10.0);
  const double from_s = track.front().time_s + 5000.3;
  const double to_s = track.back().time_s - 4000.7;
  const Track cut = CutTrack(track, from_s, to_s);
  EXPECT_EQ(cut.front().time_s, from_s);
  EXPECT_EQ(cut.back().time_s, to_s);
  for (double t = from_s; t < to_s; t += 777.0) {
    EXPECT_LT(kg_base::Distance_m(PlaceAt(track, t), PlaceAt(cut, t)), 0.01);
  }
}

TEST(TrackLiteral, CutsThatMeetShareTheirPoint) {
  const Track track = {{{0, 0}, 0.0}, {{2, 0}, 100.0}};
  const Track first = CutTrack(track, -10.0, 50.0);
  const Track second = CutTrack(track, 50.0, 200.0);
  EXPECT_EQ(first.size(), 2u);
  EXPECT_EQ(second.size(), 2u);
  EXPECT_EQ(first.back().position.lon_deg, 1.0);
  EXPECT_EQ(second.front().position.lon_deg, 1.0);
  EXPECT_TRUE(CutTrack(track, 200.0, 300.0).empty());
}

TEST(TrackLiteral, IsCutAtTheAntimeridian) {
  const Track track = {{{179.0, 10.0}, 0.0}, {{-179.0, 12.0}, 100.0}};
  const auto parts = CutAtAntimeridian(track);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].back().position.lon_deg, 180.0);
  EXPECT_EQ(parts[1].front().position.lon_deg, -180.0);
  EXPECT_NEAR(parts[0].back().position.lat_deg, 11.0, 1e-9);
  EXPECT_NEAR(parts[1].front().time_s, 50.0, 1e-9);
  const TrackLiteral literal = ToLiteral(parts);
  EXPECT_EQ(literal.wkt,
            "MULTILINESTRING((179 10, 180 11), (-180 11, -179 12))");
  EXPECT_EQ(literal.times, "0 50 50 100");
  EXPECT_EQ(FromLiteral(literal).size(), 2u);
  EXPECT_NO_THROW(kg_base::Geometry::FromWkt(literal.wkt));
}

TEST(TrackLiteral, NoPartPassesTheAntimeridianAndNoneIsAPoint) {
  std::mt19937 random(6);
  int cuts = 0;
  for (int i = 0; i < 50; ++i) {
    const auto parts = CutAtAntimeridian(RandomWalk(random, 179.995));
    cuts += static_cast<int>(parts.size()) - 1;
    for (const Track& part : parts) {
      EXPECT_GE(part.size(), 2u);
      for (std::size_t k = 1; k < part.size(); ++k) {
        EXPECT_LT(
            std::abs(part[k].position.lon_deg - part[k - 1].position.lon_deg),
            180.0);
      }
    }
  }
  EXPECT_GT(cuts, 50);
}

TEST(TrackLiteral, ATrackThatOnlyTouchesTheAntimeridianHasOnePart) {
  const Track track = {{{179.0, 10.0}, 0.0}, {{-180.0, 10.0}, 100.0}};
  const auto parts = CutAtAntimeridian(track);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].back().position.lon_deg, 180.0);
}

TEST(TrackLiteral, RefusesLiteralsThatDoNotFit) {
  const std::string wkt = "LINESTRING(1 2, 3 4)";
  EXPECT_NO_THROW(FromLiteral({wkt, "1 2"}));
  for (const char* times : {"", "1", "1 2 3", "2 1", "1 x", "1 nan"}) {
    EXPECT_THROW(FromLiteral({wkt, times}), kg_base::InputError) << times;
  }
  for (const char* bad : {"", "POINT(1 2)", "LINESTRING(1)", "LINESTRING(",
                          "LINESTRING(1 2, a b)", "LINESTRING(inf 2)"}) {
    EXPECT_THROW(FromLiteral({bad, "1 2"}), kg_base::InputError) << bad;
  }
}

}  // namespace
}  // namespace kg_engine
