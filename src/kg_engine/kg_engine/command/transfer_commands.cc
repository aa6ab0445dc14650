// kg export TARGET, kg import STORE FILE...

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/command/change.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"

namespace kg_engine::command {
namespace {

using kg_base::InputError;
using kg_core::RdfSyntaxName;
using kg_core::Statement;

// Graph IRI from "graph:facts", "<iri>" or "http://...".
std::string GraphIri(const std::string& text) {
  if (text.find("://") != std::string::npos && text[0] != '<') return text;
  const kg_core::Term term = kg_core::ParseTurtleTerm(text);
  if (term.is_iri()) return term.text;
  throw UsageError("expected the IRI of a graph, not " + text);
}

const RdfSyntaxName& SyntaxOf(const Arguments& arguments) {
  const auto name = arguments.One("--format");
  const auto file = arguments.One("-o");
  const RdfSyntaxName* syntax =
      name ? kg_core::SyntaxNamed(*name)
           : kg_core::SyntaxOfPath(file.value_or(".trig"));
  if (syntax != nullptr) return *syntax;
  throw UsageError(
      "expected --format turtle, trig, ntriples or nquads, or a file that ends "
      "in .ttl, .trig, .nt or .nq");
}

// Writes atomically, so that an interrupted export leaves no partial file.
void WriteFile(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  if (!out || std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());
    throw InputError(path + ": cannot be written");
  }
}

int RunExport(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "one TARGET");
  const RdfSyntaxName& syntax = SyntaxOf(arguments);
  const Target target =
      OpenTarget(arguments.words[0], arguments.One("--data").value_or(""));
  const auto view = target.store->Read();
  kg_core::RdfSelection selection;
  for (const std::string& graph : arguments.All("--graph")) {
    selection.graphs.push_back(GraphIri(graph));
  }
  const std::vector<std::string> known = kg_core::ListGraphs(*view);
  for (const std::string& graph : selection.graphs) {
    if (std::find(known.begin(), known.end(), graph) != known.end()) continue;
    throw InputError("there is no graph " + kg_core::AbbreviateIri(graph));
  }
  if (selection.graphs.empty() && syntax.has_graphs) selection.graphs = known;
  if (selection.graphs.empty()) selection.graphs = {kg_core::kFactsGraph};
  const std::string text = kg_core::WriteRdf(*view, selection, syntax.syntax);
  const auto file = arguments.One("-o");
  if (file) WriteFile(*file, text);
  if (!file) std::cout << text;
  return kDone;
}

bool IsKeptByTheStore(const Statement& statement) {
  const std::string log = kg_core::kLogGraph;
  return statement.graph.text == log ||
         statement.graph.text == kg_core::kInferredGraph ||
         (statement.graph.text == kg_core::kProvGraph &&
          statement.subject.text.compare(0, log.size(), log) == 0);
}

// Content of imported files: facts as an update, other graphs unchanged.
struct Imported {
  kg_core::FactUpdate update;
  std::vector<Statement> others;
  std::size_t left_out = 0;
};

// Files of one call share no blank nodes; the facts of all files form one
// update.
Imported ReadFiles(const Arguments& arguments) {
  Imported imported;
  const kg_core::Term graph =
      kg_core::Iri(GraphIri(arguments.One("--graph").value_or("graph:facts")));
  for (std::size_t i = 1; i < arguments.words.size(); ++i) {
    for (Statement& s : kg_core::ParseRdfFile(arguments.words[i], graph)) {
      if (IsKeptByTheStore(s)) {
        ++imported.left_out;
      } else if (s.graph.text == kg_core::kFactsGraph) {
        imported.update.statements.push_back(std::move(s));
      } else {
        imported.others.push_back(std::move(s));
      }
    }
  }
  return imported;
}

int RunImport(const Arguments& arguments) {
  arguments.ExpectWords(2, 1000, "STORE and at least one file");
  Imported imported = ReadFiles(arguments);
  imported.update.author = arguments.One("--author").value_or("kg import");
  imported.update.id = arguments.words[1];
  const Target target = OpenOrMakeStore(arguments.words[0]);
  kg_core::Transaction transaction = target.store->Begin();
  for (const Statement& statement : imported.others) {
    transaction.Add(statement);
  }
  const auto reasons =
      Stage(imported.update, arguments.One("--data").value_or(""), target,
            &transaction);
  if (imported.left_out > 0) {
    std::cerr << "kg import: " << imported.left_out
              << " statements of the log, or inferred, are left out: the store "
                 "keeps its own\n";
  }
  return Finish(reasons, &transaction);
}

}  // namespace

const Subcommand kExport = {
    "export",
    "TARGET [--graph IRI]... [--format FORMAT] [-o FILE]",
    "write graphs as Turtle, TriG, N-Triples or N-Quads",
    "Without --graph: all graphs as TriG or N-Quads, the facts as Turtle or\n"
    "N-Triples, which know no graphs.\n\n"
    "  --graph IRI      e.g. graph:facts; may be given again\n"
    "  --format FORMAT  turtle, trig, ntriples, nquads; otherwise by the "
    "suffix\n"
    "                   of FILE (.ttl, .trig, .nt, .nq), else trig\n"
    "  -o FILE          whole or not at all; otherwise standard output\n"
    "  --data FOLDER    where a mission's files are looked up first\n",
    {{"--graph", true}, {"--format", true}, {"-o", true}, {"--data", true}},
    RunExport};

const Subcommand kImport = {
    "import",
    "STORE FILE... [--graph IRI] [--author NAME]",
    "add files of Turtle, TriG, N-Triples or N-Quads: one transaction",
    "Facts are checked and logged like any update, or all is refused. A STORE\n"
    "that does not exist and ends in .db is created, with the ontology in it. "
    "The "
    "log\n"
    "and what is inferred are left out: the store keeps its own.\n\n"
    "  --graph IRI    of statements in no graph; otherwise graph:facts\n"
    "  --author NAME  kept in the log\n"
    "  --data FOLDER  where a mission's files are looked up first\n",
    {{"--graph", true}, {"--author", true}, {"--data", true}},
    RunImport};

}  // namespace kg_engine::command
