#include "kg_base/geo/wkt_parser.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

// The error text, or "read" if there is none.
std::string ErrorOf(const std::string& text) {
  try {
    ParseWkt(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

struct Case {
  const char* text;
  const char* error;
};

TEST(ParseWkt, RefusesAReferenceSystemInOneLineWhateverItsName) {
  const std::string error = ErrorOf("<http://a\nb\x01> POINT(22 -97)");
  EXPECT_NE(error.find("<http://a b >"), std::string::npos) << error;
}

TEST(ParseWkt, SaysWhereAndWhatWasExpected) {
  const Case cases[] = {
      {"", "character 1: expected a geometry"},
      {"CIRCLE(0 0, 1)", "character 1: expected a geometry"},
      {"SRID=32614;POINT(1 2)", "character 1: expected SRID=4326"},
      {"SRID=;POINT(1 2)", "character 6: expected the number"},
      {"SRID=4326 POINT(1 2)", "character 11: expected ';'"},
      {"SRID=4326;POINT(1 2 3 4)", "character 23: expected ',' or ')'"},
      {"POINT(nan 2)",
       "character 7: expected a longitude in [-360, 360], "
       "found \"nan 2)\""},
      {"POINT(1 inf)", "character 9: expected a latitude in [-90, 90]"},
      {"POINT(1e400 2)", "character 7: expected a longitude"},
      {"POINT(1 -1e400)", "character 9: expected a latitude"},
      {"POINT(0x10 2)", "character 8: expected a latitude"},
      {"POINT(1 91)", "character 9: expected a latitude in [-90, 90]"},
      {"POINT(-361 2)", "character 7: expected a longitude in [-360, 360]"},
      {"POINT(1)", "character 8: expected a latitude"},
      {"POINT(1 2 3)", "character 11: expected ',' or ')' after"},
      {"POINT Z (1 2)", "character 13: expected a height"},
      {"POINT M (1 2 3)", "character 7: expected '(' and two coordinates"},
      {"POINT ZM (1 2 3 4)", "character 7: expected '(' and two coordinates"},
      {"POINT Z EMPTY", "character 7: expected a POINT that is not empty"},
      {"GEOMETRYCOLLECTION(POINT Z (1 2 3), POINT(1 2 3))",
       "character 47: expected ',' or ')' after"},
      {"POINT EMPTY", "character 7: expected a POINT that is not empty"},
      {"POLYGON EMPTY", "expected a POLYGON that is not empty"},
      {"POLYGON(EMPTY)", "character 9: expected '('"},
      {"MULTIPOLYGON(EMPTY)", "expected '('"},
      {"POINT(1 2",
       "character 10: expected ',' or ')' after longitude and "
       "latitude, found the end of the text"},
      {"POINT(1 2) POINT(3 4)", "character 12: expected the end of the text"},
      {"POLYGON((0 0, 1 0, 1 1, 0 1))",
       "character 9: expected a ring that ends at the position it begins"},
      {"POLYGON((0 0, 1 0, 0 0))", "a ring of at least four positions"},
      {"LINESTRING(1 2, 1 2)", "a line of at least two different positions"},
      {"LINESTRING(1 2)", "a line of at least two different positions"},
      {"POINT(1 \xff\xfe)", "character 9"},
  };
  for (const Case& c : cases) {
    EXPECT_NE(ErrorOf(c.text).find(c.error), std::string::npos)
        << c.text << " -> " << ErrorOf(c.text);
  }
}

TEST(ParseWkt, ReadsEwktAndLeavesHeightsOut) {
  for (const char* text :
       {"SRID=4326;POINT(-97 22)", " srid = 4326 ; POINT (-97 22)",
        "SRID=4326;POINT(-97 22 -30.5)", "SRID=4326;POINT Z (-97 22 0)",
        "POINT Z (-97 22 -30)", "POINTZ(-97 22 1e3)", "point z(-97 22 5)"}) {
    const WktNode node = ParseWkt(text);
    EXPECT_EQ(node.kind, WktKind::kPoint) << text;
    EXPECT_EQ(node.chains[0][0], (LonLat{-97, 22})) << text;
  }
  const WktNode area = ParseWkt(
      "MULTIPOLYGON Z (((0 0 9, 2 0 8, 2 1 7, 0 0 6)), "
      "((5 5 0, 6 5 0, 6 6 0, 5 5 0)))");
  ASSERT_EQ(area.members.size(), 2u);
  EXPECT_EQ(area.members[0].chains[0][2], (LonLat{2, 1}));
  const WktNode mixed =
      ParseWkt("GEOMETRYCOLLECTION(POINT Z (1 2 3), POINT(4 5))");
  EXPECT_EQ(mixed.members[1].chains[0][0], (LonLat{4, 5}));
}

TEST(ParseWkt, TakesCrs84OffAndRefusesOtherReferenceSystemsByName) {
  const WktNode node = ParseWkt(
      " <http://www.opengis.net/def/crs/OGC/1.3/CRS84>  POINT(-97 22)");
  EXPECT_EQ(node.chains[0][0], (LonLat{-97, 22}));
  const std::string error =
      ErrorOf("<http://www.opengis.net/def/crs/EPSG/0/4326> POINT(22 -97)");
  EXPECT_NE(error.find("EPSG/0/4326"), std::string::npos);
  EXPECT_NE(error.find("CRS84"), std::string::npos);
  EXPECT_NE(ErrorOf("<http://open").find("character 1: expected a reference"),
            std::string::npos);
}

TEST(ParseWkt, ReadsEveryKind) {
  EXPECT_EQ(ParseWkt("point(1 2)").kind, WktKind::kPoint);
  EXPECT_EQ(ParseWkt("LineString (1 2,\n3 4)").chains[0].size(), 2u);
  EXPECT_EQ(
      ParseWkt("POLYGON((0 0,4 0,4 4,0 0),(1 1,2 1,2 2,1 1))").chains.size(),
      2u);
  EXPECT_EQ(ParseWkt("MULTIPOINT(1 2, 3 4)").members.size(), 2u);
  EXPECT_EQ(ParseWkt("MULTIPOINT((1 2), (3 4))").members.size(), 2u);
  EXPECT_EQ(ParseWkt("MULTILINESTRING((1 2, 3 4))").kind,
            WktKind::kMultiLineString);
  EXPECT_EQ(ParseWkt("MULTIPOLYGON(((0 0,1 0,1 1,0 0)))").members[0].kind,
            WktKind::kPolygon);
  EXPECT_EQ(ParseWkt("GEOMETRYCOLLECTION(POINT(1 2), LINESTRING(1 2,3 4))")
                .members[1]
                .kind,
            WktKind::kLineString);
}

TEST(ParseWkt, ReadsNumbersInEveryUsualSpelling) {
  const WktNode node = ParseWkt("MULTIPOINT(+1.5e1 -.5, -0 0.25E-1)");
  EXPECT_EQ(node.members[0].chains[0][0], (LonLat{15, -0.5}));
  EXPECT_EQ(node.members[1].chains[0][0], (LonLat{0, 0.025}));
}

TEST(ParseWkt, RefusesDeepNesting) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += "GEOMETRYCOLLECTION(";
  EXPECT_NE(ErrorOf(text).find("at most 8 nested collections"),
            std::string::npos);
  EXPECT_NE(ErrorOf(std::string(50000, '(')).find("expected a geometry"),
            std::string::npos);
}

TEST(ParseWkt, RefusesTooManyPositionsAndTooLongTexts) {
  std::string text = "LINESTRING(0 0";
  for (int i = 0; i < 200000; ++i) text += ",1 1";
  EXPECT_NE(ErrorOf(text + ")").find("at most 100000 positions"),
            std::string::npos);
  EXPECT_NE(ErrorOf("POINT(1 2)" + std::string(kMaxWktBytes, ' '))
                .find("at most 1048576 bytes"),
            std::string::npos);
}

TEST(ParseWkt, ReadsOrRefusesGarbageAndNothingElse) {
  const std::string alphabet[] = {
      "POLYGON", "MULTI", "POINT", "(",    ")",     ",",
      " ",       "1",     "-97.5", "nan",  "1e400", "LINESTRING",
      "<",       ">",     "EMPTY", "\xff", "e",     "((0 0,1 0,1 1,0 0))"};
  std::mt19937 random(14);
  int read = 0;
  for (int i = 0; i < 50000; ++i) {
    std::string text;
    for (unsigned n = random() % 12; n > 0; --n) {
      text += alphabet[random() % (sizeof(alphabet) / sizeof(alphabet[0]))];
    }
    const std::string error = ErrorOf(text);
    read += error == "read";
    EXPECT_TRUE(error == "read" || error.find("WKT") == 0) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace kg_base
