// Example queries on a small dataset; each test is named after the rule it
// checks.

#include "kg_core/sparql/query_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/isomorphism.h"
#include "kg_core/sparql/results.h"
#include "kg_core/sparql/testing/vector_view.h"

namespace kg_core {
namespace {

constexpr char kFacts[] = R"ttl(
  ex:alpha a ex:Agent ; ex:usesPolicy ex:fast ; ex:speed 0.35 ;
    ex:label "Alpha"@en, "Alfa"@es ; ex:carries ( ex:ctd ex:adcp ) .
  ex:bravo a ex:Agent ; ex:usesPolicy ex:safe ; ex:speed 0.30 ;
    ex:launched "2020-11-01T06:00:00Z"^^xsd:dateTime .
  ex:charlie a ex:Agent ; ex:speed "fast" .
  ex:fast ex:risk 3 . ex:safe ex:risk 1 .
  ex:shelf geo:asWKT "POLYGON((0 0,2 0,2 2,0 2,0 0))"^^geo:wktLiteral .
  ex:buoy geo:asWKT "POINT(1 1)"^^geo:wktLiteral .
  ex:rig geo:asWKT "POINT(5 1)"^^geo:wktLiteral .
)ttl";
constexpr char kProvenance[] = R"ttl(
  ex:plan prov:wasDerivedFrom ex:tensor, ex:rules .
  ex:tensor prov:wasDerivedFrom ex:file .
  ex:rules prov:wasDerivedFrom ex:tensor .
  ex:alpha ex:usesPolicy ex:fast .
)ttl";

VectorView World() {
  VectorView view;
  for (const auto& [text, graph] :
       {std::pair{kFacts, kFactsGraph}, std::pair{kProvenance, kProvGraph}}) {
    for (const Statement& s : ParseTurtle(text, "test", Iri(graph))) {
      view.Add(s.subject, s.predicate, s.object, s.graph);
    }
  }
  view.Add(Iri(std::string(kEx) + "old"), Iri(std::string(kEx) + "speed"),
           IntegerLiteral(9), Iri(std::string(kGraph) + "plan/1"));
  return view;
}

QueryResult Query(const std::string& query, const QueryLimits& limits = {}) {
  static const VectorView* const world = new VectorView(World());
  return RunQuery(*world, query, DefaultDataset(std::nullopt), limits);
}

// Result rows as "cell cell", with '-' for unbound.
std::vector<std::string> Rows(const std::string& query) {
  std::vector<std::string> lines;
  for (const auto& row : Query(query).rows) {
    std::string line;
    for (const std::optional<Term>& term : row) {
      if (!line.empty()) line += " ";
      line += term ? ToTurtle(*term) : "-";
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> SortedRows(const std::string& query) {
  std::vector<std::string> lines = Rows(query);
  std::sort(lines.begin(), lines.end());
  return lines;
}

using Lines = std::vector<std::string>;

// The value of an expression in Turtle syntax, "-" for an error.
std::string Value(const std::string& expression) {
  return Rows("SELECT (" + expression + " AS ?v) {}").at(0);
}

std::string GetError(const std::string& query, const QueryLimits& limits = {}) {
  try {
    Query(query, limits);
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(QueryEngine, MatchesABasicGraphPattern) {
  EXPECT_EQ(SortedRows("SELECT ?a ?r { ?a a ex:Agent ; ex:usesPolicy ?p . "
                       "?p ex:risk ?r }"),
            (Lines{"ex:alpha 3", "ex:bravo 1"}));
}

TEST(QueryEngine, MergesGraphsOfTheDefaultGraphWithoutDuplicates) {
  EXPECT_EQ(Rows("SELECT ?p { ex:alpha ex:usesPolicy ?p }"),
            (Lines{"ex:fast"}));
}

TEST(QueryEngine, ReadsHistoryOnlyByGraph) {
  EXPECT_EQ(Rows("SELECT ?v { ex:old ex:speed ?v }"), (Lines{}));
  EXPECT_EQ(Rows("SELECT ?g ?v { GRAPH ?g { ex:old ex:speed ?v } }"),
            (Lines{"<http://example.org/mission/graph/plan/1> 9"}));
  EXPECT_EQ(SortedRows("SELECT ?g { GRAPH ?g { ex:alpha ex:usesPolicy ?p } }"),
            (Lines{"graph:facts", "graph:prov"}));
  EXPECT_EQ(Rows("SELECT ?v FROM <http://example.org/mission/graph/plan/1> "
                 "{ ?s ex:speed ?v }"),
            (Lines{"9"}));
}

TEST(QueryEngine, ReadsCollectionsAndBlankNodeProperties) {
  EXPECT_EQ(Rows("SELECT ?a { ?a ex:carries (ex:ctd ?x) }"),
            (Lines{"ex:alpha"}));
  EXPECT_EQ(Rows("SELECT ?a { ?a ex:usesPolicy [ ex:risk 3 ] }"),
            (Lines{"ex:alpha"}));
  EXPECT_EQ(SortedRows("SELECT ?i { ex:alpha ex:carries/rdf:rest*/rdf:first "
                       "?i }"),
            (Lines{"ex:adcp", "ex:ctd"}));
}

TEST(QueryEngine, KeepsTheLeftSideOfAnOptionalWhoseFilterFails) {
  EXPECT_EQ(SortedRows("SELECT ?a ?p { ?a a ex:Agent OPTIONAL { ?a "
                       "ex:usesPolicy ?p . ?p ex:risk ?r FILTER(?r > 2) } }"),
            (Lines{"ex:alpha ex:fast", "ex:bravo -", "ex:charlie -"}));
}

TEST(QueryEngine, AnswersUnionMinusExistsAndValues) {
  EXPECT_EQ(SortedRows("SELECT ?x { { ?x ex:risk 1 } UNION { ?x ex:risk 3 } }"),
            (Lines{"ex:fast", "ex:safe"}));
  EXPECT_EQ(Rows("SELECT ?a { ?a a ex:Agent MINUS { ?a ex:usesPolicy ?p } }"),
            (Lines{"ex:charlie"}));
  EXPECT_EQ(Rows("SELECT ?a { ?a a ex:Agent FILTER NOT EXISTS { ?a "
                 "ex:usesPolicy ?p } }"),
            (Lines{"ex:charlie"}));
  EXPECT_EQ(Rows("SELECT ?p ?r { ?p ex:risk ?r VALUES (?p ?r) { (ex:fast "
                 "UNDEF) (ex:safe 7) } }"),
            (Lines{"ex:fast 3"}));
}

TEST(QueryEngine, LetsAnInnerFilterSeeOnlyItsOwnGroup) {
  EXPECT_EQ(Rows("SELECT ?r { ex:fast ex:risk ?r { FILTER(BOUND(?r)) } }"),
            (Lines{}));
  EXPECT_EQ(Rows("SELECT ?r ?s { ex:fast ex:risk ?r OPTIONAL { { ex:safe "
                 "ex:risk ?s FILTER(?r = 3) } } }"),
            (Lines{"3 -"}));
}

TEST(QueryEngine, FollowsPathsThroughProvenance) {
  EXPECT_EQ(SortedRows("SELECT ?x { ex:plan prov:wasDerivedFrom+ ?x }"),
            (Lines{"ex:file", "ex:rules", "ex:tensor"}));
  EXPECT_EQ(SortedRows("SELECT ?x { ?x prov:wasDerivedFrom+ ex:file }"),
            (Lines{"ex:plan", "ex:rules", "ex:tensor"}));
  EXPECT_EQ(SortedRows("SELECT ?x { ex:tensor ^prov:wasDerivedFrom ?x }"),
            (Lines{"ex:plan", "ex:rules"}));
  EXPECT_EQ(Rows("SELECT ?x { ex:nowhere prov:wasDerivedFrom* ?x }"),
            (Lines{"ex:nowhere"}));
  EXPECT_EQ(Rows("SELECT ?x { ex:safe !(a|^ex:usesPolicy) ?x }"), (Lines{"1"}));
  EXPECT_TRUE(
      Query("ASK { ex:plan (prov:wasDerivedFrom|ex:none)+ ex:file }").answer);
}

TEST(QueryEngine, GroupsAndAggregates) {
  EXPECT_EQ(Rows("SELECT (COUNT(*) AS ?n) (SUM(?r) AS ?s) (AVG(?r) AS ?m) "
                 "(MIN(?r) AS ?a) (MAX(?r) AS ?b) { ?p ex:risk ?r }"),
            (Lines{"2 4 " + Value("xsd:decimal(2)") + " 1 3"}));
  EXPECT_EQ(SortedRows("SELECT ?c (COUNT(?a) AS ?n) { ?a a ?c } GROUP BY ?c "
                       "HAVING (COUNT(?a) > 1)"),
            (Lines{"ex:Agent 3"}));
  EXPECT_EQ(Rows("SELECT (COUNT(*) AS ?n) { ?a ex:none ?b }"), (Lines{"0"}));
  EXPECT_EQ(Rows("SELECT ?a (COUNT(*) AS ?n) { ?a ex:none ?b } GROUP BY ?a"),
            (Lines{}));
  EXPECT_EQ(Rows("SELECT (GROUP_CONCAT(?r; SEPARATOR=\"|\") AS ?t) { { SELECT "
                 "?r { ?p ex:risk ?r } ORDER BY ?r } }"),
            (Lines{"\"1|3\""}));
}

TEST(QueryEngine, OrdersByValueWithUnboundFirst) {
  EXPECT_EQ(Rows("SELECT ?a ?r { ?a a ex:Agent OPTIONAL { ?a "
                 "ex:usesPolicy/ex:risk ?r } } ORDER BY ?r"),
            (Lines{"ex:charlie -", "ex:bravo 1", "ex:alpha 3"}));
  EXPECT_EQ(Rows("SELECT ?v { VALUES ?v { 10 9 1e1 \"9\" ex:x 9.5 } } ORDER BY "
                 "DESC(?v) LIMIT 3 OFFSET 1"),
            (Lines{"10", Value("1e1"), "9.5"}));
}

TEST(QueryEngine, RemovesDuplicatesOnlyIfAsked) {
  EXPECT_EQ(Rows("SELECT ?c { ?a a ?c }").size(), 3u);
  EXPECT_EQ(Rows("SELECT DISTINCT ?c { ?a a ?c }").size(), 1u);
}

TEST(QueryEngine, FollowsTheThreeValuedLogicOfErrors) {
  const std::string error = "(1/0 = 1)";
  EXPECT_EQ(Value(error), "-");
  EXPECT_EQ(Value(error + " || true"), "true");
  EXPECT_EQ(Value(error + " || false"), "-");
  EXPECT_EQ(Value(error + " && false"), "false");
  EXPECT_EQ(Value(error + " && true"), "-");
  EXPECT_EQ(Value("!" + error), "-");
  EXPECT_EQ(Value("1 IN (1/0, 1)"), "true");
  EXPECT_EQ(Value("2 NOT IN (1/0, 1)"), "-");
  EXPECT_EQ(Value("COALESCE(1/0, ?none, 7)"), "7");
  EXPECT_EQ(Value("IF(1/0 = 1, 1, 2)"), "-");
}

TEST(QueryEngine, CalculatesDecimalsExactly) {
  EXPECT_EQ(Value("0.1 + 0.2"), "0.3");
  EXPECT_EQ(Value("0.1 + 0.2 = 0.3"), "true");
  EXPECT_EQ(Value("0.1e0 + 0.2e0 = 0.3e0"), "false");
  EXPECT_EQ(Value("1 / 8"), "0.125");
  EXPECT_EQ(Value("7 - 2 * 3"), "1");
  EXPECT_EQ(Value("-(2) + 1"), "-1");
  EXPECT_EQ(Value("9007199254740993 = 9007199254740992"), "false");
}

TEST(QueryEngine, LetsNaNFailEveryComparison) {
  for (const char* op : {"=", "<", ">", "<=", ">="}) {
    EXPECT_EQ(
        Value("xsd:double('NaN') " + std::string(op) + " xsd:double('NaN')"),
        "false")
        << op;
  }
}

TEST(QueryEngine, KnowsTheFunctions) {
  const std::pair<const char*, const char*> kCases[] = {
      {"STR(ex:a)", "\"http://example.org/mission/a\""},
      {"LANG('a'@en-GB)", "\"en-gb\""},
      {"DATATYPE(1.5)", "xsd:decimal"},
      {"STRLEN('h\\u00e9llo')", "5"},
      {"SUBSTR('foobar', 4)", "\"bar\""},
      {"SUBSTR('foobar', 0, 3)", "\"fo\""},
      {"UCASE('stra\\u00e9')", "\"STRA\xC3\x89\""},
      {"STRBEFORE('abc'@en, 'b')", "\"a\"@en"},
      {"STRAFTER('abc', 'z')", "\"\""},
      {"CONCAT('a'@en, 'b'@en)", "\"ab\"@en"},
      {"CONCAT('a'@en, 'b')", "\"ab\""},
      {"ENCODE_FOR_URI('a b/\\u00e9')", "\"a%20b%2F%C3%A9\""},
      {"REPLACE('abcd', '(b)(c)', '$2$1')", "\"acbd\""},
      {"REPLACE('abcd', 'x*', '-')", "-"},
      {"REGEX('Alpha', '^al', 'i')", "true"},
      {"REGEX('Alpha', '(')", "-"},
      {"ABS(-2.5)", "2.5"},
      {"ROUND(-2.5)", "\"-2\"^^xsd:decimal"},
      {"CEIL(1.1)", "\"2\"^^xsd:decimal"},
      {"FLOOR(-1.1)", "\"-2\"^^xsd:decimal"},
      {"YEAR('2020-11-01T06:30:15.5Z'^^xsd:dateTime)", "2020"},
      {"SECONDS('2020-11-01T06:30:15.5Z'^^xsd:dateTime)", "15.5"},
      {"TZ('2020-11-01T06:30:15-05:00'^^xsd:dateTime)", "\"-05:00\""},
      {"SHA1('abc')", "\"a9993e364706816aba3e25717850c26c9cd0d89d\""},
      {"MD5('abc')", "\"900150983cd24fb0d6963f7d28e17f72\""},
      {"xsd:integer('12')", "12"},
      {"xsd:integer(3.9)", "3"},
      {"xsd:integer('x')", "-"},
      {"xsd:boolean('1')", "true"},
      {"xsd:string(7)", "\"7\""},
      {"sameTerm(1, 1.0)", "false"},
      {"1 = 1.0", "true"},
      {"'a' = 'a'@en", "false"},
      {"'a'^^ex:t = 'b'^^ex:t", "-"},
      {"ex:a = ex:a", "true"},
      {"'2020-11-01T06:00:00Z'^^xsd:dateTime < "
       "'2020-11-01T02:00:00-05:00'^^xsd:dateTime",
       "true"},
      {"LANGMATCHES('en-GB', 'en')", "true"},
      {"STRDT('1', xsd:byte) + 1", "2"},
      {"isNumeric('x'^^xsd:integer)", "false"},
      {"isNumeric('1200'^^xsd:byte)", "false"},
      {"isNumeric('-120'^^xsd:byte) && isNumeric('INF'^^xsd:float)", "true"},
      {"REGEX('helloworld', 'hello world', 'x')", "true"},
      {"REGEX('helloworld', 'hello[ ]world', 'x')", "false"},
      {"REGEX('hello world', 'hello\\\\ sworld', 'x')", "true"},
      {"REGEX('a#b', 'a # b', 'x')", "true"},
      {"REGEX('a b', 'a b', 'xq')", "true"},
  };
  for (const auto& [expression, value] : kCases) {
    EXPECT_EQ(Value(expression), value) << expression;
  }
}

TEST(QueryEngine, AnswersGeometry) {
  EXPECT_EQ(SortedRows("SELECT ?x { ex:shelf geo:asWKT ?s . ?x geo:asWKT ?g "
                       "FILTER(geof:sfWithin(?g, ?s)) }"),
            (Lines{"ex:buoy", "ex:shelf"}));
  EXPECT_EQ(Rows("SELECT ?d { ex:shelf geo:asWKT ?s . ex:rig geo:asWKT ?g "
                 "BIND(geof:distance(?g, ?s, "
                 "<http://www.opengis.net/def/uom/OGC/1.0/degree>) = 3 AS ?d) "
                 "}"),
            (Lines{"true"}));
}

// The triples of CONSTRUCT or DESCRIBE as Turtle, without the prefixes.
std::string Turtle(const std::string& query) {
  const std::string text = TriplesToTurtle(Query(query).triples);
  const std::size_t end = text.rfind("@prefix");
  return end == std::string::npos ? text
                                  : text.substr(text.find('\n', end) + 2);
}

TEST(QueryEngine, ConstructsEachTripleOnce) {
  EXPECT_EQ(Turtle("CONSTRUCT { ?p ex:usedBy ?a ; a ex:Used } "
                   "{ ?a ex:usesPolicy ?p }"),
            "ex:fast a ex:Used ;\n    ex:usedBy ex:alpha .\n\n"
            "ex:safe a ex:Used ;\n    ex:usedBy ex:bravo .\n");
  EXPECT_EQ(Query("CONSTRUCT { ex:a ex:b ex:c } { ?s ?p ?o }").triples.size(),
            1u);
}

TEST(QueryEngine, LeavesOutWhatWouldBeNoTriple) {
  EXPECT_EQ(Turtle("CONSTRUCT { ?r ex:of ?p . ?p ?r ?p . ?p ex:is ?none . ?p "
                   "ex:risk ?r } { ?p ex:risk ?r FILTER(?r > 1) }"),
            "ex:fast ex:risk 3 .\n");
}

TEST(QueryEngine, GivesEachSolutionBlankNodesOfItsOwn) {
  const QueryResult result = Query(
      "CONSTRUCT { _:x ex:of ?p . _:x ex:value [ ex:is ?r ] } "
      "{ ?p ex:risk ?r . OPTIONAL { _:x ex:none ?p } }");
  EXPECT_EQ(result.form, QueryResult::Form::kConstruct);
  std::vector<Statement> got;
  for (const Triple& t : result.triples) {
    got.push_back({t.subject, t.predicate, t.object, Iri(kFactsGraph)});
  }
  EXPECT_TRUE(IsIsomorphic(
      got, ParseTurtle("_:a ex:of ex:fast ; ex:value [ ex:is 3 ] . "
                       "_:b ex:of ex:safe ; ex:value [ ex:is 1 ] .",
                       "test", Iri(kFactsGraph))));
}

TEST(QueryEngine, ConstructsWithModifiersAndInTheShortForm) {
  EXPECT_EQ(Turtle("CONSTRUCT { ?p ex:risk ?r } WHERE { ?p ex:risk ?r } "
                   "ORDER BY DESC(?r) LIMIT 1"),
            "ex:fast ex:risk 3 .\n");
  EXPECT_EQ(Turtle("CONSTRUCT WHERE { ex:safe ex:risk ?r . ?a ex:usesPolicy "
                   "ex:safe }"),
            "ex:bravo ex:usesPolicy ex:safe .\n\nex:safe ex:risk 1 .\n");
  EXPECT_EQ(Turtle("CONSTRUCT { ex:n ex:is ?n } { SELECT (COUNT(*) AS ?n) "
                   "{ ?p ex:risk ?r } }"),
            "ex:n ex:is 2 .\n");
  EXPECT_EQ(Turtle("CONSTRUCT {} { ?s ?p ?o }"), "");
}

TEST(QueryEngine, DescribesAResourceDownToItsBlankNodes) {
  EXPECT_EQ(Turtle("DESCRIBE ex:safe"), "ex:safe ex:risk 1 .\n");
  EXPECT_EQ(Turtle("DESCRIBE ex:nobody"), "");
  EXPECT_EQ(Turtle("DESCRIBE ?p { ?a ex:usesPolicy ?p }"),
            "ex:fast ex:risk 3 .\n\nex:safe ex:risk 1 .\n");
  EXPECT_EQ(Turtle("DESCRIBE * WHERE { ex:bravo ex:usesPolicy ?p }"),
            "ex:safe ex:risk 1 .\n");
  // Six triples of ex:alpha, and four of the list it refers to.
  EXPECT_EQ(Query("DESCRIBE ex:alpha").triples.size(), 10u);
}

// https://www.w3.org/TR/sparql11-federated-query/#serviceSilent
TEST(QueryEngine, ASilentServiceHasOneSolutionThatBindsNothing) {
  EXPECT_EQ(Rows("SELECT * { ex:fast ex:risk ?r "
                 "SERVICE SILENT <http://x/> { ?s ex:risk ?v FILTER(ex:f(1)) } "
                 "}"),
            (Lines{"3 - -"}));
  EXPECT_EQ(Rows("SELECT ?r { SERVICE SILENT ?x { SERVICE <http://y/> {} } "
                 "ex:safe ex:risk ?r }"),
            (Lines{"1"}));
}

TEST(QueryEngine, SaysWhereTheMistakeIs) {
  const std::pair<const char*, const char*> kCases[] = {
      {"",
       "1:1: expected SELECT, ASK, CONSTRUCT or DESCRIBE, got the end of the "
       "query"},
      {"SELECT ?a\n { ?a no:x ?b }", "2:7: prefix 'no:' is not declared"},
      {"SELECT ?a { ?a ex:b }", "1:21: expected a variable or a term, got }"},
      {"SELECT ?a { ?a ex:b 'x }", "1:21: this string does not end"},
      {"ASK { FILTER(ex:f(1)) }",
       "1:14: function <http://example.org/mission/f> is not known"},
      {"ASK { SERVICE <http://x/> {} }",
       "1:7: SERVICE is not available: a query reads this store only"},
      {"ASK { SERVICE <http://x/> { ?s ?p ?o } SERVICE SILENT ?y {} }",
       "1:7: SERVICE is not available: a query reads this store only"},
      {"ASK { SERVICE <http://x/> { ?s ?p } }",
       "1:35: expected a variable or a term, got }"},
      {"LOAD <http://x/>",
       "1:1: LOAD is not available: a query changes nothing"},
      {"CONSTRUCT WHERE { ?s ?p ?o FILTER(true) }",
       "1:28: expected '}', got FILTER"},
      {"CONSTRUCT { ?s ex:p+ ?o } { ?s ?p ?o }",
       "1:20: expected a variable or a term, got +"},
      {"DESCRIBE { ?s ?p ?o }",
       "1:10: expected an IRI, a variable or '*', got {"},
      {"PREFIX a: <http://a/> DELETE WHERE { ?s ?p ?o }",
       "1:23: DELETE is not available: a query changes nothing"},
      {"SELECT ?a ?b { ?a ex:p ?b } GROUP BY ?a",
       "1:1: ?b is neither grouped by nor aggregated"},
      {"SELECT ?a { ?a ex:p ?b BIND(1 AS ?b) }",
       "1:34: ?b already has values in this group"},
      {"SELECT (COUNT(COUNT(?a)) AS ?n) { ?a ex:p ?b }",
       "1:15: COUNT may stand in SELECT, HAVING and ORDER BY only, and not "
       "within another aggregate"},
      {"ASK { ?a ex:p ?b } ?x", "1:20: expected the end of the query, got ?x"},
      {"ASK { _:a ex:p ?b OPTIONAL { _:a ex:q ?c } }",
       "1:34: blank node _:a is used in two different graph patterns"},
      {"ASK FROM ex:no { ?a ?b ?c }", "FROM: the store has no graph ex:no"},
      {"ASK { ?a ex:p \xff }", "1:15: this is not UTF-8"},
  };
  for (const auto& [query, error] : kCases) {
    EXPECT_EQ(GetError(query), error) << query;
  }
}

TEST(QueryEngine, EndsWithinItsLimits) {
  const std::string cross =
      "{ ?a ?b ?c . ?d ?e ?f . ?g ?h ?i . ?j ?k ?l . ?m ?n ?o . ?p ?q ?r }";
  QueryLimits limits;
  limits.rows = 1000;
  EXPECT_EQ(GetError("SELECT * " + cross, limits),
            "the result has more rows than the limit of 1000");
  limits = {};
  limits.bytes = 5000;
  EXPECT_EQ(GetError("SELECT * " + cross, limits),
            "the result has more bytes than the limit of 5000");
  limits = {};
  limits.seconds = 0.05;
  EXPECT_EQ(GetError("SELECT (COUNT(*) AS ?total) " + cross, limits),
            "the query took longer than the limit of 0.05 s");
  EXPECT_EQ(GetError("ASK " + cross.substr(0, cross.size() - 1) +
                         "FILTER(STRLEN(CONCAT(STR(?a), STR(?r))) < 0) }",
                     limits),
            "the query took longer than the limit of 0.05 s");
  limits = {};
  limits.working_bytes = 100000;
  EXPECT_EQ(GetError("SELECT * " + cross + " ORDER BY ?a", limits),
            "the query needs more memory than the limit of 100000 bytes");
}

TEST(QueryEngine, CountsTriplesAgainstItsLimits) {
  QueryLimits limits;
  limits.rows = 10;
  EXPECT_EQ(GetError("CONSTRUCT { ?a ?b [] } { ?a ?b ?c }", limits),
            "the result has more rows than the limit of 10");
  limits.rows = 9;
  EXPECT_EQ(GetError("DESCRIBE ex:alpha", limits),
            "the result has more rows than the limit of 9");
}

TEST(QueryEngine, StopsARegularExpressionThatBacktracks) {
  const std::string many(40, 'a');
  EXPECT_EQ(GetError("ASK { FILTER(REGEX('" + many + "b', '^(a+)+$')) }"),
            "a regular expression took more steps than the limit of 200000");
}

TEST(QueryEngine, EvaluatesAsLongAChainAsItAccepts) {
  std::string optionals;
  std::string triples;
  std::string sum = "0";
  for (int i = 0; i < 330; ++i) optionals += "OPTIONAL{?a ex:p ?b}";
  for (int i = 0; i < 990; ++i) triples += "?a ex:usesPolicy ex:fast .";
  for (int i = 0; i < 1000; ++i) sum += "+1";
  EXPECT_FALSE(Query("ASK {" + optionals + "FILTER(BOUND(?b)) }").answer);
  EXPECT_TRUE(Query("ASK {" + triples + "}").answer);
  EXPECT_EQ(Value(sum), "1000");
}

TEST(QueryEngine, RefusesTooDeepNestingAndTooLongTexts) {
  const std::string open(300, '(');
  EXPECT_EQ(GetError("ASK { FILTER" + open),
            "1:213: nested deeper than the limit of 200");
  std::string groups;
  for (int i = 0; i < 300; ++i) groups += "{";
  EXPECT_EQ(GetError("ASK " + groups),
            "1:205: nested deeper than the limit of 200");
  EXPECT_EQ(GetError(std::string(65537, ' ')),
            "the query is longer than the limit of 65536 bytes");
  std::string optionals;
  for (int i = 0; i < 2000; ++i) optionals += "OPTIONAL{?a ex:p ?b}";
  EXPECT_NE(GetError("ASK {" + optionals + "}").find("more patterns than"),
            std::string::npos);
}

TEST(QueryEngine, BlankAndPathNodesAreNoPartOfACountedSolution) {
  // The blank node matches two labels, the two triples of a path one middle.
  EXPECT_EQ(Rows("SELECT (COUNT(DISTINCT *) AS ?n) { ?s ex:label [] }"),
            (Lines{"1"}));
  EXPECT_EQ(Rows("SELECT (COUNT(*) AS ?n) { ?s ex:label [] }"), (Lines{"2"}));
  EXPECT_EQ(Rows("SELECT (COUNT(DISTINCT *) AS ?n) { ?s ex:label _:x }"),
            (Lines{"1"}));
  EXPECT_EQ(Rows("SELECT (COUNT(DISTINCT *) AS ?n) { [] ex:label ?l }"),
            (Lines{"2"}));
  EXPECT_EQ(Rows("SELECT (COUNT(DISTINCT *) AS ?n) "
                 "{ ?t a/^a ex:alpha . ?s a/^a ex:alpha }"),
            (Lines{"9"}));
  EXPECT_EQ(Rows("SELECT ?s { ?s ex:label [] } GROUP BY ?s "
                 "HAVING (COUNT(DISTINCT *) = 1)"),
            (Lines{"ex:alpha"}));
  EXPECT_EQ(Rows("SELECT (COUNT(DISTINCT *) AS ?n) { [] ex:label [] } "
                 "VALUES ?v { 1 2 }"),
            (Lines{"2"}));
}

TEST(QueryEngine, PathsOfNoLengthBindInnerVariablesToNodesOfTheGraph) {
  // ex:nowhere is no node of the graph, ex:alpha is one.
  const std::pair<const char*, std::size_t> kCases[] = {
      {"?y (ex:nope|(ex:p*/ex:q?)) ex:nowhere", 0},
      {"ex:nowhere (ex:nope|(ex:p*/ex:q?)) ?y", 0},
      {"?y ex:p*/ex:q? ex:nowhere", 0},
      {"?y (ex:nope|^(ex:p*/ex:q?)) ex:nowhere", 0},
      {"?y (ex:nope|(ex:p?/ex:q*/ex:r?)) ex:nowhere", 0},
      {"ex:nowhere (ex:nope|(ex:p?/ex:q*/ex:r?)) ?y", 0},
      {"ex:nowhere ex:p* ?y", 1},
      {"ex:nowhere (ex:nope|ex:p*) ?y", 1},
      {"?y (ex:nope|ex:p?) ex:nowhere", 1},
      {"ex:nowhere (ex:p?)* ?y", 1},
      {"ex:nowhere (ex:p?)+ ?y", 1},
      {"ex:nowhere (ex:nope|(ex:p*/ex:q?)) ex:nowhere", 1},
      {"ex:alpha (ex:nope|(ex:p*/ex:q?)) ?y", 1},
      {"?y (ex:nope|(ex:p*/ex:q?)) ex:alpha", 1},
      {"VALUES ?y { ex:nowhere } ?y ex:p* ?z", 0},
      {"VALUES ?y { ex:nowhere } ?y ex:p* ex:nowhere", 1},
      {"VALUES ?y { ex:nowhere } ?y (ex:nope|(ex:p*/ex:q?)) ?z", 0},
  };
  for (const auto& [pattern, count] : kCases) {
    EXPECT_EQ(Rows("SELECT * { " + std::string(pattern) + " }").size(), count)
        << pattern;
  }
}

TEST(QueryEngine, IllTypedNumbersAreErrors) {
  EXPECT_EQ(Value("'300'^^xsd:unsignedByte + 1"), "-");
  EXPECT_EQ(Value("1 < '-1'^^xsd:positiveInteger"), "-");
  EXPECT_EQ(Value("1 = 'x'^^xsd:integer"), "-");
  EXPECT_EQ(Value("-'128'^^xsd:byte"), "-");
  EXPECT_EQ(Value("ABS('9223372036854775808'^^xsd:long)"), "-");
  EXPECT_EQ(Value("isNumeric('9223372036854775808'^^xsd:long)"), "false");
  EXPECT_EQ(Value("'200'^^xsd:unsignedByte + 1"), "201");
  EXPECT_EQ(Rows("SELECT (SUM(?x) AS ?s) (AVG(?x) AS ?a) "
                 "{ VALUES ?x { 1 '300'^^xsd:unsignedByte } }"),
            (Lines{"- -"}));
}

TEST(QueryEngine, GroupingFreesTheNamesOfThePattern) {
  EXPECT_EQ(Rows("SELECT (123 AS ?r) { ?p ex:risk ?r } GROUP BY ?p"),
            (Lines{"123", "123"}));
  EXPECT_EQ(Rows("SELECT (COUNT(*) AS ?r) { ?p ex:risk ?r }"), (Lines{"2"}));
  EXPECT_EQ(Rows("SELECT ?k { ?p ex:risk ?r } GROUP BY (?r > 0 AS ?k)"),
            (Lines{"true"}));
  for (const char* query :
       {"SELECT (123 AS ?z) {} GROUP BY (1 AS ?z)",
        "SELECT (1 AS ?p) { ?p ex:risk ?r } GROUP BY ?p",
        "SELECT (1 AS ?r) { ?p ex:risk ?r }", "SELECT (1 AS ?x) (2 AS ?x) {}",
        "SELECT ?z {} GROUP BY (1 AS ?z) (2 AS ?z)",
        "SELECT ?r { ?p ex:risk ?r } GROUP BY (1 AS ?r)"}) {
    EXPECT_NE(GetError(query).find("already has values"), std::string::npos)
        << query << ": " << GetError(query);
  }
  for (const char* query : {"SELECT * { VALUES (?a ?a) { (1 1) } }",
                            "SELECT * {} VALUES (?a ?b ?a) { (1 1 1) }"}) {
    EXPECT_NE(GetError(query).find("?a is a column"), std::string::npos)
        << query;
  }
}

TEST(QueryEngine, AColumnThatIsNamedTwiceIsOne) {
  const QueryResult result =
      Query("SELECT ?p ?r ?p { ?p ex:risk ?r } ORDER BY ?r");
  EXPECT_EQ(result.variables, (Lines{"p", "r"}));
  EXPECT_EQ(result.rows.at(0).size(), 2u);
  EXPECT_EQ(Query("SELECT (1 AS ?x) ?x {}").variables, (Lines{"x"}));
}

TEST(QueryEngine, CoalesceOfNothingIsAnError) {
  EXPECT_EQ(Value("COALESCE()"), "-");
  EXPECT_EQ(Value("COALESCE(COALESCE(), 2)"), "2");
}

TEST(QueryEngine, GroupConcatOfABlankNodeIsAnError) {
  EXPECT_EQ(Rows("SELECT (GROUP_CONCAT(?x) AS ?t) { BIND(BNODE() AS ?x) }"),
            (Lines{"-"}));
  EXPECT_EQ(Rows("SELECT (GROUP_CONCAT(DISTINCT ?x) AS ?t) "
                 "{ { BIND(BNODE() AS ?x) } UNION { BIND('a' AS ?x) } }"),
            (Lines{"-"}));
  EXPECT_EQ(Rows("SELECT (GROUP_CONCAT(?x) AS ?t) { VALUES ?x { 'a' ex:b } }"),
            (Lines{"\"a http://example.org/mission/b\""}));
}

TEST(QueryEngine, IrisAreAbsoluteOrErrors) {
  EXPECT_EQ(Value("IRI('x')"), "-");
  EXPECT_EQ(Value("IRI('')"), "-");
  EXPECT_EQ(Value("IRI('http://h/a b')"), "-");
  EXPECT_EQ(Value("IRI('http://h/\\u0001')"), "-");
  EXPECT_EQ(Value("IRI('urn:x')"), "<urn:x>");
  EXPECT_EQ(Rows("BASE <http://h/a> SELECT (IRI('../b') AS ?x) {}"),
            (Lines{"<http://h/b>"}));
  EXPECT_EQ(Value("STRLANG('x', 'e n')"), "-");
  EXPECT_EQ(Value("STRLANG('x', 'EN-gb')"), "\"x\"@en-gb");
  EXPECT_EQ(Value("STRDT('x', IRI('d'))"), "-");
  for (const char* query :
       {"SELECT * { <a> ?p ?o }", "SELECT * FROM <g> { ?s ?p ?o }",
        "PREFIX z: <zz> SELECT * { ?s z:p ?o }", "BASE <b/> ASK {}",
        "ASK { ?s ?p 'x'^^<dt> }"}) {
    EXPECT_NE(GetError(query).find("relative IRI"), std::string::npos)
        << query << ": " << GetError(query);
  }
}

// https://www.w3.org/TR/sparql11-query/#codepointEscape
TEST(QueryEngine, EscapesInNamesAreTheirCharacters) {
  EXPECT_EQ(Rows("SELECT ?\\u0078 { BIND(1 AS ?x) }"), (Lines{"1"}));
  EXPECT_EQ(Rows("SELECT ?x\\U00000079z { BIND(1 AS ?xyz) }"), (Lines{"1"}));
  EXPECT_EQ(Value("ex:\\u0061b\\u00E9"),
            "<http://example.org/mission/ab\xC3\xA9>");
  for (const char* query :
       {"ASK { ?x\\u0020y ?p ?o }", "ASK { ex:a\\u003E ?p ?o }",
        "ASK { ex:a\\u00 ?p ?o }", "ASK { ?\\uD800 ?p ?o }"}) {
    EXPECT_NE(GetError(query).find("expected"), std::string::npos) << query;
  }
}

TEST(QueryEngine, MessagesKeepCharactersWhole) {
  for (const char* mark :
       {"\xE2\x80\x9C", "\xE2\x80\x93", "\xC2\xA0", "\xF0\x9F\x98\x80"}) {
    const std::string error =
        GetError("SELECT * { ?s rdfs:label " + std::string(mark) + " }");
    EXPECT_NE(error.find(mark), std::string::npos) << error;
    EXPECT_FALSE(kg_base::FirstBadUtf8(error)) << error;
  }
}

}  // namespace
}  // namespace kg_core
