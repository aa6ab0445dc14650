#include "kg_base/raster/field_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kg_base/raster/testing/made_file.h"

namespace kg_base {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kBegin_s = 1604188800.0;  // 2020-11-01T00:00Z.
constexpr double kHour_s = 3600.0;
const std::vector<double> kStill(15, 0.1);

// Currents of one time, with further scalars, all in hours since the begin.
struct ScalarTime {
  std::string name;
  double hours;
  AttributeTexts texts;
};
MadeFile& WriteScalars(MadeFile& file, const std::vector<ScalarTime>& times,
                       const AttributeTexts& more = {}) {
  for (ScalarTime time : times) {
    time.texts.emplace("units", "hours since 2020-11-01 00:00:00");
    file.Put(time.name, {}, {time.hours}, time.texts);
  }
  file.Box();
  file.Currents({"lat", "lon"}, kStill, more);
  return file;
}

TEST(ReadFieldTimes, TakesTheValidTimeWhateverStandsBefore) {
  const ScalarTime time{"time", 120, {{"standard_name", "time"}}};
  const std::vector<ScalarTime> others = {
      {"forecast_reference_time",
       0,
       {{"standard_name", "forecast_reference_time"}}},
      {"a", 0, {{"standard_name", "forecast_reference_time"}}},
      {"reftime", 0, {}},
      {"analysis", 0, {{"long_name", "Analysis time"}}},
      {"b", 0, {{"long_name", "reference time of the model"}}},
      {"tau", 5, {{"units", "hours since analysis"}}},
      {"step", 5, {{"units", "hours since start of forecast"}}},
      {"forecast_period", 5, {{"standard_name", "forecast_period"}}},
  };
  for (const ScalarTime& other : others) {
    for (const bool is_first : {true, false}) {
      SCOPED_TRACE(other.name);
      MadeFile file;
      WriteScalars(file, is_first ? std::vector<ScalarTime>{other, time}
                                  : std::vector<ScalarTime>{time, other});
      EXPECT_THAT(file.Read().time_s, ElementsAre(kBegin_s + 120 * kHour_s));
    }
  }
}

TEST(ReadFieldTimes, TakesTheListedOneOfSeveralAndRefusesWhenNoneIsClearer) {
  const std::vector<ScalarTime> both = {{"day1", 1, {}}, {"day2", 2, {}}};
  MadeFile listed;
  WriteScalars(listed, both, {{"coordinates", "day2 lon lat"}});
  EXPECT_THAT(listed.Read().time_s, ElementsAre(kBegin_s + 2 * kHour_s));
  MadeFile unclear;
  EXPECT_THAT(WriteScalars(unclear, both).Refusal(),
              HasSubstr("its time could be day1 or day2"));
}

TEST(ReadFieldTimes, RefusesAFileThatHasOnlyAReferenceTime) {
  MadeFile file;
  const std::string error =
      WriteScalars(file,
                   {{"run", 0, {{"standard_name", "forecast_reference_time"}}}})
          .Refusal();
  EXPECT_THAT(error, HasSubstr("expected a time"));
  EXPECT_THAT(error, HasSubstr("run is a reference or lead time"));
}

TEST(ReadFieldTimes, TakesTheValidTimeOfADimensionThatHasSeveral) {
  MadeFile file;
  file.Axis("step", {3, 9},
            {{"standard_name", "forecast_period"}, {"units", "hours"}});
  file.Put("reference", {"step"}, {0, 0},
           {{"standard_name", "forecast_reference_time"},
            {"units", "hours since 2020-11-01"}});
  file.Put("when", {"step"}, {27, 33},
           {{"standard_name", "time"}, {"units", "hours since 2020-10-31"}});
  file.Box();
  file.Currents({"step", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2}));
  EXPECT_THAT(file.Read().time_s,
              ElementsAre(kBegin_s + 3 * kHour_s, kBegin_s + 9 * kHour_s));
}

TEST(ReadFieldTimes, RefusesADimensionOfLeadTimesOnly) {
  MadeFile file;
  file.Axis("step", {3, 9},
            {{"standard_name", "forecast_period"}, {"units", "hours"}});
  file.Put("time", {}, {0},
           {{"standard_name", "time"}, {"units", "hours since 2020-10-31"}});
  file.Box();
  file.Currents({"step", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2}));
  EXPECT_THAT(file.Refusal(), HasSubstr("variable step: is a reference or "
                                        "lead time"));
}

// Means of six hours whose stamps are at the given share of their period.
FieldFile ReadMeans(double share, const AttributeTexts& texts) {
  MadeFile file;
  file.Dimension("bnds", 2);
  file.Times({0 + 6 * share, 6 + 6 * share, 12 + 6 * share},
             {{"bounds", "time_bnds"}});
  file.Put("time_bnds", {"time", "bnds"}, {0, 6, 6, 12, 12, 18});
  file.Box();
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2, 0.3}),
                texts);
  return file.Read();
}

TEST(ReadFieldTimes, PutsMeansInTheMiddleOfTheirPeriods) {
  for (const double share : {0.0, 0.5, 1.0}) {
    for (const AttributeTexts& texts :
         {AttributeTexts{{"cell_methods", "time: mean"}},
          AttributeTexts{{"cell_methods", "area: mean time: mean"}},
          AttributeTexts{{"cell_methods", "time: lat: maximum"}},
          AttributeTexts{}}) {
      const FieldFile file = ReadMeans(share, texts);
      EXPECT_THAT(file.time_s,
                  ElementsAre(kBegin_s + 3 * kHour_s, kBegin_s + 9 * kHour_s,
                              kBegin_s + 15 * kHour_s));
      EXPECT_EQ(WarningsOf(file).find("in their middles") == std::string::npos,
                share == 0.5);
    }
  }
}

TEST(ReadFieldTimes, LeavesPointsInTimeWhereTheyAre) {
  const FieldFile file = ReadMeans(0.0, {{"cell_methods", "time: point"}});
  EXPECT_THAT(file.time_s, ElementsAre(kBegin_s, kBegin_s + 6 * kHour_s,
                                       kBegin_s + 12 * kHour_s));
}

TEST(ReadFieldTimes, SaysThatThePeriodOfAMeanIsUnknown) {
  MadeFile file;
  file.Times();
  file.Box();
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2, 0.3}),
                {{"cell_methods", "time: mean"}});
  const FieldFile read = file.Read();
  EXPECT_EQ(read.time_s.front(), kBegin_s);
  EXPECT_THAT(WarningsOf(read), HasSubstr("taken to hold at their stamps"));
}

TEST(ReadFieldTimes, SaysThatValuesAreAClimatology) {
  MadeFile file;
  file.Times({0, 6}, {{"climatology", "climatology_bounds"}});
  file.Box();
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2}),
                {{"cell_methods",
                  "time: mean within days time: mean over "
                  "years"}});
  const FieldFile read = file.Read();
  EXPECT_EQ(read.time_s.front(), kBegin_s);
  EXPECT_THAT(WarningsOf(read), HasSubstr("values are a climatology"));
}

TEST(ReadFieldTimes, ReadsMicrosecondsAndRefusesDatesThatAreNone) {
  MadeFile file;
  file.Axis("time", {0, 6 * 3600e6},
            {{"units", "microseconds since 2020-11-01"}});
  file.Box();
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2}));
  EXPECT_THAT(file.Read().time_s,
              ElementsAre(kBegin_s, kBegin_s + 6 * kHour_s));
  MadeFile wrong;
  wrong.Axis("time", {0, 6}, {{"units", "hours since 2020-02-30"}});
  wrong.Box();
  wrong.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2}));
  EXPECT_THAT(wrong.Refusal(), HasSubstr("2020-02-30"));
}

// Currents of these hours, whose value is a tenth of the index in the file;
// with or without chunks that hold several times.
FieldFile ReadOrder(const std::vector<double>& hours, std::size_t chunk) {
  MadeFile file;
  file.Times(hours);
  file.Box();
  std::vector<double> at_index;
  for (std::size_t i = 0; i < hours.size(); ++i) at_index.push_back(0.1 * i);
  const std::vector<double> values = MadeFile::Repeated(at_index);
  if (chunk > 0) {
    file.ChunkedCurrents({"time", "lat", "lon"}, values, {chunk, 3, 5});
  } else {
    file.Currents({"time", "lat", "lon"}, values);
  }
  return file.Read();
}

// The index in the file of each time that was read.
std::vector<int> Order(const FieldFile& file) {
  std::vector<int> order;
  for (const Raster& raster : file.series[0].at_time) {
    order.push_back(static_cast<int>(std::lround(10 * raster[7])));
  }
  return order;
}

TEST(ReadFieldTimes, ReadsTimesInAnyOrderAndOfEqualOnesTheLast) {
  struct Case {
    std::vector<double> hours;
    std::vector<int> order;
    std::vector<double> read;
    const char* warning;
  };
  const std::vector<Case> cases = {
      {{18, 12, 6, 0}, {3, 2, 1, 0}, {0, 6, 12, 18}, ""},
      {{0, 6, 6, 12}, {0, 2, 3}, {0, 6, 12}, "2020-11-01T06:00:00Z"},
      {{12, 6, 6, 6, 0}, {4, 3, 0}, {0, 6, 12}, "2 times are there more"},
      // A run of a model that was appended to an earlier one.
      {{0, 6, 12, 18, 12, 18, 24},
       {0, 1, 4, 5, 6},
       {0, 6, 12, 18, 24},
       "neither ascend nor descend: sorted"},
  };
  for (const Case& c : cases) {
    for (const std::size_t chunk : {0u, 1u, 2u, 3u}) {
      const FieldFile file = ReadOrder(c.hours, chunk);
      EXPECT_EQ(Order(file), c.order);
      ASSERT_EQ(file.time_s.size(), c.read.size());
      for (std::size_t i = 0; i < c.read.size(); ++i) {
        EXPECT_EQ(file.time_s[i], kBegin_s + c.read[i] * kHour_s);
      }
      EXPECT_THAT(WarningsOf(file), HasSubstr(c.warning));
      EXPECT_EQ(WarningsOf(file).empty(), std::string(c.warning).empty());
    }
  }
}

TEST(ReadFieldTimes, LeavesAVariableInTheOrderThatItsIndicesMean) {
  MadeFile file;
  file.Times({12, 6, 6, 0});
  file.Box();
  file.Put("mask", {"time", "lat", "lon"},
           MadeFile::Repeated({0, 0.1, 0.2, 0.3}));
  EXPECT_EQ(Order(file.ReadNamed("mask")), (std::vector<int>{0, 1, 2, 3}));
}

TEST(ReadFieldTimes, ReportsWhenAForecastWasMade) {
  MadeFile file;
  WriteScalars(file,
               {{"time", 120, {{"standard_name", "time"}}},
                {"run", 96, {{"standard_name", "forecast_reference_time"}}}});
  const FieldFile read = file.Read();
  EXPECT_EQ(read.series[0].report.issue_time_s, kBegin_s + 96 * kHour_s);
  MadeFile without;
  WriteScalars(without, {{"time", 120, {}}});
  EXPECT_TRUE(std::isnan(without.Read().series[0].report.issue_time_s));
}

TEST(ReadFieldTimes, RefusesATimeThatIsAFill) {
  MadeFile file;
  file.Times({0, -9999, 12}, {{"missing_value", "-9999"}});
  file.Box();
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1, 0.2, 0.3}));
  EXPECT_THAT(file.Refusal(), HasSubstr("time: value 1 is missing"));
}

}  // namespace
}  // namespace kg_base
