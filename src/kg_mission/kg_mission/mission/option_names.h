// Names of the mission's options that other packages implement: the values of
// ex:teamMode, ex:fairness and ex:movementMode. Mission reader, messages and
// the tables of the implementations use these names; a test compares them with
// the shapes. The first of each list is the default.

#ifndef KG_MISSION_MISSION_OPTION_NAMES_H_
#define KG_MISSION_MISSION_OPTION_NAMES_H_

namespace kg_mission {

inline constexpr char kGreedyMode[] = "greedy";
inline constexpr char kAuctionMode[] = "auction";
inline constexpr char kPricedMode[] = "priced";
inline constexpr char kExactMode[] = "exact";
inline constexpr const char* kTeamModeNames[] = {kGreedyMode, kAuctionMode,
                                                 kPricedMode, kExactMode};

inline constexpr char kScarcityFairness[] = "scarcity";
inline constexpr char kBalanceFairness[] = "balance";
inline constexpr char kMaxMinFairness[] = "max_min";
inline constexpr const char* kFairnessNames[] = {
    kScarcityFairness, kBalanceFairness, kMaxMinFairness};

inline constexpr char kHopsMovement[] = "hops";
inline constexpr char kEdgesMovement[] = "edges";
inline constexpr const char* kMovementModeNames[] = {kHopsMovement,
                                                     kEdgesMovement};

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_OPTION_NAMES_H_
