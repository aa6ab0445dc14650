#!/usr/bin/env python3
"""The default mission from the user's point of view: interface, plan, a changed
fact, a forbidden area, queries.
"""

import hashlib
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rosgraph
import rosservice
import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from kg_msgs.msg import (AgentState, FactUpdate, MissionTensor, UpdateReport,
                         World)
from kg_msgs.srv import Check, Export, WhatIf, Why, WhyRequest
from mission_test import (CHANGE_S, ROOT, Heard, MissionTestCase, by_agent,
                          main, track_deg, wait_until)
from nav_msgs.msg import OccupancyGrid, Path
from shapely.geometry import LineString, box
from visualization_msgs.msg import MarkerArray

AGENTS = ('alpha', 'bravo', 'charlie')
WINDOWS = 7
GULF_WIDTH_M = 2176e3  # 541 columns of 0.04 degree at 25.3 N.
TOPICS = {
    'kg/facts': 'kg_msgs/FactUpdate',
    'kg/updates': 'kg_msgs/UpdateReport',
    'kg/world': 'kg_msgs/World',
    'kg/agent_states': 'kg_msgs/AgentState',
    'kg/work_fields': 'kg_msgs/WorkField',
    'kg/coordination': 'kg_msgs/CoordinationRules',
    'kg/nav_graphs': 'kg_msgs/NavGraph',
    'kg/candidates': 'kg_msgs/Candidates',
    'kg/assignments': 'kg_msgs/Assignments',
    'kg/round_requests': 'kg_msgs/RoundRequest',
    'kg/rejections': 'kg_msgs/Rejections',
    'kg/watched': 'kg_msgs/WatchedAnswer',
    'kg/markers': 'visualization_msgs/MarkerArray',
    'diagnostics': 'diagnostic_msgs/DiagnosticArray',
    'tf': 'tf2_msgs/TFMessage',
    'tf_static': 'tf2_msgs/TFMessage',
}
LAYERS = ('REWARD', 'UNCERTAINTY', 'POLICY', 'ATTENUATION', 'FEASIBILITY',
          'FUSED', 'REACH', 'WORK', 'FUSED_VIEW')
AGENT_TOPICS = {
    'tensors': 'kg_msgs/MissionTensor',
    'seam_rules': 'kg_msgs/SeamRules',
    'heatmap': 'nav_msgs/OccupancyGrid',
    'path': 'nav_msgs/Path',
    'work': 'visualization_msgs/Marker',
    'work_clicked': 'visualization_msgs/Marker',
    **{'layer/' + name: 'nav_msgs/OccupancyGrid' for name in LAYERS},
}
SERVICES = {
    'kg/update': 'kg_msgs/UpdateFacts',
    'kg/query': 'kg_msgs/Query',
    'kg/watch': 'kg_msgs/Watch',
    'kg/why': 'kg_msgs/Why',
    'kg/what_if': 'kg_msgs/WhatIf',
    'kg/validate': 'kg_msgs/Validate',
    'kg/export': 'kg_msgs/Export',
    'kg/check': 'kg_msgs/Check',
}
TO_SAFE = ('{author: operator, set: [{subject: "ex:alpha", '
           'property: "ex:usesPolicy", value: "ex:safe"}]}')

J_PER_WH = 3600.0
# Answers of the paper's what-if questions on the unchanged mission: energy of
# the paths that exceed this share of the energy budgets [Wh].
TOO_MUCH_ENERGY_WH = {'0.7': {}, '0.45': {'alpha': 447.9, 'bravo': 347.3}}
BUDGETS_WH = {'alpha': 900.0, 'bravo': 700.0, 'charlie': 550.0}
TOO_COSTLY_EDGES = [6, 45, 28, 17, 45, 33, 45]  # By window.


def solutions(result):
    """Rows of SPARQL results in JSON, as plain values."""
    return [{name: term['value'] for name, term in row.items()}
            for row in json.loads(result)['results']['bindings']]


def hashes(world):
    return {agent.id: list(agent.tensor_hash) for agent in world.agents}


class GulfTest(MissionTestCase):
    arguments = {'mission': 'gulf', 'sim': 'false'}

    def test_1_plans_three_agents_for_seven_windows(self):
        world, plan = self.mission.wait_for_plan()
        self.assertEqual(WINDOWS, len(world.windows))
        self.assertEqual(list(AGENTS), sorted(a.id for a in world.agents))
        self.assertEqual([], list(plan.unassigned))
        for agent in AGENTS:
            visits = by_agent(plan)[agent].pathlet.visits
            self.assertEqual(list(range(WINDOWS)), [v.window for v in visits])

    def test_2_the_independent_check_finds_no_violation(self):
        world, _ = self.mission.wait_for_plan()
        verdict = self.mission.verdict(
            lambda v: v['world_version'] == world.world_version)
        self.assert_no_violation(verdict)
        self.assertEqual(WINDOWS, verdict['windows'])
        for agent in AGENTS:
            self.assertEqual(WINDOWS, verdict['agents'][agent]['waypoints'])
            self.assertGreater(verdict['agents'][agent]['reward'], 0.0)
        for stage in ('compile', 'plan', 'select'):
            self.assertGreater(verdict['stage_seconds'][stage], 0.0)

    def test_3_has_every_topic_and_service_of_the_interface(self):
        self.mission.wait_for_plan()
        wanted = {'/' + name: kind for name, kind in TOPICS.items()}
        for agent in AGENTS:
            for name, kind in AGENT_TOPICS.items():
                wanted['/kg/%s/%s' % (agent, name)] = kind
        master = rosgraph.Master(rospy.get_name())
        found = dict(master.getTopicTypes())
        self.assertEqual(wanted, {name: found.get(name) for name in wanted})
        self.assertEqual(SERVICES, {
            name: rosservice.get_service_type('/' + name)
            for name in SERVICES})

    def test_3_tells_how_it_is_on_diagnostics(self):
        self.mission.wait_for_plan()
        told = Heard('/diagnostics', DiagnosticArray)
        good = told.wait(lambda array: any(
            status.name.startswith('kg: mission') and status.level == 0
            for status in array.status))
        keys = {value.key for status in good.status for value in status.values}
        self.assertLessEqual({'world_version', 'plan_run', 'missing'}, keys)
        told.close()

    def test_3_says_which_formats_it_exports(self):
        rospy.wait_for_service('kg/export', CHANGE_S)
        answer = rospy.ServiceProxy('kg/export', Export)()
        self.assertFalse(answer.ok)
        for name in ('turtle', 'trig', 'geojson', 'netcdf'):
            self.assertIn(name, answer.error)

    def test_3_answers_construct_and_describe_in_turtle(self):
        answer = self.mission.query.answer(
            'CONSTRUCT { ?a ex:usesPolicy ?p } WHERE { ?a ex:usesPolicy ?p }')
        self.assertEqual(3, answer.rows)
        self.assertIn('ex:alpha ex:usesPolicy ex:fast', answer.result)
        answer = self.mission.query.answer('DESCRIBE ex:alpha')
        self.assertIn('ex:hasCapabilities', answer.result)

    def test_3_shows_heatmaps_paths_markers_and_frames(self):
        self.mission.wait_for_plan()
        heard = {agent: (Heard('kg/%s/heatmap' % agent, OccupancyGrid),
                         Heard('kg/%s/path' % agent, Path))
                 for agent in AGENTS}
        for agent, (heatmap, path) in heard.items():
            grid = heatmap.wait()
            self.assertEqual('map', grid.header.frame_id)
            self.assertAlmostEqual(GULF_WIDTH_M, grid.info.width *
                                   grid.info.resolution, delta=20e3)
            self.assertEqual(-1, min(grid.data), 'land')
            self.assertGreater(max(grid.data), 50)
            self.assertLessEqual(max(grid.data), 100)
            way = path.wait(lambda message: len(message.poses) > WINDOWS)
            self.assertEqual('map', way.header.frame_id)
            self._assert_inside(grid, way)
        self._assert_markers()
        self._assert_frames()

    def _assert_inside(self, grid, way):
        info = grid.info
        for pose in way.poses:
            x = pose.pose.position.x - info.origin.position.x
            y = pose.pose.position.y - info.origin.position.y
            self.assertTrue(0.0 <= x <= info.width * info.resolution, x)
            self.assertTrue(0.0 <= y, y)

    def _assert_markers(self):
        wanted = {'constraints', 'land', 'events', 'currents', 'agents'}
        wanted |= {'%s/%s' % (kind, agent) for agent in AGENTS
                   for kind in ('nav_graph', 'candidates', 'assigned')}
        heard = Heard('kg/markers', MarkerArray)

        def missing():
            found = {marker.ns for message in heard.messages
                     for marker in message.markers}
            return wanted - found
        wait_until(lambda: not missing(), CHANGE_S, 'markers of every kind')
        for message in heard.messages:
            for marker in message.markers:
                self.assertTrue(all(
                    math.isfinite(value) for point in marker.points
                    for value in (point.x, point.y, point.z)), marker.ns)

    def _assert_frames(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        for agent in AGENTS:
            wait_until(lambda: buffer.can_transform(
                'earth', '%s/base_link' % agent, rospy.Time()), CHANGE_S,
                'earth -> map -> %s/base_link' % agent)
        listener.unregister()

    def test_4_answers_select_and_ask_over_facts_and_assignments(self):
        _, plan = self.mission.wait_for_plan()
        mission = self.mission
        self.assertEqual(
            set(AGENTS), {row['id'] for row in mission.select(
                'SELECT ?id WHERE { ?a a ex:Agent ; ex:id ?id }')})
        self.assertTrue(mission.ask('ASK { ex:alpha ex:usesPolicy ?p }'))
        self.assertFalse(mission.ask('ASK { ex:nobody ex:usesPolicy ?p }'))
        self.assertEqual(WINDOWS, len(mission.select(
            'SELECT ?w WHERE { ?w a ex:TimeWindow ; ex:confidence ?c '
            'FILTER(?c <= 1.0) }')))
        self._assert_assignments(plan)

    def _assert_assignments(self, plan):
        """The facts agree with the topic."""
        rows = self.mission.select("""
            SELECT ?id ?i ?wkt WHERE { ?x a ex:Assignment ; ex:forAgent ?a ;
              ex:forWindow ?w ; ex:waypointWKT ?wkt .
              ?a ex:id ?id . ?w ex:index ?i }""")
        stated = {(row['id'], int(row['i'])): [
            float(word) for word in
            row['wkt'].split('(')[1].rstrip(')').split()] for row in rows}
        sent = {(assignment.agent, visit.window): visit
                for assignment in plan.assignments
                for visit in assignment.pathlet.visits}
        self.assertEqual(set(sent), set(stated))
        for key, visit in sent.items():
            self.assertAlmostEqual(math.degrees(visit.lon_rad), stated[key][0],
                                   places=9)
            self.assertAlmostEqual(math.degrees(visit.lat_rad), stated[key][1],
                                   places=9)

    def test_4_provenance_leads_from_assignments_to_runs_and_files(self):
        world, _ = self.mission.wait_for_plan()
        runs = self.mission.select("""
            SELECT ?x ?run ?version WHERE { ?x a ex:Assignment .
              OPTIONAL { ?x prov:wasGeneratedBy ?run . ?run a ex:PlanRun ;
                         ex:worldVersion ?version } }""")
        self.assertEqual(len(AGENTS) * WINDOWS, len({r['x'] for r in runs}))
        self.assertEqual({str(world.plan_version)},
                         {row.get('version') for row in runs})
        files = self.mission.select("""
            SELECT DISTINCT ?path ?sha WHERE {
              ?t a ex:HeatmapArtifact ; prov:wasDerivedFrom ?layer .
              ?layer prov:wasDerivedFrom ?file .
              ?file ex:path ?path ; ex:sha256 ?sha }""")
        self.assertGreater(len(files), 0)
        for row in files:
            with open(row['path'], 'rb') as file:
                self.assertEqual(hashlib.sha256(file.read()).hexdigest(),
                                 row['sha'])

    def test_4_what_if_tells_which_paths_less_energy_makes_infeasible(self):
        _, plan = self.mission.wait_for_plan()
        planned_wh = {agent: by_agent(plan)[agent].pathlet.energy_j / J_PER_WH
                      for agent in AGENTS}
        before = self._digest()
        for share, golden_wh in TOO_MUCH_ENERGY_WH.items():
            answer = self._what_if('what_if_energy_budget', ('0.7', share))
            self.assertTrue(answer.ok, answer.text)
            needed_wh = {row['id']: float(row['needed_wh'])
                         for row in solutions(answer.result)}
            self.assertEqual(
                {agent for agent in AGENTS
                 if planned_wh[agent] > float(share) * BUDGETS_WH[agent]},
                set(needed_wh))
            self.assertEqual(set(needed_wh), {
                path.agent for path in answer.paths if path.infeasible})
            self.assertEqual(set(golden_wh), set(needed_wh))
            for agent, energy_wh in needed_wh.items():
                self.assertAlmostEqual(planned_wh[agent], energy_wh, places=6)
                self.assertAlmostEqual(golden_wh[agent], energy_wh, delta=0.1)
        self.assertEqual(before, self._digest(), 'the world is untouched')

    def test_4_what_if_tells_which_edges_become_too_costly(self):
        self.mission.wait_for_plan()
        before = self._digest()
        answer = self._what_if('what_if_too_costly')
        self.assertTrue(answer.ok, answer.text)
        rows = solutions(answer.result)
        self.assertEqual(TOO_COSTLY_EDGES, [
            sum(int(row['window']) == window for row in rows)
            for window in range(WINDOWS)])
        listed = {edge.edge: edge for edge in answer.changed_edges}
        for row in rows:
            edge = listed[row['edge']]
            self.assertEqual('alpha', edge.agent)
            self.assertAlmostEqual(edge.before.seam_cost,
                                   float(row['now_cost']), places=9)
            self.assertAlmostEqual(edge.after.seam_cost,
                                   float(row['then_cost']), places=9)
        self.assertEqual(before, self._digest(), 'the world is untouched')

    def test_4_what_if_is_asked_by_a_script(self):
        self.mission.wait_for_plan()
        for name, wanted in (('what_if_energy_budget', 0),
                             ('what_if_nothing', 1)):
            done = subprocess.run(
                ['rosrun', 'mission', 'what_if.py', name], text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(wanted, done.returncode, done.stdout)

    def _what_if(self, name, change=('', '')):
        rospy.wait_for_service('kg/what_if', CHANGE_S)
        path = os.path.join(ROOT, 'config', 'queries', name)
        with open(path + '.ru') as update, open(path + '.rq') as query:
            return rospy.ServiceProxy('kg/what_if', WhatIf)(
                update=FactUpdate(sparql=update.read().replace(*change)),
                query=query.read())

    def _digest(self):
        """Hash of all facts and plan runs."""
        return hashlib.sha256(''.join(sorted(
            ' '.join(row.values()) for row in self.mission.select("""
                SELECT ?s ?p ?o WHERE { GRAPH graph:facts { ?s ?p ?o } }""") +
            self.mission.select("""
                SELECT ?g ?s WHERE { GRAPH ?g { ?s a ex:PlanRun } }"""))
        ).encode()).hexdigest()

    def _why(self, **request):
        """The answer, after checking that contributions sum and facts hold."""
        rospy.wait_for_service('kg/why', CHANGE_S)
        answer = rospy.ServiceProxy('kg/why', Why)(**request)
        self.assertTrue(answer.ok, answer.error)
        self.assertAlmostEqual(answer.value, sum(answer.contributions),
                               delta=1e-9, msg=answer.text)
        self.assertEqual(len(answer.contributions), len(answer.facts))
        for facts in answer.facts:
            self.assertNotEqual('', facts, answer.text)
            self.assertTrue(self.mission.ask('ASK { %s }' % facts), facts)
        told = json.loads(answer.json)
        self.assertEqual(answer.value, told['value'])
        self.assertEqual(list(answer.contributions),
                         [part['value'] for part in told['contributions']])
        return answer

    def test_4_why_explains_every_step_of_every_path(self):
        world, plan = self.mission.wait_for_plan()
        for agent, assignment in by_agent(plan).items():
            pathlet = assignment.pathlet
            for visit in (pathlet.visits[0], pathlet.visits[4]):
                answer = self._why(what=WhyRequest.ASSIGNMENT, agent=agent,
                                   window=visit.window)
                self.assertEqual(world.plan_version, answer.world_version)
                self.assertAlmostEqual(visit.reward - visit.cost.seam_cost,
                                       answer.value, delta=1e-9)
                self.assertIn('ex:%s ex:usesPolicy ex:' % agent, answer.text)
                self.assertIn('sha256', answer.text)
            answer = self._why(what=WhyRequest.ASSIGNMENT, agent=agent,
                               window=-1)
            self.assertAlmostEqual(pathlet.reward - pathlet.seam_cost,
                                   answer.value, delta=1e-9)
            edge = self._why(what=WhyRequest.EDGE, agent=agent, window=3,
                             to=pathlet.visits[3].waypoint,
                             **{'from_': pathlet.visits[2].waypoint})
            self.assertAlmostEqual(pathlet.visits[3].cost.seam_cost,
                                   edge.value, delta=1e-12)

    def test_4_why_explains_tensor_cells_as_published(self):
        tensors = Heard('kg/alpha/tensors', MissionTensor)
        tensor = tensors.wait(lambda message: message.window == 2)
        tensors.close()
        fused = next(layer for layer in tensor.layers
                     if layer.name == 'FUSED').values
        cols = len(tensor.grid.lon_rad)
        best = max(range(len(fused)), key=fused.__getitem__)
        for cell in (best, 200 * cols + 100, 230 * cols + 111, 3 * cols + 3):
            answer = self._why(what=WhyRequest.TENSOR_CELL, agent='ex:alpha',
                               window=2, lat_rad=tensor.grid.lat_rad[
                                   cell // cols],
                               lon_rad=tensor.grid.lon_rad[cell % cols])
            self.assertAlmostEqual(fused[cell], answer.value, delta=2e-7)
            self.assertIn('ex:fast ex:alpha_base 1', answer.text)
        sanctuary = self._why(what=WhyRequest.TENSOR_CELL, agent='alpha',
                              window=0, lon_rad=math.radians(-93.6),
                              lat_rad=math.radians(27.9))
        self.assertIn('ex:sanctuary ex:attenuation 0.4', sanctuary.text)

    def test_4_why_not_names_what_stands_in_the_way(self):
        _, plan = self.mission.wait_for_plan()
        visit = by_agent(plan)['alpha'].pathlet.visits[2]
        answer = self._why(what=WhyRequest.WAYPOINT, agent='alpha', window=2,
                           to=visit.waypoint)
        self.assertEqual('taken', answer.verdict)
        other = 0 if visit.waypoint != 0 else 1
        answer = self._why(what=WhyRequest.WAYPOINT, agent='alpha', window=2,
                           to=other)
        self.assertNotEqual('taken', answer.verdict)
        self.assertGreater(answer.value, 0.0)
        for lon, lat, verdict in ((-91.0, 30.5, 'forbidden'),
                                  (-85.0, 24.0, 'unreachable')):
            answer = self._why(what=WhyRequest.PLACE, agent='alpha', window=1,
                               lon_rad=math.radians(lon),
                               lat_rad=math.radians(lat))
            self.assertEqual(verdict, answer.verdict, answer.text)
            self.assertGreater(answer.value, 0.0)
        for event in ('seep', 'tagged_whale', 'mooring', 'bloom', 'eddy_rim'):
            for agent in AGENTS:
                answer = self._why(what=WhyRequest.EVENT, agent=agent,
                                   window=-1, id='ex:' + event)
                taken = any('http://example.org/mission/' + event in v.events
                            for v in by_agent(plan)[agent].pathlet.visits)
                self.assertEqual(taken, answer.verdict == 'taken',
                                 answer.text)
        seep = 'http://example.org/mission/seep'
        other = next(agent for agent in AGENTS if not any(
            seep in v.events for v in by_agent(plan)[agent].pathlet.visits))
        answer = self._why(what=WhyRequest.EVENT, agent=other, window=6,
                           id=seep)
        self.assertEqual('expired', answer.verdict)

    def test_4_why_refuses_what_is_not_there(self):
        rospy.wait_for_service('kg/why', CHANGE_S)
        why = rospy.ServiceProxy('kg/why', Why)
        for request in ({'what': 99}, {'agent': 'nobody'},
                        {'agent': 'alpha', 'window': 77},
                        {'what': WhyRequest.REJECTION, 'id': '999'},
                        {'what': WhyRequest.EVENT, 'agent': 'alpha',
                         'id': 'ex:nothing'}):
            answer = why(**request)
            self.assertFalse(answer.ok)
            self.assertNotEqual('', answer.error, request)

    def test_5_a_policy_changes_its_agents_tensors_and_path_only(self):
        before, plan_before = self.mission.wait_for_plan()
        foreseen = self._what_if('what_if_too_costly')
        reports = len(self.mission.updates.messages)
        subprocess.check_call(['rostopic', 'pub', '-1', '/kg/facts',
                               'kg_msgs/FactUpdate', TO_SAFE],
                              stdout=subprocess.DEVNULL)
        report = self.mission.updates.wait(
            lambda r: r.author == 'operator' and
            r.plan_status == UpdateReport.PLAN_OK, since=reports)
        self.assertTrue(report.accepted, report.reasons)
        self.assertEqual(before.world_version + 1, report.world_version)
        world, plan = self.mission.wait_for_plan(report.world_version)
        self._assert_only_alpha(report, hashes(before), hashes(world))
        self._assert_foreseen(foreseen, report, plan)
        self.assertNotEqual(track_deg(by_agent(plan_before)['alpha']),
                            track_deg(by_agent(plan)['alpha']))
        verdict = self.mission.verdict(
            lambda v: v['world_version'] == report.world_version)
        self.assert_no_violation(verdict)

    def _assert_foreseen(self, foreseen, report, plan):
        def lines(dirty):
            return [(one.kind, one.agent, one.window, one.hash)
                    for one in dirty]
        self.assertEqual(lines(report.dirty), lines(foreseen.dirty))
        self.assertEqual(report.world_version - 1, foreseen.world_version)
        self.assertAlmostEqual(plan.reward, foreseen.plan.reward, places=6)
        self.assertAlmostEqual(plan.seam_cost, foreseen.plan.seam_cost,
                               places=6)
        for agent in AGENTS:
            self.assertEqual(by_agent(plan)[agent].pathlet.visits,
                             by_agent(foreseen.plan)[agent].pathlet.visits)

    def _assert_only_alpha(self, report, old, new):
        self.assertEqual(WINDOWS, len(old['alpha']))
        for agent in AGENTS:
            changed = [a != b for a, b in zip(old[agent], new[agent])]
            self.assertEqual([agent == 'alpha'] * WINDOWS, changed, agent)
        dirty = {(artifact.agent, artifact.window)
                 for artifact in report.dirty if artifact.kind == 'tensor'}
        self.assertEqual({('alpha', window) for window in range(WINDOWS)},
                         dirty)
        stages = {stage.stage for stage in report.stages}
        self.assertLessEqual({'facts', 'compile', 'plan', 'select'}, stages)

    def test_6_a_no_go_area_dropped_on_a_path_moves_it(self):
        _, plan = self.mission.wait_for_plan()
        visit = by_agent(plan)['bravo'].pathlet.visits[3]
        lon, lat = math.degrees(visit.lon_rad), math.degrees(visit.lat_rad)
        area = box(lon - 0.1, lat - 0.1, lon + 0.1, lat + 0.1)
        self.assertTrue(area.intersects(LineString(
            track_deg(by_agent(plan)['bravo']))))
        report = self.mission.update(add=[
            ('ex:dropped', 'a', 'ex:Constraint'),
            ('ex:dropped', 'ex:kind', '"no_go"'),
            ('ex:dropped', 'geo:asWKT', '"%s"^^geo:wktLiteral' % area.wkt)])
        self.assertTrue(report.accepted, report.reasons)
        _, plan = self.mission.wait_for_plan(report.world_version)
        for agent in AGENTS:
            self.assertFalse(area.intersects(LineString(
                track_deg(by_agent(plan)[agent]))), agent)
        self.assert_no_violation(self.mission.verdict(
            lambda v: v['world_version'] == report.world_version))

    def test_6_its_artifacts_equal_a_full_recompilation(self):
        """After all changes that the tests made."""
        _, plan = self.mission.wait_for_plan()
        rospy.wait_for_service('kg/check', CHANGE_S)
        answer = rospy.ServiceProxy('kg/check', Check)()
        self.assertEqual(([], []), (answer.errors, answer.differs), answer.text)
        self.assertTrue(answer.ok, answer.text)
        self.assertEqual(plan.world_version, answer.world_version)
        # Fields, tensors, seam rules and coordination rules.
        self.assertEqual(WINDOWS + len(AGENTS) * (WINDOWS + 1) + 1,
                         answer.compared)

    def test_7_shows_the_window_that_is_asked_for(self):
        heatmap = Heard('kg/alpha/heatmap', OccupancyGrid)
        first = heatmap.wait()
        rospy.set_param('/kg/view_window', 6)
        last = heatmap.wait(lambda grid: grid.data != first.data)
        rospy.set_param('/kg/view_window', -1)
        self.assertNotEqual(first.data, last.data)


if __name__ == '__main__':
    main('gulf', GulfTest)
