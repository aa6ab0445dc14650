#!/usr/bin/env python3
"""rviz/mission.rviz draws what it should: proved by the pixels of a picture of
the planned default mission, beside one of rviz without any node.
"""

import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import numpy as np
from mission_test import ROOT, main

SCRIPT = os.path.join(ROOT, 'scripts', 'take_screenshot.sh')
MAP = (slice(70, 920), slice(375, 1585))  # Where rviz shows the map.
PICTURE_S = 240.0


def picture(folder, name, **environment):
    """Takes a picture; its pixels as rows x columns x RGB, of the map only."""
    path = os.path.join(folder, name)
    subprocess.run([SCRIPT, path], check=True, timeout=PICTURE_S,
                   stdout=subprocess.DEVNULL,
                   env=dict(os.environ, **environment))
    size = subprocess.check_output(
        ['identify', '-format', '%w %h', path]).split()
    pixels = subprocess.check_output(['convert', path, '-depth', '8', 'rgb:-'])
    shape = (int(size[1]), int(size[0]), 3)
    return np.frombuffer(pixels, np.uint8).reshape(shape)[MAP].astype(int)


def is_near(pixels, colour, tolerance=12):
    return (np.abs(pixels - np.array(colour)) <= tolerance).all(axis=2)


def heatmap(pixels):
    """From blue (no value) to red (best), no green: rviz's costmap colours."""
    red, green, blue = np.moveaxis(pixels, 2, 0)
    return (green < 30) & (np.abs(red + blue - 255) < 40)


LAND = (103, 126, 124)     # No data, at opacity 0.9 over the background.
PATHS = {'alpha': (0, 255, 0), 'bravo': (255, 255, 0),
         'charlie': (255, 128, 255)}


class RvizTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix='kg_rviz_') as folder:
            cls.empty = picture(folder, 'empty.png', NODES='none')
            cls.gulf = picture(folder, 'gulf.png')

    def test_the_heatmap_covers_the_gulf_with_more_than_one_value(self):
        shown = heatmap(self.gulf)
        self.assertGreater(shown.mean(), 0.15)
        self.assertGreater(len(np.unique(self.gulf[shown], axis=0)), 50)
        self.assertEqual(0.0, heatmap(self.empty).mean())

    def test_land_is_shown_as_no_data(self):
        self.assertGreater(is_near(self.gulf, LAND).mean(), 0.1)
        self.assertEqual(0.0, is_near(self.empty, LAND).mean())

    def test_every_agents_path_is_there(self):
        # Bands of the committed paths, and a line of its own colour for each.
        green = is_near(self.gulf, PATHS['alpha'], 60)
        self.assertGreater(green.sum(), 100)
        for agent, colour in PATHS.items():
            self.assertGreater(is_near(self.gulf, colour).sum(), 4, agent)
            self.assertEqual(0, is_near(self.empty, colour).sum(), agent)


if __name__ == '__main__':
    main('rviz', RvizTest)
