// For tests: a server of the test mission with a second agent.

#ifndef KG_ENGINE_SERVER_TESTING_TEST_TEAM_H_
#define KG_ENGINE_SERVER_TESTING_TEST_TEAM_H_

#include <memory>

#include "kg_base/common/temporary_folder.h"
#include "kg_engine/server/mission_planning.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/testing/test_mission.h"

namespace kg_engine {

// A second agent, close enough to the test mission's agent for conflicts.
inline constexpr char kSecondAgent[] = R"ttl(
ex:mission ex:hasAgent ex:bravo .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:mobility "glider" ;
    ex:usesPolicy ex:fast ; ex:hasCapabilities ex:alpha_capabilities .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.85 25.72)"^^geo:wktLiteral ; ex:headingDeg 0 .
)ttl";

// A server of the test mission, which is written into `folder`.
inline std::unique_ptr<MissionServer> StartTestServer(
    const kg_base::TemporaryFolder& folder) {
  MissionFolders folders;
  folders.mission = folder / "mission";
  folders.state = folder / "state";
  folders.ontology = "../kg_mission/ontology";
  WriteTestMission(folders.mission);
  return std::make_unique<MissionServer>(folders);
}

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_TESTING_TEST_TEAM_H_
