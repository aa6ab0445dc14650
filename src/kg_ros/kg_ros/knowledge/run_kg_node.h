// kg_node: owns the mission's facts, compiles them, records the plans.
//
//   parameters  ~mission_folder  holds mission.ttl
//               ~data_folder     folder searched first for its files
//               ~state_folder    the durable store
//               ~view_window     window rviz looks at; -1 = the current one
//               ~http_port       SPARQL over HTTP on 127.0.0.1; 0 = off
//               ~http_token_file holds the access token; "" = none is asked
//               ~http_writable   true = accept updates over HTTP; needs a token

#ifndef KG_ROS_KNOWLEDGE_RUN_KG_NODE_H_
#define KG_ROS_KNOWLEDGE_RUN_KG_NODE_H_

namespace kg_ros {

// The main program. Returns EXIT_FAILURE after bad parameters, with a log line.
int RunKgNode(int argc, char** argv);

}  // namespace kg_ros

#endif  // KG_ROS_KNOWLEDGE_RUN_KG_NODE_H_
