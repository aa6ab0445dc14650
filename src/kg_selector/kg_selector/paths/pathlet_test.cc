#include "kg_selector/paths/pathlet.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

using kg_base::LonLat;
using kg_compiler::TimedPoint;
using Track = std::vector<TimedPoint>;

LonLat At(const Track& track, double time_s) {
  for (std::size_t i = 1; i < track.size(); ++i) {
    const TimedPoint& p = track[i - 1];
    const TimedPoint& q = track[i];
    if (time_s > q.time_s) continue;
    const double share = (time_s - p.time_s) / (q.time_s - p.time_s);
    const double lon_deg =
        p.position.lon_deg +
        share * std::remainder(q.position.lon_deg - p.position.lon_deg, 360.0);
    return {lon_deg, p.position.lat_deg +
                         share * (q.position.lat_deg - p.position.lat_deg)};
  }
  return track.back().position;
}

// Smallest geodesic distance over many times, refined around the minimum.
TrackApproach Sampled(const Track& a, const Track& b) {
  double from_s = std::max(a.front().time_s, b.front().time_s);
  double to_s = std::min(a.back().time_s, b.back().time_s);
  TrackApproach best{1e12, from_s};
  for (int level = 0; level < 4; ++level) {
    const double step_s = (to_s - from_s) / 2000.0;
    for (int i = 0; i <= 2000; ++i) {
      const double time_s = from_s + i * step_s;
      const double distance_m =
          kg_base::Distance_m(At(a, time_s), At(b, time_s));
      if (distance_m < best.distance_m) best = {distance_m, time_s};
    }
    from_s = std::max(from_s, best.time_s - 2.0 * step_s);
    to_s = std::min(to_s, best.time_s + 2.0 * step_s);
  }
  return best;
}

class RandomTracks {
 public:
  explicit RandomTracks(unsigned seed) : prng_(seed) {}
  double Number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(prng_);
  }
  Track Make(LonLat about, double begin_s) {
    Track track;
    double time_s = begin_s + Number(0.0, 3000.0);
    const double cos_lat = std::cos(about.lat_deg * 0.017453292519943295);
    for (int i = 0; i < 8; ++i) {
      const LonLat position = {about.lon_deg + Number(-0.07, 0.07) / cos_lat,
                               about.lat_deg + Number(-0.07, 0.07)};
      track.push_back({position, time_s});
      time_s += Number(600.0, 1800.0);
      if (Number(0.0, 1.0) < 0.3) {
        track.push_back({position, time_s});
        time_s += 500.0;
      }
    }
    return track;
  }

 private:
  std::mt19937 prng_;
};

TEST(ClosestApproachTest,
     EqualsDenselySampledGeodesicsWithinATenthOfAPermille) {
  RandomTracks random(42);
  for (int i = 0; i < 150; ++i) {
    const double lon_deg = random.Number(-180.0, 180.0);
    const LonLat about = {lon_deg, random.Number(-66.5, 66.5)};
    const Track a = random.Make(about, 0.0);
    const Track b = random.Make(about, 0.0);
    const auto found = ClosestApproach(a, b);
    const TrackApproach sampled = Sampled(a, b);
    ASSERT_TRUE(found);
    ASSERT_NEAR(found->distance_m, sampled.distance_m,
                1e-4 * sampled.distance_m + 0.05);
    ASSERT_NEAR(found->distance_m,
                kg_base::Distance_m(At(a, found->time_s), At(b, found->time_s)),
                1e-5 * sampled.distance_m + 1e-6);
  }
}

TEST(ClosestApproachTest, IsSymmetric) {
  RandomTracks random(43);
  for (int i = 0; i < 200; ++i) {
    const Track a = random.Make({-90.0, 25.0}, 0.0);
    const Track b = random.Make({-90.0, 25.0}, 0.0);
    EXPECT_NEAR(ClosestApproach(a, b)->distance_m,
                ClosestApproach(b, a)->distance_m, 1e-6);
  }
}

// Masking relies on this: the minimum over pieces is bitwise equal to that of
// the whole track.
TEST(ClosestApproachTest, OfTheWholeIsTheLeastOfItsPieces) {
  RandomTracks random(44);
  for (int i = 0; i < 300; ++i) {
    const Track a = random.Make({-90.0, 25.0}, 0.0);
    const Track b = random.Make({-90.0, 25.0}, 0.0);
    double least_m = 1e12;
    for (std::size_t k = 1; k < a.size(); ++k) {
      const auto piece = ClosestApproach({a[k - 1], a[k]}, b);
      if (piece) least_m = std::min(least_m, piece->distance_m);
    }
    EXPECT_EQ(ClosestApproach(a, b)->distance_m, least_m);
  }
}

TEST(ComeCloserThanTest, AgreesWithTheClosestApproach) {
  RandomTracks random(45);
  for (int i = 0; i < 500; ++i) {
    const LonLat about = {random.Number(-180.0, 180.0),
                          random.Number(-89.0, 89.0)};
    const Track a = random.Make(about, 0.0);
    const Track b = random.Make(about, 0.0);
    const double distance_m = ClosestApproach(a, b)->distance_m;
    EXPECT_FALSE(ComeCloserThan(a, b, distance_m, TimeSpan()));
    EXPECT_TRUE(
        ComeCloserThan(a, b, std::nextafter(distance_m, 1e12), TimeSpan()));
  }
  EXPECT_FALSE(ComeCloserThan({}, {}, 1e12, TimeSpan()));
}

const LonLat kHere = {-90.0, 25.0};
const LonLat kThere = {-89.9, 25.0};

TEST(ClosestApproachTest, IsNulloptWithoutACommonTime) {
  EXPECT_FALSE(ClosestApproach({}, {}));
  EXPECT_FALSE(ClosestApproach({{kHere, 0.0}}, {}));
  EXPECT_FALSE(ClosestApproach({{kHere, 0.0}, {kHere, 1.0}},
                               {{kHere, 1.5}, {kHere, 2.0}}));
}

TEST(ClosestApproachTest, OneCommonInstantIsEnough) {
  const auto touch = ClosestApproach({{kHere, 0.0}, {kThere, 1.0}},
                                     {{kThere, 1.0}, {kHere, 2.0}});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->distance_m, 0.0);
  EXPECT_EQ(touch->time_s, 1.0);
  EXPECT_EQ(ClosestApproach({{kHere, 1.0}}, {{kHere, 1.0}})->distance_m, 0.0);
}

TEST(ClosestApproachTest, OfHeadOnTracksIsZeroHalfWay) {
  const auto meeting = ClosestApproach({{kHere, 0.0}, {kThere, 1000.0}},
                                       {{kThere, 0.0}, {kHere, 1000.0}});
  EXPECT_NEAR(meeting->distance_m, 0.0, 1e-6);
  EXPECT_NEAR(meeting->time_s, 500.0, 1e-6);
}

TEST(ClosestApproachTest, OfAgentsAtRestIsTheirDistance) {
  const auto rest = ClosestApproach({{kHere, 0.0}, {kHere, 9.0}},
                                    {{kThere, 3.0}, {kThere, 5.0}});
  EXPECT_NEAR(rest->distance_m, kg_base::Distance_m(kHere, kThere), 0.1);
  EXPECT_EQ(rest->time_s, 3.0);
}

TEST(ClosestApproachTest, CrossesTheDateLine) {
  const Track a = {{{179.95, 10.0}, 0.0}, {{-179.95, 10.0}, 100.0}};
  const Track b = {{{-179.95, 10.0}, 0.0}, {{179.95, 10.0}, 100.0}};
  EXPECT_NEAR(ClosestApproach(a, b)->distance_m, 0.0, 1e-6);
  EXPECT_NEAR(ClosestApproach(a, b)->time_s, 50.0, 1e-6);
}

TEST(ClosestApproachTest, LooksOnlyAtTheSpan) {
  const Track a = {{kHere, 0.0}, {kThere, 1000.0}};
  const Track b = {{kThere, 0.0}, {kHere, 1000.0}};
  const auto late = ClosestApproach(a, b, {750.0, 1e9});
  EXPECT_EQ(late->time_s, 750.0);
  EXPECT_NEAR(late->distance_m, 0.5 * kg_base::Distance_m(kHere, kThere), 0.1);
  EXPECT_FALSE(ClosestApproach(a, b, {1001.0, 1e9}));
}

TEST(ClosestApproachTest, SeesAJumpFromBothSides) {
  const Track jump = {{kHere, 0.0}, {kHere, 5.0}, {kThere, 5.0}, {kThere, 9.0}};
  EXPECT_EQ(ClosestApproach(jump, {{kHere, 0.0}, {kHere, 9.0}})->distance_m,
            0.0);
  EXPECT_EQ(ClosestApproach(jump, {{kThere, 0.0}, {kThere, 9.0}})->distance_m,
            0.0);
}

TEST(FirstTimeApartTest, IsThatOfAPointOfEitherTrack) {
  const Track a = {{kHere, 0.0}, {kThere, 1000.0}};
  const Track b = {{kHere, 0.0}, {kHere, 300.0}, {kHere, 700.0}, {kHere, 1e4}};
  EXPECT_EQ(FirstTimeApart(a, b, 100.0, TimeSpan()), 300.0);
  EXPECT_EQ(FirstTimeApart(a, b, 5000.0, TimeSpan()), 700.0);
  EXPECT_EQ(FirstTimeApart(a, b, 10000.0, TimeSpan()), 1000.0);
  EXPECT_FALSE(FirstTimeApart(a, b, 20000.0, TimeSpan()));
  EXPECT_FALSE(FirstTimeApart(a, b, 5000.0, {0.0, 400.0}));
}

TEST(IsSamePathTest, ComparesTheWayAndItsValueOnly) {
  Pathlet path;
  path.reward = 5.0;
  path.seam_cost = 2.0;
  path.energy_j = 1e4;
  path.visits.resize(1);
  path.visits[0].waypoint = 3;
  path.visits[0].events = {"ex:seep"};
  path.visits[0].via = {{4, {-90.0, 25.0}}};
  path.track = {{{-90.0, 25.0}, 0.0}, {{-90.0, 25.1}, 3600.0}};
  Pathlet again = path;
  again.agent = "bravo";
  again.rank = 2;
  again.round = 1;
  again.visits[0].edge = 7;
  again.visits[0].cost.hazard_s = std::nan("");  // By message, for example.
  EXPECT_TRUE(IsSamePath(path, again));
  const std::vector<void (*)(Pathlet*)> changes = {
      [](Pathlet* p) { p->reward = 6.0; },
      [](Pathlet* p) { p->seam_cost = 1.0; },
      [](Pathlet* p) { p->energy_j = 0.0; },
      [](Pathlet* p) { p->visits[0].window = 1; },
      [](Pathlet* p) { p->visits[0].waypoint = 5; },
      [](Pathlet* p) { p->visits[0].events.clear(); },
      [](Pathlet* p) { p->visits[0].via[0].waypoint = 5; },
      [](Pathlet* p) { p->visits.emplace_back(); },
      [](Pathlet* p) { p->track[1].time_s = 7200.0; },
      [](Pathlet* p) { p->track[1].position.lat_deg = 25.2; },
      [](Pathlet* p) { p->track.pop_back(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Pathlet other = path;
    changes[i](&other);
    EXPECT_FALSE(IsSamePath(path, other)) << i;
  }
}

}  // namespace
}  // namespace kg_selector
