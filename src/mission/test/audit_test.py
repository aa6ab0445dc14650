#!/usr/bin/env python3
"""Audit and export of a running mission: the commands of docs/queries.md
succeed, every shipped query runs, and third-party readers (json, shapely, an
XML parser, netCDF4, rdflib) find the plan in the exports.
"""

import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import netCDF4
import numpy
import rdflib
import rospy
import shapely.geometry
from kg_msgs.srv import Export

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import ROOT, CHANGE_S, by_agent, main  # noqa: E402
from geodesic import distance_m  # noqa: E402
from small_mission_case import SmallMissionTestCase  # noqa: E402

COMMAND_S = 60.0
NEAR_M = 15.0      # Tracks of the facts are within 10 m of the planned ones.
GPX = '{http://www.topografix.com/GPX/1/1}'


def commands():
    with open(os.path.join(ROOT, 'docs', 'queries.md')) as file:
        text = file.read()
    return [line for block in re.findall(r'^```sh run\n(.*?)^```$', text,
                                         re.MULTILINE | re.DOTALL)
            for line in block.splitlines()]


def seconds(text):
    """Unix seconds of an xsd:dateTime in UTC, with or without fraction."""
    return numpy.datetime64(text.rstrip('Z'), 'us').astype(int) * 1e-6


def planned(assignment):
    """Times [s], longitudes and latitudes [deg] of a track of the topic."""
    track = assignment.pathlet.track
    return (numpy.array([point.stamp.to_sec() for point in track]),
            numpy.degrees([point.lon_rad for point in track]),
            numpy.degrees([point.lat_rad for point in track]))


class AuditTest(SmallMissionTestCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = tempfile.mkdtemp(prefix='kg_export_')
        cls.service = rospy.ServiceProxy('kg/export', Export)
        cls.world, cls.plan = cls.mission.wait_for_plan()
        cls.agents = by_agent(cls.plan)

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        shutil.rmtree(cls.folder, ignore_errors=True)

    def export(self, **request):
        self.service.wait_for_service(CHANGE_S)
        answer = self.service(**dict({'graphs': [], 'path': ''}, **request))
        self.assertTrue(answer.ok, answer.error)
        self.assertEqual(self.mission.world.last.world_version,
                         answer.world_version)
        return answer.data

    def assert_is_the_plan(self, agent, times, lons, lats):
        """The track agrees with the plan at all times of the plan."""
        known = planned(self.agents[agent])
        self.assertTrue(numpy.all(numpy.diff(times) >= 0))
        self.assertAlmostEqual(known[0][0], times[0], delta=0.1)
        self.assertAlmostEqual(known[0][-1], times[-1], delta=0.1)
        for time, lon, lat in zip(*known):
            self.assertLess(distance_m(lon, lat,
                                       numpy.interp(time, times, lons),
                                       numpy.interp(time, times, lats)), NEAR_M)

    def test_1_documented_commands_run(self):
        found = commands()
        self.assertGreater(len(found), 8)
        for command in found:
            done = subprocess.run(command, shell=True, timeout=COMMAND_S,
                                  stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
            self.assertEqual(0, done.returncode, command + '\n' + done.stdout)
            self.assertNotIn('ok: False', done.stdout, command)
        for made in glob.glob('/tmp/kg_plan*'):
            (shutil.rmtree if os.path.isdir(made) else os.remove)(made)

    def test_1_every_shipped_query_runs_and_is_documented(self):
        with open(os.path.join(ROOT, 'docs', 'queries.md')) as file:
            documented = set(re.findall(r'^\| `(\w+)` \|', file.read(),
                                        re.MULTILINE))
        for path in glob.glob(os.path.join(ROOT, 'config', 'queries', '*.rq')):
            name = os.path.splitext(os.path.basename(path))[0]
            with open(path) as file:
                self.mission.query.answer(file.read())
            if not name.startswith('what_if'):
                self.assertIn(name, documented)

    def test_2_assignments_lead_to_the_files_of_the_mission(self):
        rows = self.mission.select("""
            SELECT DISTINCT ?x ?path {
              ?x a ex:Assignment ; (prov:wasDerivedFrom|prov:wasGeneratedBy|
                                    prov:used|prov:wasInformedBy)+ ?f .
              ?f a ex:SourceFile ; ex:path ?path ; ex:sha256 ?sha }""")
        paths = {}
        for row in rows:
            paths.setdefault(row['x'], set()).add(row['path'])
        self.assertEqual(sum(len(assignment.pathlet.visits)
                             for assignment in self.plan.assignments),
                         len(paths))
        for found in paths.values():
            self.assertEqual({os.path.realpath(self.file('ocean.nc'))},
                             {os.path.realpath(path) for path in found})

    def test_3_geojson_is_read_by_json_and_shapely(self):
        data = json.loads(self.export(format='geojson'))
        self.assertEqual('FeatureCollection', data['type'])
        tracks = {}
        for feature in data['features']:
            shape = shapely.geometry.shape(feature['geometry'])
            self.assertTrue(shape.is_valid)
            agent = feature['properties']['agent']
            if feature['properties']['kind'] == 'track':
                tracks[agent] = (shape, feature['properties'])
        self.assertEqual(set(self.agents), set(tracks))
        for agent, (shape, properties) in tracks.items():
            self.assertEqual('LineString', shape.geom_type)
            times = [seconds(text) for text in properties['coordTimes']]
            lons, lats = zip(*shape.coords)
            self.assert_is_the_plan(agent, times, lons, lats)
            self.assertAlmostEqual(
                self.agents[agent].pathlet.energy_j / 3600.0,
                properties['energy_wh'], places=6)
        self._assert_points(data)

    def _assert_points(self, data):
        for feature in data['features']:
            properties = feature['properties']
            if properties['kind'] != 'waypoint':
                continue
            visit = [visit for visit in
                     self.agents[properties['agent']].pathlet.visits
                     if visit.window == properties['window']][0]
            lon, lat = feature['geometry']['coordinates']
            self.assertAlmostEqual(math.degrees(visit.lon_rad), lon, places=6)
            self.assertAlmostEqual(math.degrees(visit.lat_rad), lat, places=6)
            self.assertAlmostEqual(visit.reward, properties['reward'])

    def test_3_gpx_is_read_by_an_xml_parser(self):
        path = os.path.join(self.folder, 'plan.gpx')
        self.assertEqual('', self.export(format='gpx', path=path))
        root = xml.etree.ElementTree.parse(path).getroot()
        self.assertEqual(GPX + 'gpx', root.tag)
        self.assertEqual('1.1', root.get('version'))
        tracks = root.findall(GPX + 'trk')
        self.assertEqual(set(self.agents),
                         {track.find(GPX + 'name').text for track in tracks})
        for track in tracks:
            points = track.findall('%strkseg/%strkpt' % (GPX, GPX))
            self.assert_is_the_plan(
                track.find(GPX + 'name').text,
                [seconds(point.find(GPX + 'time').text) for point in points],
                [float(point.get('lon')) for point in points],
                [float(point.get('lat')) for point in points])
        self.assertEqual(sum(len(a.pathlet.visits)
                             for a in self.plan.assignments),
                         len(root.findall(GPX + 'wpt')))

    def test_3_netcdf_is_read_by_netcdf4_with_its_units(self):
        path = os.path.join(self.folder, 'plan.nc')
        self.export(format='netcdf', path=path)
        with netCDF4.Dataset(path) as file:
            self.assertEqual('CF-1.8', file.Conventions)
            self.assertEqual('trajectory', file.featureType)
            self.assertEqual('obs', file['row_size'].sample_dimension)
            self.assertEqual('trajectory_id', file['trajectory_id'].cf_role)
            self.assertEqual('degrees_east', file['lon'].units)
            self.assertEqual('degrees_north', file['lat'].units)
            self.assertEqual('time', file['time'].standard_name)
            dates = netCDF4.num2date(file['time'][:], file['time'].units,
                                     only_use_cftime_datetimes=False)
            times = numpy.array([seconds(date.isoformat()) for date in dates])
            names = [''.join(row).strip('\0') for row in
                     file['trajectory_id'][:].filled(b'\0').astype(str)]
            ends = numpy.cumsum(file['row_size'][:])
            self.assertEqual(len(times), ends[-1])
            for name, size, end in zip(names, file['row_size'][:], ends):
                part = slice(end - size, end)
                self.assert_is_the_plan(name, times[part], file['lon'][part],
                                        file['lat'][part])
        self.assertEqual(set(self.agents), set(names))

    def test_3_goto_lists_have_the_waypoints(self):
        self.export(format='goto', path=self.folder)
        for agent, assignment in self.agents.items():
            with open(os.path.join(self.folder, agent, 'goto_l10.ma')) as file:
                text = file.read()
            self.assertTrue(text.startswith('behavior_name=goto_list\n'))
            visits = assignment.pathlet.visits
            self.assertIn('num_waypoints(nodim) %d\n' % len(visits), text)
            inside = text.split('<start:waypoints>')[1]
            lines = re.findall(r'^(-?\d+)(\d\d\.\d{4}) (-?\d+)(\d\d\.\d{4})',
                               inside, re.MULTILINE)
            self.assertEqual(len(visits), len(lines))
            for visit, (lon, lon_min, lat, lat_min) in zip(visits, lines):
                self.assertLess(distance_m(
                    math.degrees(visit.lon_rad), math.degrees(visit.lat_rad),
                    int(lon) - float(lon_min) / 60.0,
                    int(lat) + float(lat_min) / 60.0), 0.5)

    def test_3_rdf_is_read_by_rdflib(self):
        merged = rdflib.Graph()
        merged.parse(data=self.export(format='turtle'), format='turtle')
        count = len(self.mission.select(
            'SELECT ?s { GRAPH graph:facts { ?s ?p ?o } }'))
        self.assertEqual(count, len(merged))
        named = rdflib.ConjunctiveGraph()
        named.parse(data=self.export(format='trig',
                                     graphs=['graph:facts', 'graph:prov']),
                    format='trig')
        facts = rdflib.URIRef('http://example.org/mission/graph/facts')
        self.assertEqual(count, len(named.get_context(facts)))

    def test_4_what_cannot_be_written_is_refused_in_one_line(self):
        for path in ('plan.gpx', '/proc/plan.gpx', self.folder):
            answer = self.service(format='gpx', graphs=[], path=path)
            self.assertFalse(answer.ok)
            self.assertNotIn('\n', answer.error)
            self.assertIn(path, answer.error)


if __name__ == '__main__':
    main('audit', AuditTest)
