#include "kg_base/raster/cf_time.h"

#include <gtest/gtest.h>

#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

TEST(ParseCfTime, ReadsUsualUnitsAndEpochs) {
  struct Case {
    const char* units;
    double unit_s;
    const char* epoch;
  };
  const Case cases[] = {
      {"hours since 2000-01-01 00:00:00", 3600, "2000-01-01T00:00:00Z"},
      {"days since 1900-12-31", 86400, "1900-12-31T00:00:00Z"},
      {"seconds since 1970-01-01T00:00:00Z", 1, "1970-01-01T00:00:00Z"},
      {"Seconds since 1970-1-1 0:0:0.0", 1, "1970-01-01T00:00:00Z"},
      {"minutes since 1950-01-01 12:30 UTC", 60, "1950-01-01T12:30:00Z"},
      {"h since 2020-02-29 00:00:00 -06:00", 3600, "2020-02-29T06:00:00Z"},
      {"hours since 2020-02-29 00:00:00 +0530", 3600, "2020-02-28T18:30:00Z"},
      {"msec since 2000-03-01 00:00:00.5", 1e-3, "2000-03-01T00:00:00.5Z"},
  };
  for (const Case& c : cases) {
    const CfTime time = ParseCfTime(c.units, "standard");
    EXPECT_EQ(time.unit_s, c.unit_s) << c.units;
    EXPECT_EQ(time.epoch_s, ParseDateTime(c.epoch)) << c.units;
  }
}

TEST(ParseCfTime, AgreesWithTheDateOfEveryDayOfFourCenturies) {
  for (int year = 1583; year < 2100; ++year) {
    for (int month = 1; month <= 12; ++month) {
      char date[40];
      snprintf(date, sizeof(date), "%04d-%02d-15", year, month);
      EXPECT_EQ(ParseCfTime(std::string("days since ") + date, "").epoch_s,
                ParseDateTime(std::string(date) + "T00:00:00Z"));
    }
  }
}

// CF-1.8, 4.4.1: the standard calendar is Julian before 1582-10-15, so that
// 0001-01-01 is two days earlier than in the proleptic one.
TEST(ParseCfTime, TellsTheStandardFromTheProlepticCalendar) {
  const std::string units = "days since 0001-01-01";
  const double standard = ParseCfTime(units, "gregorian").epoch_s;
  const double proleptic = ParseCfTime(units, "proleptic_gregorian").epoch_s;
  EXPECT_EQ(proleptic, -719162.0 * 86400.0);
  EXPECT_EQ(proleptic - standard, 2.0 * 86400.0);
  EXPECT_EQ(ParseCfTime("days since 1582-10-15", "").epoch_s -
                ParseCfTime("days since 1582-10-4", "").epoch_s,
            86400.0);
}

// Only the Julian calendar has a leap day in 1500.
TEST(ParseCfTime, KnowsTheLeapDaysOfBothCalendars) {
  const std::string units = "days since 1500-02-29";
  EXPECT_THROW(ParseCfTime(units, "proleptic_gregorian"), InputError);
  EXPECT_EQ(ParseCfTime("days since 1500-03-01", "").epoch_s -
                ParseCfTime(units, "").epoch_s,
            86400.0);
}

TEST(ParseCfTime, RefusesWhatHasNoFixedLengthOrNoSense) {
  for (const char* units :
       {"", "hours", "months since 2000-01-01", "years since 2000-01-01",
        "hours since", "hours since 2000-13-01", "hours since 2000-00-01",
        "hours since 2000-01-32", "hours since 2001-02-29",
        "hours since 2000-04-31", "hours since 1501-02-29",
        "hours since 2000-01-01 25:00", "day as %Y%m%d.%f",
        "hours since 2000-01-01 00:00:00 EST", "hours since yesterday"}) {
    EXPECT_THROW(ParseCfTime(units, ""), InputError) << units;
  }
  EXPECT_THROW(ParseCfTime("d since 2000-01-01", "360_day"), InputError);
  EXPECT_THROW(ParseCfTime(std::string(100000, 'h'), ""), InputError);
}

}  // namespace
}  // namespace kg_base
