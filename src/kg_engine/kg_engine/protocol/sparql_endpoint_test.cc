#include "kg_engine/protocol/sparql_endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "kg_base/common/input_error.h"
#include "kg_engine/protocol/testing/endpoint_fixture.h"

namespace kg_engine {
namespace {

using testing::HasSubstr;
using testing::Not;

// SPARQL Protocol: all ways to send a query.
TEST_F(SparqlEndpointTest, AnswersAQueryHoweverItIsSent) {
  const HttpRequest ways[] = {
      Ask(kAgents),
      Send("POST", "/sparql", kForm, Field("query", kAgents)),
      Send("POST", "/sparql",
           "application/x-www-form-urlencoded; charset=UTF-8",
           Field("query", kAgents)),
      Send("POST", "/sparql", kQuery, kAgents),
      Send("POST", "/sparql", "Application/SPARQL-Query;charset=\"utf-8\"",
           kAgents),
      Get("/sparql", "query=SELECT+?a+{+?a+a+ex:Agent+}+ORDER+BY+?a"),
      Get("/sparql", "format=json&" + Field("query", kAgents)),
  };
  for (const HttpRequest& request : ways) {
    const HttpResponse response = Answer(request);
    EXPECT_EQ(response.status, 200) << response.body;
    EXPECT_EQ(response.content_type, "application/sparql-results+json");
    const kg_core::QueryResult result = kg_core::ReadJsonResult(response.body);
    ASSERT_EQ(result.rows.size(), 2u);
    EXPECT_EQ(result.rows[0][0]->text, std::string(kg_core::kEx) + "alpha");
  }
}

// The protocol's negative cases, and similar ones.
TEST_F(SparqlEndpointTest, RefusesWhatTheProtocolDoesNotKnow) {
  const std::string facts_before = Facts();
  HttpRequest two = Send("POST", "/sparql", kQuery, kAgents);
  two.query = Field("query", kAgents);
  const std::string utf16("A\0S\0K\0 \0{\0}\0\xFF\xFE", 14);
  const BadRequest cases[] = {
      {"PUT", Send("PUT", "/sparql", kForm, Field("query", kAgents)), 405},
      {"DELETE", Send("DELETE", "/sparql", "", ""), 405},
      {"PATCH", Send("PATCH", "/sparql", kUpdate, "CLEAR DEFAULT"), 405},
      {"two queries", Ask(kAgents, "&" + Field("query", "ASK {}")), 400},
      {"two queries in a form",
       Send("POST", "/sparql", kForm,
            Field("query", kAgents) + "&" + Field("query", "ASK {}")),
       400},
      {"query beside a body", two, 400},
      {"a query as plain text", Send("POST", "/sparql", "text/plain", kAgents),
       415},
      {"a form without its type",
       Send("POST", "/sparql", "", Field("query", kAgents)), 415},
      {"a query without its type", Send("POST", "/sparql", "", kAgents), 415},
      {"a query in UTF-16, said so",
       Send("POST", "/sparql", std::string(kQuery) + "; charset=UTF-16", utf16),
       415},
      {"a query in UTF-16", Send("POST", "/sparql", kQuery, utf16), 400},
      {"a form that is not UTF-8",
       Send("POST", "/sparql", kForm, "query=ASK%20%7B%7D%FF"), 400},
      {"an escape that is none", Get("/sparql", "query=ASK%2"), 400},
      {"a query that is none", Ask("SELECT ?a WHERE ?a"), 400},
      {"an update as a query", Ask("CLEAR DEFAULT"), 400},
      {"an update by GET", Get("/sparql", Field("update", "CLEAR DEFAULT")),
       400},
      {"two updates",
       Send("POST", "/sparql", kForm,
            Field("update", "CLEAR DEFAULT") + "&" +
                Field("update", "CLEAR DEFAULT")),
       400},
      {"query and update",
       Send("POST", "/sparql", kForm,
            Field("update", "CLEAR DEFAULT") + "&" + Field("query", kAgents)),
       400},
      {"neither", Send("POST", "/sparql", kForm, "x=1"), 400},
      {"an update as plain text",
       Send("POST", "/sparql", "text/plain", "CLEAR DEFAULT"), 415},
      {"an update in UTF-16", Send("POST", "/sparql", kUpdate, utf16), 400},
      {"an update that is none", Change("INSERT DATA"), 400},
      {"a query as an update", Change(kAgents), 400},
      {"LOAD", Change("LOAD <file:///etc/passwd>"), 422},
      {"a compressed body",
       With(Send("POST", "/sparql", kQuery, kAgents), "content-encoding",
            "gzip"),
       415},
      {"a body too large",
       Send("POST", "/sparql", kQuery, std::string((1u << 20) + 1, ' ')), 413},
      {"a query too long", Ask(std::string(70000, ' ') + kAgents), 413},
      {"no format that is here", With(Ask(kAgents), "accept", "image/png"),
       406},
      {"rows as Turtle", With(Ask(kAgents), "accept", "text/turtle"), 406},
      {"another path", Get("/"), 404},
      {"a graph that does not exist",
       Ask(kAgents, "&" + Field("default-graph-uri", "http://nowhere/")), 400},
      {"a relative graph", Ask(kAgents, "&default-graph-uri=facts"), 400},
  };
  for (const BadRequest& bad : cases) {
    const HttpResponse response = Answer(bad.request);
    EXPECT_EQ(response.status, bad.status) << bad.what << ": " << response.body;
    EXPECT_EQ(response.content_type, kPlainText) << bad.what;
    EXPECT_GT(response.body.size(), 10u) << bad.what;
  }
  EXPECT_EQ(Facts(), facts_before);
}

TEST_F(SparqlEndpointTest, SaysWhereAMalformedQueryIsWrong) {
  const HttpResponse response = Answer(Ask("SELECT ?a\nWHERE { ?a a }"));
  EXPECT_EQ(response.status, 400);
  EXPECT_THAT(response.body, HasSubstr("2:14"));
}

TEST_F(SparqlEndpointTest, NamesTheMethodsThatAreAllowed) {
  EXPECT_EQ(Answer(Send("PUT", "/sparql", "", "")).headers.at("Allow"),
            "GET, HEAD, POST");
  EXPECT_EQ(Answer(Send("PATCH", "/graphs/facts", "", "")).headers.at("Allow"),
            "GET, HEAD, PUT, POST, DELETE");
}

struct Wish {
  const char* accept;
  const char* rows;     // Media type of the answer to a SELECT; "" = 406.
  const char* triples;  // Media type of the answer to a CONSTRUCT.
};

TEST_F(SparqlEndpointTest, GivesTheFormatThatIsLikedBest) {
  const Wish wishes[] = {
      {"", "application/sparql-results+json", "text/turtle; charset=utf-8"},
      {"*/*", "application/sparql-results+json", "text/turtle; charset=utf-8"},
      {"application/sparql-results+xml, application/rdf+xml",
       "application/sparql-results+xml", "application/rdf+xml"},
      {"text/csv", "text/csv; charset=utf-8", ""},
      {"text/tab-separated-values;q=0.4, text/csv;q=0.3",
       "text/tab-separated-values; charset=utf-8", ""},
      {"application/json, application/n-triples", "application/json",
       "application/n-triples"},
      {"text/html, application/xml;q=0.9, */*;q=0.8", "application/xml",
       "text/turtle; charset=utf-8"},
      {"*/*, application/sparql-results+json;q=0, text/turtle;q=0",
       "application/sparql-results+xml", "application/n-triples"},
      {"text/*;q=0.5, text/csv;q=0.1",
       "text/tab-separated-values; charset=utf-8",
       "text/turtle; charset=utf-8"},
      {"TEXT/CSV , text/turtle", "text/csv; charset=utf-8",
       "text/turtle; charset=utf-8"},
      {"*/*;q=0", "", ""},
      {"*/*;q=nonsense", "", ""},
      {"application/trig", "", ""},
  };
  const auto type = [this](const char* query, const char* accept) {
    const HttpResponse response = Answer(With(Ask(query), "accept", accept));
    return response.status == 406 ? "" : response.content_type;
  };
  for (const Wish& wish : wishes) {
    EXPECT_EQ(type(kAgents, wish.accept), wish.rows) << wish.accept;
    EXPECT_EQ(type("ASK { ?a a ex:Agent }", wish.accept), wish.rows)
        << wish.accept;
    EXPECT_EQ(type("DESCRIBE ex:alpha", wish.accept), wish.triples)
        << wish.accept;
  }
}

// https://www.w3.org/TR/sparql11-protocol/#dataset
TEST_F(SparqlEndpointTest, LetsARequestChooseTheGraphs) {
  const std::string vocab =
      "&" + Field("default-graph-uri", kg_core::kVocabGraph);
  const std::string facts =
      "&" + Field("default-graph-uri", kg_core::kFactsGraph);
  const std::string named =
      "&" + Field("named-graph-uri", kg_core::kFactsGraph);
  const auto asks = [this](const std::string& pattern,
                           const std::string& graphs) {
    return kg_core::ReadJsonResult(Answer(Ask("ASK " + pattern, graphs)).body)
        .answer;
  };
  const std::string agent = "{ ?a a ex:Agent }";
  EXPECT_TRUE(asks(agent, ""));
  EXPECT_TRUE(asks(agent, facts));
  EXPECT_FALSE(asks(agent, vocab));
  EXPECT_TRUE(asks(agent, vocab + facts));
  EXPECT_FALSE(asks(agent, named));  // The default graph is empty then.
  EXPECT_TRUE(asks("{ GRAPH ?g { ?a a ex:Agent } }", named));
  EXPECT_FALSE(asks("{ GRAPH ?g { ?a a ex:Agent } }", facts));
  EXPECT_FALSE(asks("{ GRAPH graph:vocab { ?s ?p ?o } }", facts + named));
  // The request overrides the query.
  EXPECT_TRUE(asks("FROM graph:vocab " + agent, facts));
  EXPECT_FALSE(asks("FROM graph:facts " + agent, vocab));
  EXPECT_TRUE(asks("FROM <http://nowhere/> " + agent, facts));
}

TEST_F(SparqlEndpointTest, UpdatesFactsAndRecordsTheAuthor) {
  const std::uint64_t before = world_.store.world_version();
  const HttpResponse response =
      Answer(With(Change("DELETE { ?a ex:usesPolicy ?p } "
                         "INSERT { ?a ex:usesPolicy ex:safe } "
                         "WHERE { ?a ex:id 'bravo' ; ex:usesPolicy ?p }"),
                  "from", "operator@ship"));
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(response.body,
            "world version " + std::to_string(before + 1) + "\n");
  EXPECT_EQ(Value("SELECT ?p { ex:bravo ex:usesPolicy ?p }"),
            std::string(kg_core::kEx) + "safe");
  EXPECT_EQ(authors_, std::vector<std::string>{"operator@ship"});

  const HttpRequest form =
      Send("POST", "/sparql", kForm,
           Field("update",
                 "INSERT DATA { ex:seep2 a ex:Event ; ex:forWindow ex:w0 ;"
                 " ex:value 3 ; geo:asWKT 'POINT(-93 27)'^^geo:wktLiteral }"));
  EXPECT_EQ(Answer(With(form, "from", "two\nlines")).body,
            "world version " + std::to_string(before + 2) + "\n");
  EXPECT_EQ(authors_.back(), "http");
  EXPECT_EQ(Value("SELECT ?v { ex:seep2 ex:value ?v }"), "3");
}

TEST_F(SparqlEndpointTest, RefusesAnUpdateWithTheReasons) {
  const std::string before = Facts();
  const HttpResponse shape =
      Answer(Change("INSERT DATA { ex:w0 ex:confidence 1.2 }"));
  EXPECT_EQ(shape.status, 422);
  EXPECT_THAT(shape.body, HasSubstr("ex:confidence"));
  const HttpResponse graph =
      Answer(Change("INSERT DATA { GRAPH graph:vocab { ex:x a ex:Agent } }"));
  EXPECT_EQ(graph.status, 422);
  EXPECT_THAT(graph.body, HasSubstr("graph:vocab may not be changed"));
  EXPECT_EQ(Facts(), before);
}

// https://www.w3.org/TR/sparql11-protocol/#update-dataset
TEST_F(SparqlEndpointTest, LetsAnUpdateChooseTheGraphsItReads) {
  const std::string copy =
      "INSERT { ex:alpha_can ex:energyPerKm 3 } "
      "WHERE { ?a a ex:Agent ; ex:id 'alpha' } ;"
      "DELETE { ex:alpha_can ex:energyPerKm 2 } "
      "WHERE { ?a a ex:Agent ; ex:id 'alpha' }";
  HttpRequest vocab = Change(copy);
  vocab.query = Field("using-graph-uri", kg_core::kVocabGraph);
  EXPECT_EQ(Answer(vocab).status, 200);
  EXPECT_EQ(Value("SELECT ?v { ex:alpha_can ex:energyPerKm ?v }"), "2");
  HttpRequest facts = Send("POST", "/sparql", kForm,
                           Field("update", copy) + "&" +
                               Field("using-graph-uri", kg_core::kFactsGraph));
  EXPECT_EQ(Answer(facts).status, 200);
  EXPECT_EQ(Value("SELECT ?v { ex:alpha_can ex:energyPerKm ?v }"), "3");

  for (const char* chooses :
       {"WITH graph:facts DELETE { ?a ?b ?c } WHERE { ?a ?b ?c }",
        "DELETE { ?a ?b ?c } USING graph:facts WHERE { ?a ?b ?c }",
        "DELETE { ?a ?b ?c } USING NAMED graph:facts WHERE { ?a ?b ?c }"}) {
    HttpRequest both = Change(chooses);
    both.query = Field("using-named-graph-uri", kg_core::kFactsGraph);
    EXPECT_EQ(Answer(both).status, 400) << chooses;
  }
}

TEST_F(SparqlEndpointTest, EndsAHostileQueryWithinItsLimits) {
  EndpointOptions options{kToken, false, {}, 1u << 20};
  options.limits.seconds = 0.05;
  const SparqlEndpoint endpoint(StoreOfTheWorld(), options);
  const HttpResponse response = endpoint.Answer(
      With(Ask("SELECT (COUNT(*) AS ?n) { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i }"),
           "authorization", std::string("bearer ") + kToken));
  EXPECT_EQ(response.status, 503);
  EXPECT_THAT(response.body, HasSubstr("longer than the limit of 0.05 s"));
}

TEST_F(SparqlEndpointTest, DescribesItself) {
  const HttpResponse response =
      Answer(With(Get("/sparql"), "host", "localhost:8080"));
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body, HasSubstr("<http://localhost:8080/sparql>"));
  EXPECT_THAT(response.body, HasSubstr("SPARQL11Update"));
  kg_core::Store store("");
  kg_core::Transaction description = store.Begin();
  for (const kg_core::Statement& statement : kg_core::ParseTurtle(
           response.body, "description", kg_core::Iri("ex:d"))) {
    description.Add(statement);
  }
  description.Commit(kg_core::WorldChange::kYes);
  EXPECT_GT(store.quad_count(), 20u);
}

TEST_F(SparqlEndpointTest, GivesRdfXmlThatKeepsEveryCharacter) {
  const HttpResponse response = Answer(
      With(Ask("CONSTRUCT { ex:a ex:p 'x < \"y\" & z\\r', 'fr'@fr-be, 4 ; "
               "ex:q _:b . _:b ex:p ex:a } {}"),
           "accept", "application/rdf+xml"));
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_THAT(response.body,
              HasSubstr("x &lt; &quot;y&quot; &amp; z&#13;</p:p>"));
  EXPECT_THAT(response.body, HasSubstr("xml:lang=\"fr-be\""));
  EXPECT_THAT(response.body, HasSubstr("rdf:nodeID=\"n"));
  const HttpResponse nameless =
      Answer(With(Ask("CONSTRUCT { ex:a <http://example.org/1> 1 } {}"),
                  "accept", "application/rdf+xml"));
  EXPECT_EQ(nameless.status, 406);
}

// Access ----------------------------------------------------------------------

TEST_F(SparqlEndpointTest, AsksForItsToken) {
  const char* wrong[] = {"",
                         "Bearer",
                         "Bearer ",
                         "Bearer wrong",
                         "Basic correct horse battery staple",
                         "correct horse battery staple",
                         "Bearer correct horse battery staple!",
                         "Bearer correct horse battery stapl"};
  for (const char* header : wrong) {
    for (const HttpRequest& request :
         {Ask(kAgents), Get("/graphs/facts"), Get("/nothing"),
          Send("DELETE", "/graphs/facts", "", "")}) {
      const HttpResponse response =
          endpoint_.Answer(With(request, "authorization", header));
      EXPECT_EQ(response.status, 401) << header;
      EXPECT_EQ(response.headers.at("WWW-Authenticate"), "Bearer");
      EXPECT_THAT(response.body, Not(HasSubstr("horse")));
    }
  }
}

TEST_F(SparqlEndpointTest, IsReadOnlyByDefault) {
  const SparqlEndpoint endpoint(StoreOfTheWorld(), {});
  EXPECT_EQ(endpoint.Answer(Ask(kAgents)).status, 200);
  const std::string before = Facts();
  for (const HttpRequest& request :
       {Change("CLEAR DEFAULT"), Send("DELETE", "/graphs/facts", "", ""),
        Send("PUT", "/graphs/facts", "text/turtle", ""),
        Send("POST", "/graphs/facts", "text/turtle", "ex:a a ex:Event .")}) {
    EXPECT_EQ(endpoint.Answer(request).status, 403);
  }
  EXPECT_EQ(Facts(), before);
  EXPECT_TRUE(authors_.empty());
}

TEST_F(SparqlEndpointTest, IsNotWritableByEverybody) {
  EXPECT_THROW(SparqlEndpoint(StoreOfTheWorld(), {"", true, {}, 1000}),
               kg_base::InputError);
}

TEST_F(SparqlEndpointTest, AnswersNoOtherHostWithoutAToken) {
  const SparqlEndpoint endpoint(StoreOfTheWorld(), {});
  for (const char* host :
       {"localhost", "LocalHost:80", "127.0.0.1:8080", "[::1]:8080"}) {
    EXPECT_EQ(endpoint.Answer(With(Ask(kAgents), "host", host)).status, 200)
        << host;
  }
  for (const char* host : {"evil.example", "localhost.evil.example",
                           "127.0.0.1.evil.example:80", "[::2]:80"}) {
    EXPECT_EQ(endpoint.Answer(With(Ask(kAgents), "host", host)).status, 421)
        << host;
  }
}

TEST_F(SparqlEndpointTest, LetsNoOtherPageIn) {
  for (const char* method : {"GET", "OPTIONS"}) {
    HttpRequest request = Ask(kAgents);
    request.method = method;
    const HttpResponse response =
        Answer(With(request, "origin", "http://evil.example"));
    for (const auto& [name, value] : response.headers) {
      EXPECT_THAT(name, Not(HasSubstr("Access-Control"))) << value;
    }
  }
  EXPECT_EQ(Answer(Send("OPTIONS", "/sparql", "", "")).status, 405);
}

TEST_F(SparqlEndpointTest, ReportsAnUpdateWithoutADecision) {
  EndpointStore store = StoreOfTheWorld();
  store.update = [](const kg_core::FactUpdate&) { return UpdateVerdict{}; };
  const SparqlEndpoint endpoint(store, {kToken, true, {}, 1000});
  const HttpResponse response =
      endpoint.Answer(With(Change("INSERT DATA {}"), "authorization",
                           std::string("Bearer ") + kToken));
  EXPECT_EQ(response.status, 503);
}

// Readers on several threads while facts change: every answer is from a
// committed world, in which both agents have the same policy.
TEST_F(SparqlEndpointTest, AnswersManyAtOnceWhileFactsChange) {
  const std::string set =
      "DELETE { ?a ex:usesPolicy ?p } INSERT { ?a ex:usesPolicy ex:%s } "
      "WHERE { ?a a ex:Agent ; ex:usesPolicy ?p }";
  const auto choose = [&](const char* policy) {
    std::string update = set;
    update.replace(update.find("%s"), 2, policy);
    return Answer(Change(update)).status;
  };
  ASSERT_EQ(choose("safe"), 200);
  std::atomic<bool> done{false};
  std::atomic<int> answers{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < 8; ++i) {
    readers.emplace_back([&] {
      while (!done || answers < 100) {
        EXPECT_EQ(Value("SELECT (COUNT(DISTINCT ?p) AS ?n) "
                        "{ ?a ex:usesPolicy ?p }"),
                  "1");
        ++answers;
      }
    });
  }
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(choose(i % 2 == 0 ? "fast" : "safe"), 200);
  }
  done = true;
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace kg_engine
