"""A test case on the small mission, whose files are in a temporary folder."""

import os
import shutil
import tempfile

import small_mission
from mission_test import MissionTestCase


class SmallMissionTestCase(MissionTestCase):
    small_arguments = {'sim': 'false'}

    @classmethod
    def prepare(cls):
        cls.mission_folder = tempfile.mkdtemp(prefix='kg_small_')
        small_mission.write_mission(cls.mission_folder)
        cls.arguments = dict(cls.small_arguments,
                             mission_folder=cls.mission_folder)

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        shutil.rmtree(cls.mission_folder, ignore_errors=True)

    @classmethod
    def file(cls, name):
        return os.path.join(cls.mission_folder, name)
