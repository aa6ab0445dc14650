#!/usr/bin/env python3
"""Fails if an include points upstream in the house, lets ROS in where it does
not belong, or if the planner knows something of anybody's domain.

    check_include_order.py [REPOSITORY]        prints file:line: what is wrong

The order is kg_core < kg_compiler < kg_planner < kg_selector <
kg_engine < kg_ros. The
planner stands on a floor of its own: it may include itself and the standard
library only (gtest in tests). ROS is known to kg_ros and kg_rviz_plugins.
"""

import pathlib
import re
import sys

HOUSE = ("kg_core", "kg_compiler", "kg_planner", "kg_selector",
         "kg_engine", "kg_ros")
ALONE = "kg_planner"
KNOW_ROS = ("kg_ros", "kg_rviz_plugins")
ROS = re.compile(
    r"^(ros|tf2?\w*|\w+_msgs|nodelet|dynamic_reconfigure|diagnostic_updater|"
    r"pluginlib|class_loader|rviz|rosbag|message_filters|actionlib|"
    r"xmlrpcpp)/|^XmlRpc")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_0-9]+$")

# Words of the case study and of facts, whole or as a part of an identifier.
DOMAIN_WORDS = (
    "ocean", "sea", "marine", "water", "current", "currents", "sst",
    "temperature", "salinity", "depth", "tide", "coast", "land", "gulf",
    "auv", "uuv", "usv", "glider", "gliders", "vessel", "ship", "vehicle",
    "robot", "drone", "fleet", "sanctuary", "sanctuaries", "bathymetry",
    "frontness", "heatmap", "hycom", "netcdf", "knot", "knots", "latitude",
    "longitude", "lat", "lon", "rdf", "sparql", "turtle", "ontology", "triple",
    "policy", "policies", "science")
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def sources(package):
    return sorted(path for path in package.rglob("*")
                  if path.suffix in (".h", ".cc", ".hpp", ".cpp"))


def lines_of(root, package):
    for path in sources(root / "src" / package):
        text = path.read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            yield path.relative_to(root), number, line


def may_include(package, quote, target):
    owner = target.split("/")[0]
    if ROS.match(target):
        return package in KNOW_ROS
    if package == ALONE:
        return (owner in (package, "gtest") or
                (quote == "<" and bool(STANDARD.match(target))))
    if owner in HOUSE and package in HOUSE:
        return HOUSE.index(owner) <= HOUSE.index(package)
    return owner not in KNOW_ROS or package in KNOW_ROS


def include_complaints(root):
    packages = [path.name for path in sorted((root / "src").glob("kg_*"))]
    for package in packages:
        for path, number, line in lines_of(root, package):
            match = INCLUDE.match(line)
            if match and not may_include(package, *match.groups()):
                yield f"{path}:{number}: {package} may not include {match[2]}"


def domain_complaints(root):
    for path, number, line in lines_of(root, ALONE):
        for word in WORD.findall(line):
            if word.lower() in DOMAIN_WORDS:
                yield f"{path}:{number}: {ALONE} knows no '{word.lower()}'"


def complaints(root):
    missing = [name for name in HOUSE if not sources(root / "src" / name)]
    yield from (f"src/{name}: no source file" for name in missing)
    yield from include_complaints(root)
    yield from domain_complaints(root)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = list(complaints(root))
    print("\n".join(found or ["include order: nothing to complain of"]))
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
