#include "kg_mission/mission/layer_reader.h"

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/choice.h"
#include "kg_mission/mission/source_quantities.h"

namespace kg_mission {
namespace {

using kg_base::Resampling;
using kg_core::Ex;
using kg_core::Prov;

constexpr NamedChoice<Resampling> kResamplings[] = {
    {"bilinear", Resampling::kBilinear}, {"nearest", Resampling::kNearest}};
constexpr NamedChoice<const char*> kValueKinds[] = {
    {kDifferenceKind, kDifferenceKind},
    {kPlainKind, kPlainKind},
    {kFrontnessKind, kFrontnessKind}};

constexpr std::size_t kMaxStepDigits = 6;

int ReadStep(const FactEntity& entity, const std::string& digits) {
  const bool is_number =
      !digits.empty() && digits.size() <= kMaxStepDigits &&
      digits.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number) {
    entity.Refuse(Ex("gridRef"),
                  "a time step behind @, not \"" + digits + "\"");
  }
  return std::stoi(digits);
}

}  // namespace

Resampling ReadResampling(const FactEntity& entity) {
  return Choice(entity, Ex("resampling"), kResamplings, Resampling::kNone);
}

std::string FileIri(const std::string& ingested_from) {
  return ingested_from + "/file";
}

std::optional<GridRef> ReadGridRef(const FactEntity& entity) {
  const std::string text = entity.Text(Ex("gridRef"), "");
  if (text.empty() || text == kLandRef) return std::nullopt;
  const std::size_t hash = text.find('#');
  const std::size_t at = text.find('@', hash == std::string::npos ? 0 : hash);
  GridRef ref;
  ref.file = text.substr(0, hash);
  if (hash != std::string::npos) {
    ref.variable = text.substr(hash + 1, at - hash - 1);
  }
  if (ref.file.empty() || ref.variable.empty()) {
    entity.Refuse(Ex("gridRef"),
                  "\"file#variable@step\", not \"" + text + "\"");
  }
  if (at != std::string::npos) {
    ref.time_index = ReadStep(entity, text.substr(at + 1));
  }
  return ref;
}

std::optional<RasterRef> ReadRasterRef(const FactEntity& entity) {
  const std::optional<GridRef> ref = ReadGridRef(entity);
  if (!ref) return std::nullopt;
  return RasterRef{FileIri(entity.iri()), ref->variable, ref->time_index,
                   ReadResampling(entity)};
}

ValueLayer ReadValueLayer(const WindowCalendar& calendar,
                          const FactEntity& entity) {
  ValueLayer layer;
  layer.iri = entity.iri();
  layer.window = calendar.FindWindow(entity);
  layer.kind = Choice(entity, Ex("kind"), kValueKinds, "");
  if (layer.kind.empty()) entity.Refuse(Ex("kind"), "a kind of value layer");
  layer.file_iri = entity.Follow(Prov("wasDerivedFrom")).iri();
  layer.time_index = entity.Integer(Ex("timeIndex"));
  layer.previous_time_index =
      entity.Integer(Ex("previousTimeIndex"), layer.time_index);
  // The difference of a step with itself would be 0 everywhere.
  if (layer.kind == kDifferenceKind &&
      layer.previous_time_index == layer.time_index) {
    entity.Refuse(Ex("previousTimeIndex"), "another step than ex:timeIndex");
  }
  layer.resampling = ReadResampling(entity);
  layer.time_s = entity.MaybeTime_s(
      kg_core::Iri(std::string(kg_core::kSosa) + "resultTime"));
  layer.full_scale = entity.MaybeNumber(Ex("fullScale"));
  layer.front_full_scale = entity.MaybeNumber(Ex("frontFullScale"));
  return layer;
}

WorkFieldRef ReadWorkField(const WindowCalendar& calendar,
                           const FactEntity& entity) {
  WorkFieldRef field;
  field.iri = entity.iri();
  field.window = calendar.FindWindow(entity);
  field.file_iri = entity.Follow(Prov("wasDerivedFrom")).iri();
  field.first_time_index = entity.Integer(Ex("firstTimeIndex"));
  field.last_time_index = entity.Integer(Ex("lastTimeIndex"));
  return field;
}

CostFieldRef ReadCostField(const WindowCalendar& calendar,
                           const FactEntity& entity) {
  CostFieldRef field;
  field.iri = entity.iri();
  field.window = calendar.FindWindow(entity);
  const kg_core::Term observed =
      kg_core::Iri(std::string(kg_core::kSosa) + "observedProperty");
  const std::optional<kg_core::Term> property = entity.One(observed);
  for (const SourceQuantity& quantity : CostQuantities()) {
    if (property == Ex(quantity.observed_property)) {
      field.quantity = quantity.name;
    }
  }
  if (field.quantity.empty()) {
    entity.Refuse(observed, "a quantity that costs, such as ex:waveHeight");
  }
  field.file_iri = entity.Follow(Prov("wasDerivedFrom")).iri();
  field.first_time_index = entity.Integer(Ex("firstTimeIndex"));
  field.last_time_index = entity.Integer(Ex("lastTimeIndex"));
  field.resampling = ReadResampling(entity);
  return field;
}

kg_core::SourceFile ReadSourceFile(const FactEntity& entity) {
  return {entity.iri(), entity.Text(Ex("path")), entity.Text(Ex("sha256"))};
}

}  // namespace kg_mission
