#include "kg_core/mission/ingest.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kg_core/base/clock.h"
#include "kg_core/base/date_time.h"
#include "kg_core/base/input_error.h"
#include "kg_core/geo/geodesy.h"
#include "kg_core/mission/class_tree.h"
#include "kg_core/mission/conclusions.h"
#include "kg_core/mission/entity.h"
#include "kg_core/mission/ingest_times.h"
#include "kg_core/mission/ingested_facts.h"
#include "kg_core/mission/layer_files.h"
#include "kg_core/mission/layer_reader.h"
#include "kg_core/mission/mission_reader.h"
#include "kg_core/mission/terms.h"
#include "kg_core/mission/validator.h"
#include "kg_core/mission/vocabulary.h"
#include "kg_core/rules/inference.h"

namespace kg_core {
namespace {

Term TimeLiteral(double time_s) {
  return Literal(FormatDateTime(time_s), std::string(kXsd) + "dateTime");
}

// Of one sampled field: what rules and shapes can still go through in seconds.
constexpr std::size_t kMaxSamples = 10000;

bool HasData(const Raster& raster) {
  const auto is_number = [](float value) { return std::isfinite(value); };
  return std::any_of(raster.begin(), raster.end(), is_number);
}

bool HasData(const QuantitySeries& series) {
  return std::any_of(series.at_time.begin(), series.at_time.end(),
                     [](const Raster& raster) { return HasData(raster); });
}

std::string BoxWkt(const Grid& grid) {
  const std::string west = DoubleLiteral(grid.west_deg()).text;
  const std::string east = DoubleLiteral(grid.east_deg()).text;
  const std::string south = DoubleLiteral(grid.south_deg()).text;
  const std::string north = DoubleLiteral(grid.north_deg()).text;
  return "POLYGON((" + west + " " + south + ", " + east + " " + south + ", " +
         east + " " + north + ", " + west + " " + north + ", " + west + " " +
         south + "))";
}

double MeanRowKm(const Grid& grid) {
  const double lon_deg = grid.Middle().lon_deg;
  return Distance_m({lon_deg, grid.south_deg()}, {lon_deg, grid.north_deg()}) /
         grid.rows() / 1000.0;
}

// The ingest of one data source: what it read and what it states.
class SourceIngest {
 public:
  SourceIngest(const Entity& source, const Mission& mission,
               Transaction& transaction)
      : source_(source),
        name_(source.subject()),
        mission_(mission),
        transaction_(transaction),
        started_s_(Now_s()) {}

  void StateCurrents(const FieldFile& file) {
    RequireData(file);
    StateFile(file);
    StateGrid(Ex("grid"), file.grid);
    for (const TimeWindow& window : mission_.windows) {
      StateField(file, window, StepsOfField(file.time_s, window));
    }
    StateActivity();
  }

  // `field_grid`: that of the currents, if there are any.
  void StateTemperature(const FieldFile& file, const Grid* field_grid) {
    RequireData(file);
    StateFile(file);
    const Term grid = StateGridUnlessSame(file.grid, field_grid);
    for (const TimeWindow& window : mission_.windows) {
      const Term layer = Part("w" + std::to_string(window.index));
      StateLayer(file, window, layer);
      Say(layer, Ex("onGrid"), grid);
      for (const char* name : {"resampling", "fullScale", "frontFullScale"}) {
        const std::optional<Term> said = source_.One(Ex(name));
        if (said) Say(layer, Ex(name), *said);
      }
    }
    StateActivity();
  }

  // What a prior layer or a constraint names by ex:gridRef.
  void StateRaster(const FieldFile& file, const GridRef& ref,
                   const Grid* field_grid) {
    StepOf(file, ref);
    StateFile(file);
    StateGridUnlessSame(file.grid, field_grid);
    StateActivity();
  }

  // Cells of a field above a limit, one fact each: what rules make events of.
  // On the file's own grid, which need not be the mission's.
  void StateSamples(const FieldFile& file, const GridRef& ref, double above) {
    const Raster& values = StepOf(file, ref);
    StateFile(file);
    std::size_t count = 0;
    for (int row = 0; row < file.grid.rows(); ++row) {
      for (int col = 0; col < file.grid.cols(); ++col) {
        const double value = values[file.grid.Index({row, col})];
        if (!(value > above)) continue;  // No data (NaN) is not above.
        if (++count > kMaxSamples) {
          throw InputError("expected at most " + std::to_string(kMaxSamples) +
                           " cells above ex:sampleAbove");
        }
        StateSample(file.grid, {row, col}, value);
      }
    }
    StateActivity();
  }

 private:
  Term Part(const std::string& name) const {
    return Iri(name_.text + "/" + name);
  }

  void Say(const Term& subject, const Term& property, const Term& object) {
    transaction_.Add({subject, property, object, Facts()});
  }
  void SayProv(const Term& subject, const Term& property, const Term& object) {
    transaction_.Add({subject, property, object, Iri(kProvGraph)});
  }

  // Throws InputError where the file has no such step or no data in it.
  static const Raster& StepOf(const FieldFile& file, const GridRef& ref) {
    const std::vector<Raster>& steps = file.series[0].at_time;
    if (!(ref.time_index < static_cast<int>(steps.size()))) {
      throw InputError(
          "variable " + ref.variable + " has " + std::to_string(steps.size()) +
          " time steps, none with index " + std::to_string(ref.time_index));
    }
    const Raster& step = steps[ref.time_index];
    if (!HasData(step)) {
      throw InputError("variable " + ref.variable + " has no data in step " +
                       std::to_string(ref.time_index));
    }
    return step;
  }

  void StateSample(const Grid& grid, Cell cell, double value) {
    const Term sample = Part("cell/" + std::to_string(cell.row) + "_" +
                             std::to_string(cell.col));
    Generate(sample, "CellSample");
    Say(sample, GeoTerm("asWKT"), WktLiteral(PointWkt(grid.Centre(cell))));
    Say(sample, Ex("cellValue"), DoubleLiteral(value));
  }

  static void RequireData(const FieldFile& file) {
    for (const QuantitySeries& series : file.series) {
      if (HasData(series)) continue;
      throw InputError("variable " + series.variable +
                       " has no data in any cell: expected some");
    }
  }

  // Its name.
  Term StateGridUnlessSame(const Grid& grid, const Grid* field_grid) {
    if (field_grid) {
      CheckGrids(name_.text, grid, *field_grid, ReadResampling(source_));
      if (grid.AlmostEquals(*field_grid)) return Ex("grid");
    }
    StateGrid(Part("grid"), grid);
    return Part("grid");
  }

  void Generate(const Term& entity, const char* type) {
    Say(entity, RdfType(), Ex(type));
    Say(entity, Ex("ingestedFrom"), name_);
    generated_.push_back(entity);
  }

  void StateFile(const FieldFile& file) {
    Say(Part("file"), RdfType(), Ex("SourceFile"));
    Say(Part("file"), Ex("ingestedFrom"), name_);
    Say(Part("file"), Ex("path"), Literal(file.path));
    Say(Part("file"), Ex("sha256"), Literal(file.sha256));
  }

  void StateGrid(const Term& subject, const Grid& grid) {
    Generate(subject, "GridSpec");
    Say(subject, Ex("rows"), IntegerLiteral(grid.rows()));
    Say(subject, Ex("cols"), IntegerLiteral(grid.cols()));
    Say(subject, GeoTerm("asWKT"), WktLiteral(BoxWkt(grid)));
    Say(subject, Ex("pixelSizeKm"), DoubleLiteral(MeanRowKm(grid)));
    Say(subject, Prov("wasDerivedFrom"), Part("file"));
  }

  void StateField(const FieldFile& file, const TimeWindow& window,
                  StepRange steps) {
    const Term field = Part("w" + std::to_string(window.index));
    const std::string at =
        "@" + std::to_string(steps.first) + ".." + std::to_string(steps.last);
    const bool wind = IsWind(file.series[0]);
    Generate(field, wind ? "WorkField" : "CurrentField");
    Say(field, Ex("forWindow"), Iri(window.iri));
    Say(field, Ex("gridRefU"),
        Literal(file.path + "#" + file.series[0].variable + at));
    Say(field, Ex("gridRefV"),
        Literal(file.path + "#" + file.series[1].variable + at));
    Say(field, Ex("firstTimeIndex"), IntegerLiteral(steps.first));
    Say(field, Ex("lastTimeIndex"), IntegerLiteral(steps.last));
    Say(field, Ex("onGrid"), Ex("grid"));
    Say(field, Iri(std::string(kSosa) + "observedProperty"),
        Ex(wind ? "windVelocity" : "seaWaterVelocity"));
    Say(field, Prov("wasDerivedFrom"), Part("file"));
  }

  std::string Kind() const { return source_.Text(Ex("kind"), kDifferenceKind); }

  StepPair StepsOfLayer(const FieldFile& file, const TimeWindow& window) const {
    if (Kind() == kDifferenceKind)
      return StepsOfDifference(file.time_s, window);
    const int step = StepOfWindow(file.time_s, window);
    return {step, step};
  }

  void StateLayer(const FieldFile& file, const TimeWindow& window,
                  const Term& layer) {
    const StepPair steps = StepsOfLayer(file, window);
    Generate(layer, "ValueLayer");
    Say(layer, Ex("forWindow"), Iri(window.iri));
    Say(layer, Ex("kind"), Literal(Kind()));
    Say(layer, Ex("timeIndex"), IntegerLiteral(steps.step));
    Say(layer, Iri(std::string(kSosa) + "resultTime"),
        TimeLiteral(file.time_s.at(steps.step)));
    std::string at = "@" + std::to_string(steps.step);
    if (steps.previous != steps.step) {
      Say(layer, Ex("previousTimeIndex"), IntegerLiteral(steps.previous));
      at += "," + std::to_string(steps.previous);
    }
    Say(layer, Ex("gridRef"),
        Literal(file.path + "#" + file.series[0].variable + at));
    Say(layer, Prov("wasDerivedFrom"), Part("file"));
  }

  void StateActivity() {
    const auto number =
        static_cast<long long>(transaction_.view().world_version() + 1);
    const std::string version = std::to_string(number);
    const std::string name =
        name_.text.substr(name_.text.find_last_of("/#") + 1);
    const Term activity =
        Iri(kProvGraph + ("/ingest/v" + version + "/" + name));
    SayProv(activity, RdfType(), Ex("Ingest"));
    SayProv(activity, RdfType(), Prov("Activity"));
    SayProv(activity, Prov("startedAtTime"), TimeLiteral(started_s_));
    SayProv(activity, Prov("endedAtTime"), TimeLiteral(Now_s()));
    SayProv(activity, Ex("worldVersion"), IntegerLiteral(number));
    SayProv(activity, Prov("used"), name_);
    SayProv(activity, Prov("used"), Part("file"));
    for (const Term& entity : generated_) {
      SayProv(activity, Prov("generated"), entity);
      SayProv(entity, Prov("wasGeneratedBy"), activity);
    }
  }

  const Entity source_;
  const Term name_;
  const Mission& mission_;
  Transaction& transaction_;
  const double started_s_;
  std::vector<Term> generated_;
};

// All data sources, those of currents or wind first: their grid is the
// mission's. Then the rasters of priors and constraints.
class Ingest {
 public:
  Ingest(FileCache& cache, Transaction& transaction)
      : cache_(cache),
        transaction_(transaction),
        mission_(ReadMission(transaction.view())) {}

  std::vector<std::string> Run() {
    ForEach("current", &Ingest::ReadCurrents);
    ForEach("wind", &Ingest::ReadCurrents);
    ForEach("temperature", &Ingest::ReadTemperature);
    ForAll("PriorLayer", &Ingest::ReadRaster);
    ForAll("Constraint", &Ingest::ReadRaster);
    ForAll("SampledField", &Ingest::ReadSamples);
    return std::move(reasons_);
  }

 private:
  void ForEach(const std::string& provides,
               void (Ingest::*read)(const Entity&)) {
    for (const Term& term :
         InstancesOf(transaction_.view(), kFactsGraph, Ex("DataSource"))) {
      const Entity source(transaction_.view(), term);
      if (source.Text(Ex("provides")) == provides) Try(source, read);
    }
  }

  void ForAll(const char* type, void (Ingest::*read)(const Entity&)) {
    for (const Term& term :
         InstancesOf(transaction_.view(), kFactsGraph, Ex(type))) {
      Try(Entity(transaction_.view(), term), read);
    }
  }

  void Try(const Entity& source, void (Ingest::*read)(const Entity&)) {
    try {
      (this->*read)(source);
    } catch (const InputError& error) {
      reasons_.push_back(ToTurtle(source.subject()) + ": " + file_ +
                         error.what());
    }
    file_.clear();
  }

  const FieldFile& Open(const Entity& source,
                        const std::vector<FieldQuantity>& wanted) {
    const std::string path = cache_.Resolve(source.Text(Ex("file")));
    return Keep(path, cache_.Read(path, wanted));
  }

  const FieldFile& Keep(const std::string& path,
                        std::shared_ptr<const FieldFile> file) {
    open_.push_back(std::move(file));
    file_ = path + ": ";  // For reasons that come after the reading.
    return *open_.back();
  }

  void ReadCurrents(const Entity& source) {
    const FieldFile& file = Open(source, {FieldQuantity::kEastwardVelocity,
                                          FieldQuantity::kNorthwardVelocity});
    if (field_grid_ != nullptr) {
      source.Refuse(Ex("provides"),
                    "one source of \"current\" or \"wind\", not two");
    }
    CheckMedium(source.Text(Ex("provides")) == "wind", file.series.front());
    field_grid_ = &file.grid;
    SourceIngest(source, mission_, transaction_).StateCurrents(file);
  }

  static void CheckMedium(bool wind, const QuantitySeries& east) {
    if (wind == IsWind(east)) return;
    throw InputError("variable " + east.variable + " has standard_name \"" +
                     east.standard_name + "\": expected eastward_wind where " +
                     "ex:provides is \"wind\", and only there");
  }

  void ReadTemperature(const Entity& source) {
    const FieldFile& file = Open(source, {FieldQuantity::kTemperature});
    SourceIngest(source, mission_, transaction_)
        .StateTemperature(file, field_grid_);
  }

  void ReadRaster(const Entity& layer) {
    const std::optional<GridRef> ref = ReadGridRef(layer);
    if (!ref) return;
    const std::string path = cache_.Resolve(ref->file);
    const FieldFile& file =
        Keep(path, cache_.ReadVariable(path, ref->variable));
    SourceIngest(layer, mission_, transaction_)
        .StateRaster(file, *ref, field_grid_);
  }

  void ReadSamples(const Entity& field) {
    const std::optional<GridRef> ref = ReadGridRef(field);
    if (!ref) field.Refuse(Ex("gridRef"), "a raster");
    const std::string path = cache_.Resolve(ref->file);
    const FieldFile& file =
        Keep(path, cache_.ReadVariable(path, ref->variable));
    SourceIngest(field, mission_, transaction_)
        .StateSamples(file, *ref, field.Number(Ex("sampleAbove")));
  }

  FileCache& cache_;
  Transaction& transaction_;
  const Mission mission_;
  const Grid* field_grid_ = nullptr;
  std::string file_;
  std::vector<std::shared_ptr<const FieldFile>> open_;
  std::vector<std::string> reasons_;
};

}  // namespace

std::vector<std::string> StageIngest(FileCache& cache,
                                     Transaction& transaction) {
  DropIngestedFacts(transaction);
  try {
    std::vector<std::string> reasons = Ingest(cache, transaction).Run();
    if (reasons.empty()) reasons = StageInferences(transaction);
    if (reasons.empty()) reasons = Lines(ValidateChange(transaction));
    if (!reasons.empty()) return reasons;
    const GraphView& view = transaction.view();
    return CheckConclusions(Vocabulary(view), view);
  } catch (const InputError& error) {
    return {error.what()};
  }
}

StagedUpdate StageUpdateWithFiles(const FactUpdate& update, FileCache& cache,
                                  Transaction& transaction) {
  StagedUpdate staged;
  staged.judgement = JudgeUpdate(update, transaction);
  std::vector<std::string>& reasons = staged.judgement.reasons;
  if (!reasons.empty() || !IngestIsDue(transaction)) return staged;
  const double begin_s = Now_s();
  reasons = StageIngest(cache, transaction);
  staged.ingest_s = Now_s() - begin_s;
  return staged;
}

}  // namespace kg_core
