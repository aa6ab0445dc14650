// Is what is held what compiling all facts anew gives? The proof, on a living
// world, that compiling only what a change made dirty loses nothing.

#ifndef KG_ROS_KNOWLEDGE_WORLD_CHECK_H_
#define KG_ROS_KNOWLEDGE_WORLD_CHECK_H_

#include "kg_core/mission/ingest.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_msgs/CheckResponse.h"
#include "kg_ros/knowledge/start_state.h"

namespace kg_ros {

// Of a running world: what its compiler holds (if facts have moved on since the
// last cycle, brought up to them as the next cycle will) against a compiler
// that begins with nothing. Bit by bit. Never throws for what the world says:
// that is in `errors`.
kg_msgs::CheckResponse CheckWorld(const Present& present,
                                  kg_core::FileCache* files);

// Of a store that nobody runs: the tensors that its provenance graph says were
// made, against those that its facts give now, by their hashes (which are of
// all that a tensor is made of) and sources.
kg_msgs::CheckResponse CheckStore(const kg_core::GraphView& view,
                                  kg_core::FileCache* files);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_WORLD_CHECK_H_
