#include "kg_base/raster/field_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace kg_base
