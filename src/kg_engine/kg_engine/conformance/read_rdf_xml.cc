#include "kg_engine/conformance/read_rdf_xml.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "kg_base/common/text.h"
#include "kg_base/common/xml_reader.h"
#include "kg_base/text/iri.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/fresh_blank.h"

namespace kg_engine {
namespace {

using kg_core::Iri;
using kg_core::RdfSource;
using kg_core::Statement;
using kg_core::Term;

constexpr int kMaxNesting = 200;

// Context inherited by nested elements.
struct XmlScope {
  std::map<std::string, std::string> prefixes;
  std::string language;
  std::string base;
  int depth = 0;
};

// A tag with resolved names.
struct RdfXmlElement {
  kg_base::XmlTag tag;
  std::string iri;
  std::map<std::string, std::string> attributes;  // Keyed by IRI.
  XmlScope scope;
};

std::string Rdf(const char* name) { return std::string(kg_core::kRdf) + name; }

class RdfXmlParser {
 public:
  RdfXmlParser(std::string_view text, const RdfSource& source)
      : reader_(text, source.name), source_(source) {}

  std::vector<Statement> Run() {
    XmlScope scope;
    scope.base = source_.base;
    scope.prefixes["xml"] = "http://www.w3.org/XML/1998/namespace#";
    const RdfXmlElement root = Next(scope);
    if (root.iri.empty()) reader_.Expected("an element");
    if (root.iri == Rdf("RDF")) {
      ForEachChild(root, [&](const RdfXmlElement& node) { ReadNode(node); });
    } else {
      ReadNode(root);
    }
    return std::move(statements_);
  }

 private:
  RdfXmlElement Next(const XmlScope& outer) {
    RdfXmlElement element;
    element.tag = reader_.Next();
    element.scope = outer;
    if (++element.scope.depth > kMaxNesting) reader_.Expected("less nesting");
    // Pass 1: declarations that apply to the names of this element.
    for (const auto& [name, value] : element.tag.full_attributes) {
      if (name == "xmlns") element.scope.prefixes[""] = value;
      if (name.rfind("xmlns:", 0) == 0) {
        element.scope.prefixes[name.substr(6)] = value;
      }
      if (name == "xml:lang") element.scope.language = value;
      if (name == "xml:base") element.scope.base = value;
    }
    const std::string& name = element.tag.full_name;
    if (name.empty() || name[0] == '/') return element;
    element.iri = Resolve(name, element.scope, true);
    // Pass 2: resolve attributes with the complete scope.
    for (const auto& [attribute, value] : element.tag.full_attributes) {
      if (attribute.rfind("xml", 0) == 0) continue;
      element.attributes[Resolve(attribute, element.scope, false)] = value;
    }
    return element;
  }

  std::string Resolve(const std::string& name, const XmlScope& scope,
                      bool has_default) const {
    const std::size_t colon = name.find(':');
    const bool is_bare = colon == std::string::npos;
    // Older RDF/XML has RDF attributes without a prefix.
    if (is_bare && !has_default) return Rdf(name.c_str());
    const auto found =
        scope.prefixes.find(is_bare ? "" : name.substr(0, colon));
    if (found == scope.prefixes.end()) reader_.Expected("a declared prefix");
    return found->second + (is_bare ? name : name.substr(colon + 1));
  }

  template <typename Visit>
  void ForEachChild(const RdfXmlElement& parent, Visit visit) {
    if (parent.tag.empty) return;
    for (;;) {
      const RdfXmlElement child = Next(parent.scope);
      if (child.tag.full_name == "/" + parent.tag.full_name) return;
      if (child.iri.empty()) reader_.Expected("</" + parent.tag.name + ">");
      visit(child);
    }
  }

  Term ResolveIri(const std::string& iri, const XmlScope& scope) const {
    return Iri(kg_base::ResolveIri(scope.base, iri));
  }

  Term MakeLabel(const std::string& label) {
    const auto known = labels_.find(label);
    if (known != labels_.end()) return known->second;
    return labels_[label] = Fresh();
  }

  Term Fresh() { return kg_core::sparql::FreshBlank(); }

  void Say(const Term& subject, const std::string& property, Term object) {
    statements_.push_back(
        {subject, Iri(property), std::move(object), source_.default_graph});
  }

  std::optional<std::string> Attribute(const RdfXmlElement& element,
                                       const char* name) const {
    const auto found = element.attributes.find(Rdf(name));
    if (found == element.attributes.end()) return std::nullopt;
    return found->second;
  }

  // The node described by an element, from its naming attributes.
  std::optional<Term> Named(const RdfXmlElement& element, const char* about) {
    if (const auto iri = Attribute(element, about)) {
      return ResolveIri(*iri, element.scope);
    }
    if (const auto label = Attribute(element, "nodeID")) {
      return MakeLabel(*label);
    }
    return std::nullopt;
  }

  // [7.2.11] nodeElement
  Term ReadNode(const RdfXmlElement& element) {
    std::optional<Term> node = Named(element, "about");
    if (const auto id = Attribute(element, "ID")) {
      node = ResolveIri("#" + *id, element.scope);
    }
    if (!node) node = Fresh();
    if (element.iri != Rdf("Description")) {
      Say(*node, Rdf("type"), Iri(element.iri));
    }
    SayAttributes(element, *node);
    ReadProperties(element, *node);
    return *node;
  }

  // Property attributes: attributes that are not part of the RDF/XML syntax.
  bool SayAttributes(const RdfXmlElement& element, const Term& node) {
    bool any = false;
    for (const auto& [name, value] : element.attributes) {
      if (name == Rdf("type")) {
        Say(node, name, ResolveIri(value, element.scope));
        any = true;
      } else if (name.rfind(kg_core::kRdf, 0) != 0 || name == Rdf("value")) {
        Say(node, name, Text(value, element));
        any = true;
      }
    }
    return any;
  }

  Term Text(const std::string& text, const RdfXmlElement& element) const {
    const std::string& language = element.scope.language;
    return language.empty() ? kg_core::Literal(text)
                            : kg_core::LanguageLiteral(text, language);
  }

  void ReadProperties(const RdfXmlElement& parent, const Term& subject) {
    int items = 0;
    ForEachChild(parent, [&](const RdfXmlElement& property) {
      const bool is_item = property.iri == Rdf("li");
      const std::string number = "_" + std::to_string(items + 1);
      items += is_item ? 1 : 0;
      ReadProperty(property, subject,
                   is_item ? Rdf(number.c_str()) : property.iri);
    });
  }

  // [7.2.14] propertyElt
  void ReadProperty(const RdfXmlElement& element, const Term& subject,
                    const std::string& property) {
    const auto type = Attribute(element, "parseType");
    if (Attribute(element, "ID")) reader_.Expected("no reification");
    if (type == "Resource") {
      const Term node = Fresh();
      Say(subject, property, node);
      return ReadProperties(element, node);
    }
    if (type == "Collection") return ReadCollection(element, subject, property);
    if (type) reader_.Expected("parseType Resource or Collection");
    if (const auto datatype = Attribute(element, "datatype")) {
      const std::string name = ResolveIri(*datatype, element.scope).text;
      Say(subject, property, kg_core::Literal(element.tag.text, name));
      return ForEachChild(element,
                          [&](const RdfXmlElement&) { RefuseChild(); });
    }
    ReadPlainProperty(element, subject, property);
  }

  // Property value: a nested node, property attributes, or text.
  void ReadPlainProperty(const RdfXmlElement& element, const Term& subject,
                         const std::string& property) {
    std::optional<Term> object = Named(element, "resource");
    const Term other = object ? *object : Fresh();
    if (SayAttributes(element, other)) object = other;
    ForEachChild(element, [&](const RdfXmlElement& child) {
      if (object) RefuseChild();
      object = ReadNode(child);
    });
    Say(subject, property, object ? *object : Text(element.tag.text, element));
  }

  void ReadCollection(const RdfXmlElement& element, const Term& subject,
                      const std::string& property) {
    Term last = subject;
    std::string link = property;
    ForEachChild(element, [&](const RdfXmlElement& child) {
      const Term cell = Fresh();
      Say(last, link, cell);
      Say(cell, Rdf("first"), ReadNode(child));
      last = cell;
      link = Rdf("rest");
    });
    Say(last, link, Iri(Rdf("nil")));
  }

  [[noreturn]] void RefuseChild() const { reader_.Expected("no element here"); }

  kg_base::XmlReader reader_;
  const RdfSource& source_;
  std::map<std::string, Term> labels_;
  std::vector<Statement> statements_;
};

}  // namespace

std::vector<Statement> ParseRdfXml(std::string_view text,
                                   const RdfSource& source) {
  return RdfXmlParser(text, source).Run();
}

}  // namespace kg_engine
