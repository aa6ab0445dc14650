// A file from which facts were read.

#ifndef KG_CORE_FACTS_SOURCE_FILE_H_
#define KG_CORE_FACTS_SOURCE_FILE_H_

#include <string>

namespace kg_core {

// ex:SourceFile.
struct SourceFile {
  std::string iri;
  std::string path;    // ex:path, absolute after the data folder is applied.
  std::string sha256;  // ex:sha256.
};

}  // namespace kg_core

#endif  // KG_CORE_FACTS_SOURCE_FILE_H_
