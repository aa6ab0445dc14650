#include "kg_ros/display/layer_publisher.h"

#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_engine/display/layers.h"
#include "kg_ros/base/names.h"
#include "kg_ros/display/clicked_point.h"
#include "kg_ros/display/raster_map.h"
#include "kg_ros/display/work_marker.h"
#include "ros/console.h"

namespace kg_ros {
namespace {

using kg_base::MapProjection;
using kg_compiler::WorkMap;
using kg_engine::AgentView;
using kg_engine::FusedPercents;
using kg_engine::Percents;
using kg_engine::ShownLayer;
using kg_engine::ShownLayers;
using nav_msgs::OccupancyGrid;
using visualization_msgs::Marker;

constexpr unsigned kClicks = 10;  // Queue length of clicks.

// A view with its work map, computed once on demand.
class Looked {
 public:
  Looked(AgentView view, std::vector<kg_base::LonLat> places,
         const MapProjection& map)
      : view_(std::move(view)), places_(std::move(places)), map_(map) {}

  OccupancyGrid Heatmap() const { return Map(FusedPercents(view_.tensor())); }
  OccupancyGrid Layer(const ShownLayer& layer) {
    return Map(layer.paint(view_.tensor(), layer.of_pose ? &Work() : nullptr));
  }
  Marker WorkInColour() {
    Marker marker = ToWorkMarker(view_.tensor().grid, Work(), places_, map_);
    marker.header.stamp = ros::Time::now();
    return marker;
  }

 private:
  const WorkMap& Work() {
    if (!work_) work_ = view_.WorkFrom(places_);
    return *work_;
  }
  OccupancyGrid Map(const Percents& percents) const {
    OccupancyGrid grid = ToOccupancyGrid(view_.tensor().grid, percents, map_);
    grid.header.stamp = ros::Time::now();
    grid.info.map_load_time = grid.header.stamp;
    return grid;
  }

  AgentView view_;
  std::vector<kg_base::LonLat> places_;
  MapProjection map_;
  std::optional<WorkMap> work_;
};

}  // namespace

LayerPublisher::AgentTopics::AgentTopics(const ros::NodeHandle& node,
                                         const std::string& agent_id)
    : heatmap(node, AgentTopic(agent_id, kHeatmap)),
      work(node, AgentTopic(agent_id, kWork)),
      work_clicked(node, AgentTopic(agent_id, kWorkClicked)) {
  for (const ShownLayer& layer : ShownLayers()) {
    layers.try_emplace(layer.name, node,
                       AgentTopic(agent_id, LayerName(layer.name)));
  }
}

LayerPublisher::LayerPublisher(const ros::NodeHandle& node) : node_(node) {
  clicks_ = node_.subscribe(kClickedPointTopic, 1, &LayerPublisher::HandleClick,
                            this);
}

void LayerPublisher::Show(kg_engine::Scene scene, const MapProjection& map) {
  scene_ = std::move(scene);
  map_ = map;
  std::set<std::string> ids;
  for (const kg_mission::Agent& agent : scene_.compilation->mission.agents) {
    ids.insert(agent.id);
    ShowAgent(agent.id);
  }
  for (auto topics = agents_.begin(); topics != agents_.end();) {
    const bool stays = ids.count(topics->first) > 0;
    topics = stays ? std::next(topics) : agents_.erase(topics);
  }
}

void LayerPublisher::ShowAgent(const std::string& agent_id) {
  const std::optional<AgentView> view = AgentView::Of(scene_, agent_id);
  if (!view) return;
  AgentTopics& topics =
      agents_.try_emplace(agent_id, node_, agent_id).first->second;
  const auto looked = std::make_shared<Looked>(*view, view->places(), map_);
  const std::string& tensor_key = view->tensor().hash;
  const std::string work_key = view->WorkKey(view->places());
  topics.heatmap.Offer(tensor_key, [looked] { return looked->Heatmap(); });
  for (const ShownLayer& layer : ShownLayers()) {
    topics.layers.at(layer.name)
        .Offer(layer.of_pose ? work_key : tensor_key,
               [looked, layer] { return looked->Layer(layer); });
  }
  topics.work.Offer(work_key, [looked] { return looked->WorkInColour(); });
  if (clicked_) ShowClick(agent_id, *view);
}

void LayerPublisher::ShowClick(const std::string& agent_id,
                               const AgentView& view) {
  const std::vector<kg_base::LonLat> place = {*clicked_};
  const auto looked = std::make_shared<Looked>(view, place, map_);
  agents_.at(agent_id).work_clicked.Offer(
      view.WorkKey(place), [looked] { return looked->WorkInColour(); });
}

void LayerPublisher::HandleClick(const geometry_msgs::PointStamped& message) {
  if (scene_.compilation == nullptr) return;
  kg_base::LonLat place;
  try {
    place = ToPosition(message, frames_, map_);
  } catch (const kg_base::InputError& error) {
    ROS_WARN("[display] clicked point ignored: %s", error.what());
    return;
  }
  const kg_base::Grid& grid = scene_.compilation->tensors.front()->grid;
  if (!grid.CellAt(place)) {
    ROS_WARN(
        "[display] clicked point ignored: (%g, %g, %g) in frame '%s' is "
        "outside the mission's grid",
        message.point.x, message.point.y, message.point.z,
        message.header.frame_id.c_str());
    return;
  }
  clicked_ = place;
  for (const auto& [id, topics] : agents_) {
    const std::optional<AgentView> view = AgentView::Of(scene_, id);
    if (view) ShowClick(id, *view);
  }
}

}  // namespace kg_ros
