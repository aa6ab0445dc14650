#!/usr/bin/env python3
"""Checks which file may include which, over all C++ packages.

    check_include_order.py [REPOSITORY]        prints file:line: what is wrong

Rules:
  1. Packages: a package includes itself and the packages MAY_INCLUDE names.
     The dependencies of package.xml obey the same table.
  2. ROS headers, kg_msgs included, appear in kg_ros and kg_rviz_plugins only.
  3. kg_planner includes itself, the standard library, plain values of kg_base
     and, in tests, gtest. It contains no word of an application domain.
  4. Folders: src/<package>/folders.txt lists the folders of a package, lowest
     first; a file includes its own folder and the folders listed before it.
     Every folder with code is listed ('.' is the folder of the package itself).
  5. No include circle between units (x.h and x.cc), none between folders.
  6. A header under testing/ is included by tests, benchmarks, fuzzers and other
     files under testing/ only; so are gtest, gmock and benchmark.

Tests, programs, fuzzers and testing/ obey rules 1 to 3; as top-level files they
are no part of the order of folders (4) and of folder circles (5).
"""

import collections
import dataclasses
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

MAY_INCLUDE = {
    "kg_base": (),
    "kg_core": ("kg_base",),
    "kg_mission": ("kg_base", "kg_core"),
    "kg_compiler": ("kg_base", "kg_core", "kg_mission"),
    "kg_planner": ("kg_base",),
    "kg_selector": ("kg_base", "kg_core", "kg_mission", "kg_compiler",
                    "kg_planner"),
    "kg_engine": ("kg_base", "kg_core", "kg_mission", "kg_compiler",
                  "kg_planner", "kg_selector"),
    "kg_ros": ("kg_base", "kg_core", "kg_mission", "kg_compiler",
               "kg_planner", "kg_selector", "kg_engine", "kg_msgs"),
    "kg_rviz_plugins": ("kg_base", "kg_core", "kg_mission", "kg_compiler",
                        "kg_planner", "kg_selector", "kg_engine", "kg_msgs",
                        "kg_ros"),
}
OPTIONAL = ("kg_rviz_plugins",)
WITH_ROS = ("kg_ros", "kg_rviz_plugins")
GENERAL = "kg_planner"
PLAIN_VALUES = "kg_base/common/"

ROS = re.compile(
    r"^(ros|tf2?\w*|\w+_msgs|nodelet|dynamic_reconfigure|diagnostic_updater|"
    r"pluginlib|class_loader|rviz|rosbag|message_filters|actionlib|"
    r"xmlrpcpp)/|^XmlRpc")
TEST_LIBRARY = re.compile(r"^(gtest|gmock|benchmark)/")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_0-9]+$")
PROGRAM = re.compile(r"_(test|main|fuzz)\.cc$")
TEST_PROGRAM = re.compile(r"_(test|bench_main|fuzz)\.cc$")

# Words of application domains and of facts, whole or as a part of an identifier.
DOMAIN_WORDS = (
    "ocean", "sea", "marine", "water", "current", "currents", "sst",
    "temperature", "salinity", "depth", "tide", "coast", "land", "gulf",
    "auv", "uuv", "usv", "glider", "gliders", "vessel", "ship", "vehicle",
    "robot", "drone", "fleet", "sanctuary", "sanctuaries", "bathymetry",
    "frontness", "heatmap", "hycom", "netcdf", "knot", "knots", "latitude",
    "longitude", "lat", "lon", "rdf", "sparql", "turtle", "ontology", "triple",
    "policy", "policies", "science")
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


@dataclasses.dataclass(frozen=True)
class Source:
    """A file src/<package>/<name>; other files include it by its name."""
    package: str
    name: str
    lines: tuple

    def place(self, number):
        return f"src/{self.package}/{self.name}:{number}"

    @property
    def folder(self):
        """Below the folder of the package's code; '.' for that folder."""
        return folder_of(self.name)

    @property
    def unit(self):
        return unit_of(self.name)

    @property
    def is_testing(self):
        return "/testing/" in self.name

    @property
    def is_for_tests(self):
        return self.is_testing or bool(TEST_PROGRAM.search(self.name))

    @property
    def is_library(self):
        return not self.is_testing and not PROGRAM.search(self.name)

    def includes(self):
        """Yields line number, opening quote and target of every include."""
        for number, line in enumerate(self.lines, 1):
            match = INCLUDE.match(line)
            if match:
                yield number, match[1], match[2]


def folder_of(name):
    parts = name.split("/")[1:-1]
    return "/".join(parts) or "."


def unit_of(name):
    return re.sub(r"\.(h|cc|hpp|cpp)$", "", name)


def read_sources(root):
    sources = []
    for package in sorted((root / "src").glob("kg_*")):
        for path in sorted(package.rglob("*")):
            if path.suffix in (".h", ".cc", ".hpp", ".cpp"):
                text = path.read_text(encoding="utf-8")
                name = str(path.relative_to(package))
                sources.append(Source(package.name, name,
                                      tuple(text.splitlines())))
    return sources


def presence_complaints(root, sources):
    present = {source.package for source in sources}
    for package in MAY_INCLUDE:
        if package not in present and package not in OPTIONAL:
            yield f"src/{package}: no source file"
    for package in sorted(present - set(MAY_INCLUDE)):
        yield f"src/{package}: not in the table of packages"
    for path in sorted((root / "src").glob("*/**/*.cc")):
        package = path.relative_to(root / "src").parts[0]
        if not package.startswith("kg_"):
            yield f"{path.relative_to(root)}: C++ belongs in a kg_ package"


def may_include(package, quote, target):
    owner = target.split("/")[0]
    if ROS.match(target):
        return package in WITH_ROS
    if package == GENERAL:
        return (owner in (package, "gtest") or target.startswith(PLAIN_VALUES)
                or (quote == "<" and bool(STANDARD.match(target))))
    if owner in MAY_INCLUDE:
        return owner == package or owner in MAY_INCLUDE.get(package, ())
    return True


def package_complaints(sources):
    for source in sources:
        for number, quote, target in source.includes():
            if not may_include(source.package, quote, target):
                yield (f"{source.place(number)}: {source.package} may not "
                       f"include {target}")


def dependency_complaints(root):
    for path in sorted((root / "src").glob("kg_*/package.xml")):
        package = path.parent.name
        for element in xml.parse(path).getroot():
            name = (element.text or "").strip()
            ours = name in MAY_INCLUDE or name == "kg_msgs"
            if (element.tag.endswith("depend") and ours and
                    name not in MAY_INCLUDE.get(package, ())):
                yield (f"{path.relative_to(root)}: {package} may not depend "
                       f"on {name}")


def domain_complaints(sources):
    for source in sources:
        if source.package != GENERAL:
            continue
        for number, line in enumerate(source.lines, 1):
            for word in WORD.findall(line):
                if word.lower() in DOMAIN_WORDS:
                    yield (f"{source.place(number)}: word of a domain in "
                           f"{GENERAL}: '{word.lower()}'")


def read_folders(root, package):
    """The rank of every folder of a package that its table lists."""
    path = root / "src" / package / "folders.txt"
    if not path.exists():
        return {}
    lines = [line.split("#")[0].strip()
             for line in path.read_text(encoding="utf-8").splitlines()]
    names = [line for line in lines if line]
    return {name: rank for rank, name in enumerate(names)}


def table_complaints(root, sources):
    used = collections.defaultdict(set)
    for source in sources:
        if not source.is_testing:
            used[source.package].add(source.folder)
    for package, folders in sorted(used.items()):
        listed = read_folders(root, package)
        table = f"src/{package}/folders.txt"
        for folder in sorted(folders - set(listed)):
            yield f"{table}: folder {folder} is not listed"
        for folder in sorted(set(listed) - folders):
            yield f"{table}: folder {folder} has no code"


def folder_complaints(root, sources):
    listed = {source.package: read_folders(root, source.package)
              for source in sources}
    for source in sources:
        if not source.is_library:
            continue
        ranks = listed[source.package]
        for number, _, target in source.includes():
            folder = folder_of(target)
            if (target.split("/")[0] == source.package and
                    source.folder in ranks and folder in ranks and
                    ranks[folder] > ranks[source.folder]):
                yield (f"{source.place(number)}: folder {source.folder} may "
                       f"not include {target}: {folder} is listed after it")


def testing_complaints(sources):
    for source in sources:
        if source.is_for_tests:
            continue
        for number, _, target in source.includes():
            if "/testing/" in target or TEST_LIBRARY.match(target):
                yield (f"{source.place(number)}: {target} is for tests and "
                       "benchmarks only")


def include_graph(sources, node_of):
    """node -> {included node: the place of one such include}."""
    nodes = {source.name: node_of(source) for source in sources}
    graph = collections.defaultdict(dict)
    for source in sources:
        for number, _, target in source.includes():
            if target in nodes and nodes[target] != nodes[source.name]:
                graph[nodes[source.name]].setdefault(nodes[target],
                                                     source.place(number))
    return graph


def reachable(graph, start):
    """node -> the node before it on a shortest way from start."""
    before = {}
    queue = collections.deque([start])
    while queue:
        node = queue.popleft()
        for target in sorted(graph.get(node, ())):
            if target not in before:
                before[target] = node
                queue.append(target)
    return before


def circles(graph):
    """Yields every set of mutually reachable nodes, of two and more."""
    ahead = {node: set(reachable(graph, node)) for node in list(graph)}
    seen = set()
    for node in sorted(ahead):
        if node in seen or node not in ahead[node]:
            continue
        circle = {other for other in ahead[node]
                  if node in ahead.get(other, ())}
        seen |= circle
        yield circle


def shortest_circle(graph, circle):
    """A shortest closed way through a circle, its first node at both ends."""
    ways = []
    for node in sorted(circle):
        before = reachable(graph, node)
        way = [node]
        while len(way) == 1 or way[-1] != node:
            way.append(before[way[-1]])
        ways.append(way[::-1])
    return min(ways, key=len)


def circle_complaints(sources):
    kinds = (
        ("units", [s for s in sources if not PROGRAM.search(s.name)],
         lambda source: source.unit),
        ("folders", [s for s in sources if s.is_library],
         lambda source: source.name.rpartition("/")[0]))
    for kind, members, node_of in kinds:
        graph = include_graph(members, node_of)
        for circle in circles(graph):
            way = shortest_circle(graph, circle)
            yield (f"{graph[way[0]][way[1]]}: include circle of "
                   f"{len(circle)} {kind}: {' -> '.join(way)}")


def complaints(root):
    sources = read_sources(root)
    yield from presence_complaints(root, sources)
    yield from package_complaints(sources)
    yield from dependency_complaints(root)
    yield from domain_complaints(sources)
    yield from table_complaints(root, sources)
    yield from folder_complaints(root, sources)
    yield from testing_complaints(sources)
    yield from circle_complaints(sources)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = list(complaints(root))
    print("\n".join(found or ["include order: no violations"]))
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
