#!/usr/bin/env python3
"""Display topics of a running mission: every layer of each agent on its own
topic, computed on demand, and WORK in colour from the agent's position and from
a clicked point.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import numpy as np
import rospy
import tf2_ros
from geometry_msgs.msg import PointStamped, TransformStamped
from mission_test import (CHANGE_S, Heard, by_agent, main, track_deg,
                          wait_until)
from nav_msgs.msg import OccupancyGrid
from small_mission_case import SmallMissionTestCase
from visualization_msgs.msg import Marker

TENSOR_LAYERS = ('REWARD', 'UNCERTAINTY', 'POLICY', 'ATTENUATION',
                 'FEASIBILITY', 'FUSED')
POSE_LAYERS = ('REACH', 'WORK', 'FUSED_VIEW')
DARK_RED = (0.3, 0.0, 0.0)


def raster(grid):
    """Rows from south to north."""
    return np.array(grid.data, int).reshape(grid.info.height, grid.info.width)


def cell(grid, x_m, y_m):
    origin = grid.info.origin.position
    side_m = grid.info.resolution
    return int((y_m - origin.y) / side_m), int((x_m - origin.x) / side_m)


def triangles(marker):
    points = np.array([(p.x, p.y) for p in marker.points]).reshape(-1, 3, 2)
    colours = np.array([(c.r, c.g, c.b, c.a) for c in marker.colors])
    return points, colours.reshape(-1, 3, 4)[:, 0]


def area_km2(points):
    a, b, c = np.moveaxis(points, 1, 0)
    cross = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    return np.abs(cross).sum() / 2e6


def easy(colours):
    """More green than red: up to 42 % of the available time."""
    return (colours[:, 1] > colours[:, 0]) & (colours[:, 2] == 0.0)


def middle(points):
    return points.reshape(-1, 2).mean(axis=0)


class LayersTest(SmallMissionTestCase):
    def clicker(self):
        """A publisher of clicked points that kg has subscribed to."""
        click = rospy.Publisher('/clicked_point', PointStamped, queue_size=10)
        wait_until(click.get_num_connections, CHANGE_S,
                   'a subscriber to clicked_point')
        return click

    def attach(self, frame, x_m, y_m):
        """A static frame on the map, its x axis north, its y axis west."""
        transform = TransformStamped()
        transform.header.frame_id = 'map'
        transform.header.stamp = rospy.Time.now()
        transform.child_frame_id = frame
        transform.transform.translation.x = x_m
        transform.transform.translation.y = y_m
        transform.transform.rotation.z = np.sqrt(0.5)
        transform.transform.rotation.w = np.sqrt(0.5)
        self.broadcaster = tf2_ros.StaticTransformBroadcaster()
        self.broadcaster.sendTransform(transform)

    def layer(self, name, agent='alpha'):
        heard = Heard('kg/%s/layer/%s' % (agent, name), OccupancyGrid)
        grid = heard.wait()
        heard.close()
        return grid

    def test_1_every_layer_of_every_agent_is_there(self):
        self.mission.wait_for_plan()
        for agent in ('alpha', 'bravo'):
            shapes = set()
            for name in TENSOR_LAYERS + POSE_LAYERS:
                grid = self.layer(name, agent)
                self.assertEqual('map', grid.header.frame_id)
                values = raster(grid)
                self.assertTrue(((values >= -1) & (values <= 100)).all(), name)
                self.assertGreater((values == -1).sum(), 0, name)  # Land.
                self.assertGreater((values >= 0).mean(), 0.8, name)
                shapes.add(values.shape)
            self.assertEqual(1, len(shapes))

    def test_2_layers_agree_with_feasibility(self):
        feasible = raster(self.layer('FEASIBILITY'))
        self.assertEqual({-1, 0, 100}, set(np.unique(feasible)))
        for name in ('FUSED', 'REACH', 'FUSED_VIEW'):
            values = raster(self.layer(name))
            np.testing.assert_array_equal(values == -1, feasible == -1)
            self.assertTrue((values[feasible == 0] == 0).all(), name)
            self.assertGreater((values > 0).sum(), 0, name)
        reach, work = raster(self.layer('REACH')), raster(self.layer('WORK'))
        reached = reach == 100
        self.assertTrue((feasible[reached] == 100).all())
        np.testing.assert_array_equal(reached, (work >= 0) & (work <= 98))
        np.testing.assert_array_equal(work == 100, feasible == 0)
        np.testing.assert_array_equal(
            work == 99, (feasible == 100) & ~reached)
        # The nearest centre is at most 3 km away.
        self.assertLess(work[reached].min(), 10)
        self.assertGreater(work[reached].max(), 80)
        self.assertEqual({40, 100}, set(np.unique(
            raster(self.layer('ATTENUATION')))) - {-1})

    def test_3_reach_is_about_where_the_agent_is(self):
        _, plan = self.mission.wait_for_plan()
        for agent, assignment in by_agent(plan).items():
            grid = self.layer('REACH', agent)
            reached = np.argwhere(raster(grid) == 100).mean(axis=0)
            lon, lat = track_deg(assignment)[0]
            # The grid's box is 60 x 50 cells of 0.04 degrees from -92, 25.
            share = ((lat - 24.98) / 2.0, (lon + 92.02) / 2.4)
            for value, wanted, size in zip(reached, share,
                                           raster(grid).shape):
                self.assertAlmostEqual(wanted, value / size, delta=0.15)

    def test_4_work_is_in_colour_where_it_is_a_number(self):
        heard = Heard('kg/alpha/work', Marker)
        points, colours = triangles(heard.wait())
        grid = self.layer('WORK')
        values = raster(grid)
        dark = np.isclose(colours[:, :3], DARK_RED).all(axis=1)
        cell_km2 = grid.info.resolution ** 2 / 1e6
        self.assertAlmostEqual(
            (values >= 99).sum() * cell_km2, area_km2(points[dark]),
            delta=0.03 * area_km2(points[dark]))
        self.assertAlmostEqual(
            ((values >= 0) & (values < 42)).sum() * cell_km2,
            area_km2(points[easy(colours)]),
            delta=0.15 * area_km2(points[easy(colours)]))
        x, y = middle(points[easy(colours)])
        self.assertLess(values[cell(grid, x, y)], 30)
        heard.close()

    def test_5_a_clicked_place_has_work_of_its_own(self):
        own = Heard('kg/alpha/work', Marker)
        clicked = Heard('kg/alpha/work_clicked', Marker)
        other = Heard('kg/bravo/work_clicked', Marker)
        self.assertIsNone(clicked.last)  # No click yet.
        click = self.clicker()
        middles = []
        for place in ((40e3, 30e3), (-20e3, -40e3)):
            point = PointStamped()
            point.header.frame_id = 'map'
            point.point.x, point.point.y = place
            before = len(clicked.messages)
            click.publish(point)
            points, colours = triangles(clicked.wait(since=before))
            middles.append(middle(points[easy(colours)]))
            np.testing.assert_allclose(middles[-1], place, atol=20e3)
        self.assertGreater(np.hypot(*(middles[0] - middles[1])), 50e3)
        own_points, own_colours = triangles(own.wait())
        self.assertGreater(
            np.hypot(*(middle(own_points[easy(own_colours)]) - middles[1])),
            10e3)
        other.wait()
        for heard in (own, clicked, other):
            heard.close()

    def test_6_a_click_that_is_none_changes_nothing(self):
        clicked = Heard('kg/alpha/work_clicked', Marker)
        clicked.wait()
        click = self.clicker()
        point = PointStamped()
        point.header.frame_id = 'earth'
        click.publish(point)
        point.header.frame_id, point.point.x = 'map', 1e9
        click.publish(point)
        good = PointStamped()
        good.header.frame_id = 'map'
        good.point.x, good.point.y = 10e3, 10e3
        before = len(clicked.messages)
        click.publish(good)
        points, colours = triangles(clicked.wait(since=before))
        self.assertEqual(before + 1, len(clicked.messages))
        np.testing.assert_allclose(middle(points[easy(colours)]),
                                   (10e3, 10e3), atol=20e3)
        clicked.close()

    def test_6_a_click_in_another_frame_is_transformed(self):
        self.attach('test_ship', 35e3, 20e3)
        clicked = Heard('kg/alpha/work_clicked', Marker)
        clicked.wait()
        click = self.clicker()
        shown = {}
        for frame, x_m, y_m in (('test_ship', 10e3, -5e3),
                                ('map', -30e3, -30e3), ('map', 40e3, 30e3)):
            before = len(clicked.messages)
            point = PointStamped()
            point.header.frame_id = frame
            point.point.x, point.point.y = x_m, y_m

            def answer():
                click.publish(point)  # kg may not know the frame yet.
                return len(clicked.messages) > before or rospy.sleep(0.2)
            wait_until(answer, CHANGE_S, 'an answer to a click in ' + frame)
            shown[frame, x_m] = triangles(clicked.last)
        ours, same = shown['test_ship', 10e3], shown['map', 40e3]
        self.assertEqual(ours[0].shape, same[0].shape)
        np.testing.assert_allclose(ours[0], same[0], atol=1.0)
        np.testing.assert_allclose(ours[1], same[1], atol=0.01)
        clicked.close()

    def test_6_a_click_in_an_unknown_frame_is_reported_once(self):
        click = self.clicker()
        point = PointStamped()
        point.header.frame_id = 'nowhere'
        click.publish(point)
        wait_until(lambda: "'nowhere'" in self.mission.output(), CHANGE_S,
                   'a warning that names the frame')
        lines = [line for line in self.mission.output().splitlines()
                 if 'nowhere' in line]
        self.assertEqual(1, len(lines), lines)
        self.assertIn('clicked point ignored: no transform', lines[0])
        self.assertIn('expected one of these or a frame', lines[0])

    def test_7_layers_follow_the_window_looked_at_and_the_facts(self):
        heard = Heard('kg/alpha/layer/UNCERTAINTY', OccupancyGrid)
        first = heard.wait()
        self.assertEqual({0}, set(np.unique(raster(first))) - {-1})
        reach = raster(self.layer('REACH'))
        rospy.set_param('/kg/view_window', 2)
        later = heard.wait(lambda grid: 21 in grid.data)  # 1 - exp(-0.24)
        self.assertEqual({21}, set(np.unique(raster(later))) - {-1})
        self.assertTrue((raster(self.layer('REACH')) != reach).any())
        feasible = Heard('kg/alpha/layer/FEASIBILITY', OccupancyGrid)
        open_before = (raster(feasible.wait()) == 100).sum()
        report = self.mission.update(turtle="""
            ex:closed a ex:Constraint ; ex:kind "no_go" ; ex:name "closed" ;
                geo:asWKT "POLYGON((-90.4 25.2, -90.1 25.2, -90.1 25.5, -90.4 25.5, -90.4 25.2))"^^geo:wktLiteral .
            """)
        self.assertTrue(report.accepted, report.reasons)
        feasible.wait(lambda grid: (raster(grid) == 100).sum() < open_before)
        self.assertTrue((raster(self.layer('FUSED'))[
            raster(feasible.last) == 0] == 0).all())
        for topic in (heard, feasible):
            topic.close()


if __name__ == '__main__':
    main('layers', LayersTest)
