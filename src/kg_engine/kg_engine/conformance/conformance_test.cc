// Tests of the runner with generated suites: it must detect failures.

#include "kg_engine/conformance/conformance.h"

#include <filesystem>
#include <fstream>
#include <map>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/isomorphism.h"
#include "kg_engine/conformance/read_rdf_xml.h"

namespace kg_engine {
namespace {

using kg_base::InputError;

using Outcome = ConformanceTest::Outcome;

constexpr char kPrefixes[] = R"ttl(
@prefix : <http://tests.example/manifest#> .
@prefix mf: <http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#> .
@prefix qt: <http://www.w3.org/2001/sw/DataAccess/tests/test-query#> .
@prefix ut: <http://www.w3.org/2009/sparql/tests/test-update#> .
@prefix sd: <http://www.w3.org/ns/sparql-service-description#> .
@prefix ent: <http://www.w3.org/ns/entailment/> .
@prefix sht: <http://www.w3.org/ns/shacl-test#> .
@prefix dawgt: <http://www.w3.org/2001/sw/DataAccess/tests/test-dawg#> .
)ttl";

constexpr char kResultPrefixes[] =
    "@prefix rs: <http://www.w3.org/2001/sw/DataAccess/tests/result-set#> .\n";

// A suite in a folder whose name needs escapes in a URL.
class Suite {
 public:
  Suite() { std::filesystem::create_directories(folder_ / "a suite/more"); }

  void File(const std::string& name, const std::string& text) {
    std::ofstream(Path(name)) << text;
  }
  // Writes a manifest of one test ":t" with the description `test`.
  void Manifest(const std::string& test) {
    File("manifest.ttl",
         kPrefixes +
             ("<> a mf:Manifest ; mf:entries ( :t ) . :t " + test + " ."));
  }
  ConformanceTest RunOne() {
    const auto tests = RunConformance(Path(""));
    EXPECT_EQ(tests.size(), 1u);
    return tests.at(0);
  }
  std::string Path(const std::string& name) const {
    return folder_ / ("a suite/" + name);
  }

 private:
  kg_base::TemporaryFolder folder_;
};

constexpr char kQueryTest[] =
    "a mf:QueryEvaluationTest ; mf:name \"x\" ; mf:action [ qt:query <q.rq> ; "
    "qt:data <d.ttl> ] ; mf:result ";

struct QueryCase {
  std::string query;
  std::string file;  // File name of the expected result.
  std::string result;
};

ConformanceTest RunQueryCase(const QueryCase& test) {
  Suite suite;
  suite.Manifest(kQueryTest + ("<" + test.file + ">"));
  suite.File("d.ttl",
             "@prefix : <http://h/> . :a :p 1 . :b :p 2.0 . :c :p _:x . "
             "_:x :q <d.ttl> .");
  suite.File("q.rq", test.query);
  suite.File(test.file, test.result);
  return suite.RunOne();
}

constexpr char kSelect[] = "SELECT ?v { ?s <http://h/p> ?v } ORDER BY ?v";
constexpr char kRows[] = R"(<?xml version="1.0"?>
<sparql xmlns="http://www.w3.org/2005/sparql-results#">
<head><variable name="v"/></head><results>
<result><binding name="v"><bnode>r1</bnode></binding></result>
<result><binding name="v"><literal
 datatype="http://www.w3.org/2001/XMLSchema#integer">1</literal></binding></result>
<result><binding name="v"><literal
 datatype="http://www.w3.org/2001/XMLSchema#decimal">2.0</literal></binding></result>
</results></sparql>)";

std::string Replaced(std::string text, const std::string& from,
                     const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string RowsInTurtle(const char* first, const char* second,
                         const char* third) {
  return kResultPrefixes +
         ("[] a rs:ResultSet ; rs:resultVariable \"v\" ; rs:solution " +
          ("[ rs:index 1 ; rs:binding [ rs:variable \"v\" ; rs:value " +
           std::string(first)) +
          " ] ] , [ rs:index 2 ; rs:binding [ rs:variable \"v\" ; rs:value " +
          second + " ] ] , [ rs:index 3 ; rs:binding [ rs:variable \"v\" ; " +
          "rs:value " + third + " ] ] .");
}

TEST(Conformance, ComparesRowsAsABagUpToBlankNodes) {
  EXPECT_EQ(RunQueryCase({kSelect, "r.srx", kRows}).outcome, Outcome::kPassed);
  const std::string wrong = Replaced(kRows, ">1<", ">3<");
  const ConformanceTest failed = RunQueryCase({kSelect, "r.srx", wrong});
  EXPECT_EQ(failed.outcome, Outcome::kFailed);
  EXPECT_EQ(failed.message, "got 3 rows, expected 3; lacks {?v 3}");
  const std::string other = Replaced(kRows, "name=\"v\"/", "name=\"w\"/");
  EXPECT_EQ(RunQueryCase({kSelect, "r.srx", other}).outcome, Outcome::kFailed);
}

TEST(Conformance, ReadsResultsInEveryFormat) {
  EXPECT_EQ(
      RunQueryCase({kSelect, "r.csv", "v\r\n_:a\r\n1\r\n2.0\r\n"}).message, "");
  EXPECT_EQ(RunQueryCase({kSelect, "r.csv", "v\r\n_:a\r\n1\r\n2\r\n"}).outcome,
            Outcome::kFailed);
  EXPECT_EQ(RunQueryCase({kSelect, "r.tsv", "?v\n_:a\n1\n2.0\n"}).message, "");
  EXPECT_EQ(RunQueryCase(
                {"ASK { ?s ?p 1 }", "r.srj", R"({"head":{},"boolean":true})"})
                .message,
            "");
  EXPECT_EQ(RunQueryCase(
                {"ASK { ?s ?p 1 }", "r.srj", R"({"head":{},"boolean":false})"})
                .message,
            "got yes");
  EXPECT_EQ(RunQueryCase({"ASK { ?s ?p 1 }", "r.ttl",
                          std::string(kResultPrefixes) +
                              "[] a rs:ResultSet ; rs:boolean true ."})
                .message,
            "");
  const char* construct =
      "CONSTRUCT { ?v <http://h/r> <x> } { ?s ?p ?v "
      "FILTER(isBlank(?v)) }";
  EXPECT_EQ(RunQueryCase({construct, "r.ttl", "[] <http://h/r> <x> ."}).message,
            "");
  EXPECT_EQ(
      RunQueryCase({construct, "r.ttl", "[] <http://h/r> <../x> ."}).outcome,
      Outcome::kFailed);
  EXPECT_EQ(RunQueryCase({Replaced(construct, "<x>", "<http://h/x>"), "r.nt",
                          "_:z <http://h/r> <http://h/x> .\n"})
                .message,
            "");
}

TEST(Conformance, SeesTheOrderThatAResultNumbers) {
  EXPECT_EQ(
      RunQueryCase({kSelect, "r.ttl", RowsInTurtle("[]", "1", "2.0")}).message,
      "");
  EXPECT_EQ(
      RunQueryCase({kSelect, "r.ttl", RowsInTurtle("[]", "2.0", "1")}).message,
      "got 3 rows, expected 3; differs in blank nodes or order");
}

TEST(Conformance, ReadsWhatFromNamesAndRelativeIris) {
  Suite suite;
  suite.Manifest(
      "a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ] ; "
      "mf:result <r.srj>");
  suite.File("q.rq",
             "SELECT ?g ?o FROM <d.ttl> FROM NAMED <more/e.ttl> { ?s "
             "<http://h/p> ?o GRAPH ?g { ?o <http://h/p> <e.ttl> } }");
  suite.File("d.ttl", "<a> <http://h/p> <more/b> .");
  suite.File("more/e.ttl", "<b> <http://h/p> <../e.ttl> .");
  std::string folder = std::filesystem::canonical(suite.Path(""));
  folder = "file://" + Replaced(folder, "a suite", "a%20suite") + "/";
  suite.File("r.srj",
             R"({"head":{"vars":["g","o"]},"results":{"bindings":[
             {"g":{"type":"uri","value":")" +
                 folder + R"(more/e.ttl"},"o":{"type":"uri","value":")" +
                 folder + R"(more/b"}}]}})");
  EXPECT_EQ(suite.RunOne().message, "");
}

TEST(Conformance, LetsReducedKeepAnyNumberOfDuplicates) {
  const auto run = [](const std::string& query) {
    Suite suite;
    suite.Manifest(
        "a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ; qt:data "
        "<d.ttl> ] ; mf:resultCardinality mf:LaxCardinality ; mf:result "
        "<r.csv>");
    suite.File("d.ttl", "<a> <http://h/p> 1 . <b> <http://h/p> 1 .");
    suite.File("q.rq", query);
    suite.File("r.csv", "v\n1\n1\n");
    return suite.RunOne().outcome;
  };
  EXPECT_EQ(run("SELECT REDUCED ?v { ?s ?p ?v }"), Outcome::kPassed);
  EXPECT_EQ(run("SELECT DISTINCT ?v { ?s ?p ?v }"), Outcome::kPassed);
  EXPECT_EQ(run("SELECT ?v { { ?s ?p ?v } UNION { ?s ?p ?v } }"),
            Outcome::kFailed);
  EXPECT_EQ(run("SELECT ?v { VALUES ?v { 2 } }"), Outcome::kFailed);
}

TEST(Conformance, RunsUpdates) {
  const auto run = [](const std::string& update) {
    Suite suite;
    suite.Manifest(
        "a mf:UpdateEvaluationTest ; mf:action [ ut:request <u.ru> ; ut:data "
        "<d.ttl> ; ut:graphData [ ut:graph <d.ttl> ; <http://www.w3.org/2000/01"
        "/rdf-schema#label> \"http://h/g\" ] ] ; mf:result [ ut:result "
        "ut:success ; ut:graphData [ ut:graph <d.ttl> ; <http://www.w3.org/2000"
        "/01/rdf-schema#label> \"http://h/g\" ] ]");
    suite.File("d.ttl", "<http://h/a> <http://h/p> [] .");
    suite.File("u.ru", update);
    return suite.RunOne().message;
  };
  EXPECT_EQ(run("DROP DEFAULT"), "");
  EXPECT_EQ(run("DROP ALL").rfind("got 0 triples, expected 1; lacks ", 0), 0u);
  EXPECT_NE(run("LOAD <d.ttl>"), "");
}

TEST(Conformance, RunsSyntaxTests) {
  const auto run = [](const std::string& kind, const std::string& file,
                      const std::string& text) {
    Suite suite;
    suite.Manifest("a mf:" + kind + " ; mf:action <" + file + ">");
    suite.File(file, text);
    return suite.RunOne().outcome;
  };
  for (const char* version : {"", "11"}) {
    const std::string good = std::string("PositiveSyntaxTest") + version;
    const std::string bad = std::string("NegativeSyntaxTest") + version;
    EXPECT_EQ(run(good, "q.rq",
                  "\xEF\xBB\xBF"
                  "ASK {}"),
              Outcome::kPassed);
    EXPECT_EQ(run(good, "q.rq", "ASK {"), Outcome::kFailed);
    EXPECT_EQ(run(bad, "q.rq", "ASK {"), Outcome::kPassed);
    EXPECT_EQ(run(bad, "q.rq", "ASK {}"), Outcome::kFailed);
    EXPECT_EQ(run(bad, "q.rq", "DROP ALL"), Outcome::kPassed);
    EXPECT_EQ(run(good, "u.ru", "DROP ALL"), Outcome::kPassed);
  }
  EXPECT_EQ(run("PositiveUpdateSyntaxTest11", "u", ""), Outcome::kPassed);
  EXPECT_EQ(run("NegativeUpdateSyntaxTest11", "u", "ASK {}"), Outcome::kPassed);
}

TEST(Conformance, RunsTestsOfShacl) {
  const auto run = [](const std::string& shape, const std::string& result) {
    Suite suite;
    suite.File("manifest.ttl",
               std::string(kPrefixes) +
                   "<> a mf:Manifest ; mf:entries ( <t> ) . ex:s a "
                   "sh:NodeShape ; sh:targetNode 5 ; sh:message \"no\"@en ; " +
                   shape +
                   " . <t> a sht:Validate ; mf:action [ sht:dataGraph <> ; "
                   "sht:shapesGraph <> ] ; mf:result " +
                   result + " .");
    return suite.RunOne();
  };
  const std::string one =
      "[ a sh:ValidationReport ; sh:conforms false ; sh:result [ a "
      "sh:ValidationResult ; sh:focusNode 5 ; sh:value 5 ; sh:sourceShape ex:s "
      "; sh:resultMessage \"no\"@en ; sh:resultSeverity sh:Violation ; "
      "sh:sourceConstraintComponent sh:DatatypeConstraintComponent ] ]";
  EXPECT_EQ(run("sh:datatype xsd:string", one).message, "");
  EXPECT_EQ(
      run("sh:datatype xsd:string", Replaced(one, "\"no\"", "\"yes\"")).message,
      "lacks \"yes\"@en");
  EXPECT_EQ(run("sh:datatype xsd:integer", one).message,
            "sh:conforms is to be false");
  EXPECT_EQ(run("sh:nodeKind sh:IRI", one).outcome, Outcome::kFailed);
  EXPECT_EQ(run("sh:datatype 5", "sht:Failure").outcome, Outcome::kPassed);
  EXPECT_EQ(run("sh:datatype xsd:string", "sht:Failure").outcome,
            Outcome::kFailed);
  EXPECT_EQ(run("sh:sparql [ sh:select \"\" ]", one).outcome, Outcome::kNotRun);
}

TEST(Conformance, SaysWhyATestIsNotRun) {
  const std::pair<const char*, const char*> kCases[] = {
      {"a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ; "
       "sd:entailmentRegime ent:RDFS ]",
       "needs an entailment regime"},
      {"a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ; "
       "qt:serviceData [] ]",
       "needs a SPARQL endpoint to federate with"},
      {"a mf:ProtocolTest", "no request is known for this test"},
      {"a mf:GraphStoreProtocolTest", "needs a SPARQL server"},
      {"a mf:SomeOtherTest", "no test of SPARQL, SHACL or an RDF syntax"},
      {"a mf:PositiveSyntaxTest ; mf:action <http://h/q.rq>",
       "needs <http://h/q.rq> from the network"},
  };
  for (const auto& [test, reason] : kCases) {
    Suite suite;
    suite.Manifest(test);
    suite.File("q.rq", "ASK {}");
    const ConformanceTest done = suite.RunOne();
    EXPECT_EQ(done.outcome, Outcome::kNotRun) << test;
    EXPECT_EQ(done.message, reason);
  }
}

TEST(Conformance, CountsWhatIsMissingOrBrokenAsFailed) {
  const char* kBroken[] = {
      "a mf:PositiveSyntaxTest ; mf:action <none.rq>",
      "a mf:NegativeSyntaxTest ; mf:action <none.rq>",
      "a mf:PositiveSyntaxTest",
      "a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ]",
      "a mf:QueryEvaluationTest ; mf:action [ qt:query <q.rq> ; qt:data "
      "<none.ttl> ] ; mf:result <none.srx>",
  };
  for (const char* test : kBroken) {
    Suite suite;
    suite.Manifest(test);
    suite.File("q.rq", "ASK {}");
    EXPECT_EQ(suite.RunOne().outcome, Outcome::kFailed) << test;
  }
  Suite suite;
  suite.File("manifest.ttl", "no turtle");
  EXPECT_EQ(suite.RunOne().outcome, Outcome::kFailed);
}

TEST(Conformance, FollowsManifestsOnceInOrder) {
  Suite suite;
  suite.File("q.rq", "ASK {}");
  suite.File("manifest.ttl",
             std::string(kPrefixes) +
                 "<> a mf:Manifest ; mf:include ( <more/manifest-b.ttl> "
                 "<tests.ttl> ) ; mf:entries ( [ mf:name \"no type\" ; "
                 "mf:action [ qt:query <q.rq> ] ] ) .");
  suite.File("tests.ttl",
             std::string(kPrefixes) +
                 "<> a mf:Manifest ; mf:include <manifest.ttl> ; mf:entries ( "
                 ":z :y ) . :z a mf:PositiveSyntaxTest ; mf:action <q.rq> . :y "
                 "a mf:PositiveSyntaxTest ; mf:action <q.rq> . :left_out a "
                 "mf:PositiveSyntaxTest ; mf:action <q.rq> .");
  suite.File("more/manifest-b.ttl",
             std::string(kPrefixes) +
                 "<> a mf:Manifest ; mf:entries ( :x ) . :x a "
                 "mf:PositiveSyntaxTest ; mf:action [ qt:query <../q.rq> ] .");
  std::string seen;
  const auto tests =
      RunConformance(suite.Path(""), [&](const ConformanceTest& test) {
        seen += test.group + "/" + test.name + " " + test.kind + "\n";
      });
  EXPECT_EQ(seen,
            "more/x PositiveSyntaxTest\na suite/z PositiveSyntaxTest\n"
            "a suite/y PositiveSyntaxTest\na suite/no type "
            "QueryEvaluationTest\n");
  EXPECT_EQ(CountOutcomes(tests).passed, 3);
  EXPECT_EQ(CountOutcomes(tests).failed, 1);
  EXPECT_EQ(RunConformance(suite.Path("tests.ttl")).size(), 4u);
  EXPECT_EQ(ConformanceTable(tests),
            "| group | tests | passed | deviate | not run | failed |\n"
            "|---|---|---|---|---|---|\n"
            "| a suite | 3 | 2 | 0 | 0 | 1 |\n| more | 1 | 1 | 0 | 0 | 0 |\n"
            "| all | 4 | 3 | 0 | 0 | 1 |\n\n## Tests that have not passed\n\n"
            "| group | test | outcome | reason |\n|---|---|---|---|\n"
            "| a suite | no type | **failed** | the test has no mf:result |\n");
}

TEST(Conformance, StatesReasonsOfKnownDeviations) {
  const auto run = [](const std::string& query, const std::string& list) {
    Suite suite;
    suite.Manifest("a mf:PositiveSyntaxTest ; mf:action <q.rq>");
    suite.File("q.rq", query);
    suite.File("deviations.txt", list);
    const KnownDeviations known = ReadDeviations(suite.Path("deviations.txt"));
    return RunConformance(
               suite.Path(""), [](const ConformanceTest&) {}, known)
        .at(0);
  };
  const std::string list =
      "# why\n\nhttp://tests.example/manifest#t so it is\n";
  EXPECT_EQ(run("ASK {", list).outcome, Outcome::kDeviates);
  EXPECT_EQ(run("ASK {", list).message, "so it is");
  EXPECT_EQ(run("ASK {}", list).outcome, Outcome::kFailed);
  EXPECT_EQ(run("ASK {", "http://other/t so it is").outcome, Outcome::kFailed);
  for (const char* bad :
       {"http://h/t", "http://h/t ", "http://h/t a\nhttp://h/t b"}) {
    EXPECT_THROW(run("ASK {}", bad), InputError) << bad;
  }
}

TEST(Conformance, RunsTestsOfRdfSyntaxes) {
  const auto run = [](const std::string& kind, const std::string& text,
                      const std::string& result = "") {
    Suite suite;
    suite.Manifest("a <http://www.w3.org/ns/rdftest#" + kind +
                   "> ; mf:action <in> ; mf:result <out.nq>");
    suite.File("in", text);
    suite.File("out.nq", result);
    return suite.RunOne().outcome;
  };
  const std::string one = "<http://h/s> <http://h/p> <http://h/o>";
  EXPECT_EQ(run("TestTurtleEval", one + " .", one + " ."), Outcome::kPassed);
  EXPECT_EQ(run("TestTurtleEval", one + " ; <http://h/q> 1 .", one + " ."),
            Outcome::kFailed);
  EXPECT_EQ(run("TestTurtleEval", "<s> <http://h/p> <> .",
                "<http://www.w3.org/2013/TurtleTests/s> <http://h/p> "
                "<http://www.w3.org/2013/TurtleTests/in> ."),
            Outcome::kPassed);
  EXPECT_EQ(run("TestTrigEval", "_:g { " + one + " }", one + " _:x ."),
            Outcome::kPassed);
  EXPECT_EQ(run("TestTrigEval", "_:g { " + one + " }", one + " ."),
            Outcome::kFailed);
  for (const char* syntax : {"Turtle", "Trig", "NTriples", "NQuads"}) {
    const std::string kind = std::string("Test") + syntax;
    EXPECT_EQ(run(kind + "PositiveSyntax", one + " .\n"), Outcome::kPassed);
    EXPECT_EQ(run(kind + "PositiveSyntax", one + " ;"), Outcome::kFailed);
    EXPECT_EQ(run(kind + "NegativeSyntax", one + " ;"), Outcome::kPassed);
    EXPECT_EQ(run(kind + "NegativeSyntax", one + " .\n"), Outcome::kFailed);
    const std::string nul =
        "<http://h/s> <http://h/p> \"" + std::string(1, '\0');
    EXPECT_EQ(run(kind + "PositiveSyntax", nul + "\" .\n"), Outcome::kNotRun);
    EXPECT_EQ(run(kind + "NegativeSyntax", nul + " .\n"), Outcome::kPassed);
  }
  EXPECT_EQ(run("TestXMLEval", "<a/>"), Outcome::kNotRun);
}

TEST(Conformance, RunsNothingThatWasWithdrawn) {
  Suite suite;
  suite.Manifest(
      "a mf:PositiveSyntaxTest ; mf:action <q.rq> ; dawgt:approval "
      "dawgt:Withdrawn");
  suite.File("q.rq", "ASK {}");
  EXPECT_EQ(suite.RunOne().outcome, Outcome::kNotRun);
}

TEST(Conformance, AsksAnEndpoint) {
  const auto run = [](const std::string& kind, const std::string& name) {
    Suite suite;
    suite.Manifest("a mf:" + kind);
    suite.File("manifest.ttl",
               kPrefixes + ("<> a mf:Manifest ; mf:entries ( :" + name +
                            " ) . :" + name + " a mf:" + kind + " ."));
    return suite.RunOne().outcome;
  };
  EXPECT_EQ(run("ProtocolTest", "query_multiple_dataset"), Outcome::kPassed);
  EXPECT_EQ(run("ProtocolTest", "update_dataset_full"), Outcome::kPassed);
  EXPECT_EQ(run("ProtocolTest", "bad_query_non_utf8"), Outcome::kPassed);
  EXPECT_EQ(run("ServiceDescriptionTest", "conforms-to-schema"),
            Outcome::kPassed);
  EXPECT_EQ(run("ProtocolTest", "other"), Outcome::kNotRun);
}

TEST(Conformance, RefusesAFolderWithoutAManifest) {
  Suite suite;
  EXPECT_THROW(RunConformance(suite.Path("")), InputError);
  EXPECT_THROW(RunConformance(suite.Path("none")), InputError);
}

// https://www.w3.org/TR/rdf-syntax-grammar/
TEST(RdfXml, SaysTheSameAsTurtle) {
  const kg_core::Term graph = kg_core::Iri("http://h/g");
  const kg_core::RdfSource source{"x.rdf", graph, "http://h/d/x.rdf"};
  const std::string xml =
      R"(<?xml version="1.0"?><!-- x --><rdf:RDF
xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" xmlns="http://e/"
xmlns:e="http://example.org/mission/" xml:lang="en">
<rdf:Description rdf:about="a" e:p="at&lt;tribute"><e:q>text</e:q>
<e:q rdf:datatype="http://www.w3.org/2001/XMLSchema#integer">5</e:q>
<e:q rdf:resource="../b"/><e:q rdf:nodeID="n"/><e:q><C rdf:nodeID="n"/></e:q>
<e:r rdf:parseType="Resource"><e:q xml:lang="">plain</e:q></e:r>
<e:l rdf:parseType="Collection"><e:D rdf:ID="i"/><rdf:Description/></e:l>
<e:s e:t="u"/></rdf:Description>
<rdf:Seq><rdf:li>1</rdf:li><rdf:li rdf:resource=""/></rdf:Seq></rdf:RDF>)";
  const std::string turtle =
      "<a> ex:p 'at<tribute'@en ; ex:q 'text'@en, 5, <../b>, _:n ; ex:r [ ex:q "
      "'plain' ] ; ex:l ( <#i> [] ) ; ex:s [ ex:t 'u'@en ] . _:n a "
      "<http://e/C> "
      ". <#i> a ex:D . [] a rdf:Seq ; rdf:_1 '1'@en ; rdf:_2 <> .";
  const auto got = ParseRdfXml(xml, source);
  const auto want =
      kg_core::ParseRdf(turtle, kg_core::RdfSyntax::kTurtle, source);
  EXPECT_TRUE(kg_core::IsIsomorphic(got, want));
  for (const char* bad :
       {"<!DOCTYPE a><a/>", "<x:a/>", "<a", "text",
        "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"}) {
    { EXPECT_THROW(ParseRdfXml(bad, source), InputError) << bad; }
  }
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a xmlns='http://e/'>";
  EXPECT_THROW(ParseRdfXml(deep, source), InputError);
}

}  // namespace
}  // namespace kg_engine
