#include "kg_base/common/date_time.h"

#include <time.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

TEST(DateTime, ReadsTheExamplesOfTheHeader) {
  EXPECT_EQ(ParseDateTime("2026-03-01T06:00:00-06:00"), 1772366400.0);
  EXPECT_EQ(ParseDuration("P1DT2H30M"), 95400.0);
}

// The C library is the independent implementation.
TEST(DateTime, AgreesWithTheCLibrary) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const time_t seconds =
        static_cast<time_t>(random() % 315000000000ull) - 62000000000ll;
    if (seconds >= 253402300799ll) continue;
    tm parts;
    gmtime_r(&seconds, &parts);
    char text[64];
    std::snprintf(text, sizeof(text), "%04d-%02d-%02dT%02d:%02d:%02dZ",
                  parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                  parts.tm_hour, parts.tm_min, parts.tm_sec);
    ASSERT_EQ(ParseDateTime(text), static_cast<double>(seconds)) << text;
    ASSERT_EQ(FormatDateTime(static_cast<double>(seconds)), text);
  }
}

TEST(DateTime, ReadsBackWhatItWritesToTheMicrosecond) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 20000; ++i) {
    const double unix_s =
        static_cast<double>(random() % 4000000000000000) * 1e-6;
    ASSERT_NEAR(ParseDateTime(FormatDateTime(unix_s)), unix_s, 1.1e-6);
  }
  EXPECT_EQ(FormatDateTime(0.25), "1970-01-01T00:00:00.25Z");
  EXPECT_EQ(FormatDateTime(-0.25), "1969-12-31T23:59:59.75Z");
  EXPECT_EQ(FormatDateTime(59.9999999), "1970-01-01T00:01:00Z");
  EXPECT_EQ(FormatDateTime(10.0), "1970-01-01T00:00:10Z");
}

TEST(DateTime, KnowsZonesFractionsAndTheEndOfTheDay) {
  EXPECT_EQ(ParseDateTime("1970-01-01T00:00:00"), 0.0);
  EXPECT_EQ(ParseDateTime("1970-01-01T05:30:00+05:30"), 0.0);
  EXPECT_EQ(ParseDateTime("1969-12-31T10:00:00-14:00"), 0.0);
  EXPECT_EQ(ParseDateTime("1969-12-31T24:00:00Z"), 0.0);
  EXPECT_EQ(ParseDateTime("1970-01-01T00:00:00.125Z"), 0.125);
  EXPECT_EQ(ParseDateTime("2024-02-29T00:00:00Z"), 1709164800.0);
  EXPECT_EQ(ParseDateTime("0000-01-01T00:00:00Z"), -62167219200.0);
  EXPECT_EQ(ParseDateTime("-0001-12-31T00:00:00Z"), -62167305600.0);
  EXPECT_EQ(ParseDateTime("12026-01-01T00:00:00Z"), 317336745600.0);
}

TEST(DateTime, RefusesWhatIsNoDateTime) {
  for (const char* text : {"",
                           "2026-03-01",
                           "2026-03-01T12:00Z",
                           "2026-3-1T12:00:00Z",
                           "2026-02-29T00:00:00Z",
                           "1900-02-29T00:00:00Z",
                           "2026-13-01T00:00:00Z",
                           "2026-00-01T00:00:00Z",
                           "2026-01-00T00:00:00Z",
                           "2026-01-01T25:00:00Z",
                           "2026-01-01T24:00:01Z",
                           "2026-01-01T24:00:00.5Z",
                           "2026-01-01T00:60:00Z",
                           "2026-01-01T00:00:60Z",
                           "2026-01-01T00:00:00.Z",
                           "2026-01-01T00:00:00z",
                           "2026-01-01T00:00:00+14:01",
                           "2026-01-01T00:00:00+1:00",
                           "2026-01-01T00:00:00Z ",
                           " 2026-01-01T00:00:00Z",
                           "02026-01-01T00:00:00Z",
                           "9999999999-01-01T00:00:00Z",
                           "+2026-01-01T00:00:00Z",
                           "2026-01-01 00:00:00Z",
                           "now"}) {
    EXPECT_THROW(ParseDateTime(text), InputError) << text;
  }
}

TEST(DateTime, FormatsOnlyTimesOfFourDigitYears) {
  for (const double unix_s :
       {std::nan(""), HUGE_VAL, -HUGE_VAL, 253402300800.0, -62167219200.5}) {
    EXPECT_THROW(FormatDateTime(unix_s), std::invalid_argument) << unix_s;
  }
}

TEST(Calendars, CountEveryDayOnce) {
  std::int64_t gregorian = DaysFromCivil(-9, 1, 1);
  std::int64_t julian = DaysFromJulian(-9, 1, 1);
  for (int year = -9; year < 2110; ++year) {
    for (int month = 1; month <= 12; ++month) {
      ASSERT_EQ(DaysFromCivil(year, month, 1), gregorian) << year << month;
      ASSERT_EQ(DaysFromJulian(year, month, 1), julian) << year << month;
      gregorian += DaysInMonth(year, month);
      julian += DaysInJulianMonth(year, month);
    }
  }
}

// The reform of 1582 skipped ten days; day 0 of the Julian day numbers is at
// noon of -4712-01-01.
TEST(Calendars, MeetAtKnownDates) {
  EXPECT_EQ(DaysFromJulian(1582, 10, 5), DaysFromCivil(1582, 10, 15));
  EXPECT_EQ(DaysFromJulian(1900, 2, 29), DaysFromCivil(1900, 3, 13));
  EXPECT_EQ(DaysFromJulian(-4712, 1, 1), -2440588);
}

TEST(Duration, AddsItsParts) {
  EXPECT_EQ(ParseDuration("PT0S"), 0.0);
  EXPECT_EQ(ParseDuration("P7D"), 604800.0);
  EXPECT_EQ(ParseDuration("PT90M"), 5400.0);
  EXPECT_EQ(ParseDuration("-PT1H"), -3600.0);
  EXPECT_EQ(ParseDuration("PT1.5S"), 1.5);
  EXPECT_EQ(ParseDuration("P1DT1H1M1S"), 90061.0);
}

TEST(Duration, RefusesWhatHasNoFixedLengthOrNoForm) {
  for (const char* text :
       {"",      "P",   "PT",   "1D",     "P1Y",    "P1M",    "P1Y2M3D",
        "P1DT",  "P1H", "PT1D", "PT1S1M", "PT1M1M", "PT1.5M", "PT.5S",
        "PT1.S", "PT1", "P-1D", "P1D ",   "PD",     "+P1D"}) {
    EXPECT_THROW(ParseDuration(text), InputError) << text;
  }
}

}  // namespace
}  // namespace kg_base
