#!/usr/bin/env python3
"""The repository as a whole: packages, licences, format, build defaults, list of
Debian packages."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
PACKAGES = sorted(REPOSITORY.glob("src/*/package.xml"))
ARCHITECTURE = {"kg_base", "kg_core", "kg_mission", "kg_compiler", "kg_planner",
                "kg_selector", "kg_engine", "kg_msgs", "kg_ros", "mission"}
DEPENDS = ("depend", "build_depend", "exec_depend", "buildtool_depend",
           "build_export_depend", "test_depend")
# ROS packages whose Debian name is not lib<name>-dev or similar.
DEBIAN_NAME = {"tf2": "libtf2-ros-dev", "roslib": "libroslib-dev",
               "eigen": "libeigen3-dev",
               "rosgraph_msgs": "python3-rosgraph-msgs"}


def text_of(package, tag):
    return [element.text.strip() for element in xml.parse(package).iter(tag)]


def apt_list():
    lines = (REPOSITORY / "apt-packages.txt").read_text().splitlines()
    return [line for line in lines
            if line.strip() and not line.startswith(("#", "["))]


def debian_packages(name):
    """Tuples of alternatives: the list must have one member of each."""
    dashed = name.replace("_", "-")
    if name in DEBIAN_NAME:
        return ((DEBIAN_NAME[name],),)
    if name.endswith("_msgs"):
        return ((f"lib{dashed}-dev",), (f"ros-{dashed}",),
                (f"python3-{dashed}",))
    return ((name, dashed, f"lib{dashed}-dev", f"ros-{dashed}",
             f"python3-{dashed}"),)


class TheFiles(unittest.TestCase):

    def test_have_no_conflict_markers(self):
        marked = subprocess.run(
            ["git", "grep", "-lE", "^(<{7}|>{7}) "], cwd=REPOSITORY,
            capture_output=True, text=True, check=False).stdout
        self.assertEqual("", marked)


class ThePackages(unittest.TestCase):

    def test_are_those_of_the_architecture(self):
        self.assertLessEqual(ARCHITECTURE,
                             {package.parent.name for package in PACKAGES})

    def test_are_of_format_2_under_the_licence_of_the_repository(self):
        for package in PACKAGES:
            with self.subTest(package=package.parent.name):
                self.assertEqual("2", xml.parse(package).getroot().get("format"))
                self.assertEqual(["BSD"], text_of(package, "license"))
        self.assertIn("BSD 3-Clause", (REPOSITORY / "LICENSE").read_text())

    def test_pass_catkin_lint(self):
        run = subprocess.run(
            ["catkin_lint", "-W2", "--strict", "--offline", "src"],
            cwd=REPOSITORY, capture_output=True, text=True, check=False)
        self.assertEqual(0, run.returncode, run.stdout + run.stderr)

    def test_depend_only_on_what_the_package_list_installs(self):
        listed = {line.split()[0] for line in apt_list()}
        ours = {package.parent.name for package in PACKAGES}
        names = {name for package in PACKAGES for tag in DEPENDS
                 for name in text_of(package, tag)} - ours
        lacking = [(name, choice) for name in sorted(names)
                   for choice in debian_packages(name)
                   if not listed.intersection(choice)]
        self.assertEqual([], lacking)
        self.assertGreater(len(names), 10)


class ThePackageList(unittest.TestCase):

    def test_names_every_package_once(self):
        names = [line.split()[0] for line in apt_list()]
        self.assertEqual(len(names), len(set(names)))
        for line in apt_list():
            self.assertRegex(line, r"^[a-z0-9][a-z0-9+.-]+( +# .+)?$")


class TheCode(unittest.TestCase):

    def test_is_formatted_by_clang_format(self):
        files = [str(path) for suffix in ("h", "cc")
                 for path in sorted(REPOSITORY.glob(f"src/kg_*/**/*.{suffix}"))]
        self.assertGreater(len(files), 50)
        run = subprocess.run(
            ["clang-format", "--dry-run", "-Werror", "--ferror-limit=1"] + files,
            cwd=REPOSITORY, capture_output=True, text=True, check=False)
        self.assertEqual(0, run.returncode, run.stderr[:4000])


class DefaultConfiguration(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        source = cls.folder / "src"
        source.mkdir()
        for package in PACKAGES:
            (source / package.parent.name).symlink_to(package.parent)
        (source / "CMakeLists.txt").symlink_to(
            "/usr/share/catkin/cmake/toplevel.cmake")
        (cls.folder / "devel/lib/python3/dist-packages").mkdir(parents=True)
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("CXXFLAGS", "CMAKE_BUILD_TYPE",
                                       "MAKEFLAGS", "MFLAGS")}
        subprocess.run(
            ["cmake", "-S", source, "-B", cls.folder / "build",
             f"-DCATKIN_DEVEL_PREFIX={cls.folder}/devel",
             "-DPYTHON_EXECUTABLE=/usr/bin/python3",
             "-DCATKIN_ENABLE_TESTING=OFF",
             "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"],
            env=environment, capture_output=True, check=True)

    def test_is_a_release(self):
        cache = (self.folder / "build/CMakeCache.txt").read_text()
        self.assertIn("\nCMAKE_BUILD_TYPE:STRING=Release\n", cache)

    def test_compiles_the_code_as_strict_optimised_cpp17(self):
        commands = json.loads(
            (self.folder / "build/compile_commands.json").read_text())
        # The batches of sources lie in the build folder, generated code in devel.
        ours = [entry["command"] for entry in commands
                if "/kg_" in entry["file"] and "/devel/" not in entry["file"]]
        self.assertGreater(len(ours), 20)
        for flag in ("-std=c++17", "-DNDEBUG", "-Wall", "-Wextra", "-Werror"):
            without = [command for command in ours
                       if flag not in command.split()]
            self.assertEqual([], without[:3], flag)
        # The last level counts.
        levels = {(re.search(r"src/(kg_\w+)", command)[1],
                   re.findall(r" -O(\w)", command)[-1]) for command in ours}
        self.assertLessEqual({("kg_base", "3"), ("kg_compiler", "3"),
                              ("kg_core", "2"), ("kg_ros", "1")}, levels)
        self.assertLessEqual({level for _, level in levels}, {"1", "2", "3"})


if __name__ == "__main__":
    unittest.main()
