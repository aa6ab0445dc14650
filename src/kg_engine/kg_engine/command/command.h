// The program `kg`: subcommands on a store or a mission folder. Needs no ROS
// master and never initialises ROS.
//
// A subcommand is one file with a `const Subcommand`, declared here, and one
// row in command.cc.

#ifndef KG_ENGINE_COMMAND_COMMAND_H_
#define KG_ENGINE_COMMAND_COMMAND_H_

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace kg_engine::command {

// Exit statuses: success, rejected or faults found, usage error.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1;
inline constexpr int kMisused = 2;

// A usage error of the command line; the text is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Option {
  std::string name;  // "--format", "-e".
  bool has_value = false;
};

// Parsed command line of a subcommand. "-" and arguments after "--" are words.
struct Arguments {
  std::vector<std::string> words;
  std::map<std::string, std::vector<std::string>> options;

  bool Has(const std::string& option) const {
    return options.count(option) != 0;
  }
  // The single value of an option; throws UsageError if it is given twice.
  std::optional<std::string> One(const std::string& option) const;
  std::vector<std::string> All(const std::string& option) const;
  // Throws UsageError if there are fewer words than `least` or more than
  // `most`; `expected` names them, e.g. "STORE FILE...".
  void ExpectWords(std::size_t least, std::size_t most,
                   const std::string& expected) const;
};

// Throws UsageError for an unknown option or a missing value.
Arguments ParseArguments(const std::vector<std::string>& line,
                         const std::vector<Option>& options);

struct Subcommand {
  const char* name;
  const char* arguments;  // "TARGET [FILE.rq | -e TEXT] ..."
  const char* summary;    // One line.
  const char* help;       // The rest of --help; ends with a line end.
  std::vector<Option> options;
  // Returns an exit status. May throw UsageError, kg_base::InputError and
  // std::runtime_error, whose text is shown as the one line of the error.
  int (*run)(const Arguments& arguments);
};

extern const Subcommand kQuery;
extern const Subcommand kUpdate;
extern const Subcommand kValidate;
extern const Subcommand kExport;
extern const Subcommand kImport;
extern const Subcommand kDiff;
extern const Subcommand kLog;
extern const Subcommand kConformance;
extern const Subcommand kServe;
extern const Subcommand kWhy;
extern const Subcommand kCheck;

// Runs the program: `line` is the command line without the program's name.
int RunCommand(const std::vector<std::string>& line);

}  // namespace kg_engine::command

#endif  // KG_ENGINE_COMMAND_COMMAND_H_
