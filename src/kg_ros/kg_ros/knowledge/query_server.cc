#include "kg_ros/knowledge/query_server.h"

#include <string>

#include "kg_base/common/input_error.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_engine/export/export_server.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/state/mission_state.h"
#include "kg_msgs/Export.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/answer_conversion.h"

namespace kg_ros {
namespace {

using kg_core::QueryResult;

constexpr unsigned kQueryThreads = 4;
bool IsGraph(const QueryResult& result) {
  return result.form == QueryResult::Form::kConstruct ||
         result.form == QueryResult::Form::kDescribe;
}

// Empty name = the first format, JSON.
const kg_core::ResultFormat& FormatNamed(const std::string& name) {
  std::string known;
  for (const kg_core::ResultFormat& format : kg_core::ResultFormats()) {
    if (name.empty() || name == format.name) return format;
    known += known.empty() ? format.name : std::string(", ") + format.name;
  }
  throw kg_base::InputError("format '" + name + "' is not known; expected " +
                            known);
}

}  // namespace

QueryServer::QueryServer(const ros::NodeHandle& node,
                         const kg_engine::MissionServer* server)
    : query_node_(node),
      node_(node),
      server_(server),
      query_spinner_(kQueryThreads, &query_queue_),
      spinner_(1, &queue_) {
  query_node_.setCallbackQueue(&query_queue_);
  node_.setCallbackQueue(&queue_);
  services_.push_back(query_node_.advertiseService(
      kQueryService, &QueryServer::HandleQuery, this));
  const boost::function<bool(kg_msgs::Export::Request&,
                             kg_msgs::Export::Response&)>
      do_export = [server](kg_msgs::Export::Request& request,
                           kg_msgs::Export::Response& response) {
        response =
            ToMessage(kg_engine::Export(*server->Read(), FromMessage(request)));
        return true;
      };
  services_.push_back(node_.advertiseService(kExportService, do_export));
  query_spinner_.start();
  spinner_.start();
}

QueryServer::~QueryServer() {
  query_spinner_.stop();
  spinner_.stop();
}

bool QueryServer::HandleQuery(kg_msgs::Query::Request& request,
                              kg_msgs::Query::Response& response) {
  const std::shared_ptr<const kg_core::GraphView> view = server_->Read();
  response.world_version = view->world_version();
  try {
    const QueryResult result = kg_core::RunQuery(
        *view, request.query, kg_engine::CurrentDataset(*view), {});
    response.text = kg_core::ToTextTable(result);
    if (IsGraph(result)) {
      response.rows = static_cast<unsigned>(result.triples.size());
      response.result = kg_core::TriplesToTurtle(result.triples);
    } else {
      response.rows = static_cast<unsigned>(result.rows.size());
      response.result = FormatNamed(request.format).write(result);
    }
    response.ok = true;
  } catch (const kg_base::InputError& error) {
    response.error = error.what();
  }
  return true;
}

}  // namespace kg_ros
