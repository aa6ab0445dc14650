#!/usr/bin/env python3
"""Says whether a run ended well: from the file it wrote, not from roslaunch,
which exits with 0 whatever its nodes did.

    check_verdict.py <state>/verdict.json --since <Unix seconds of the start>

Well means: of a check that began and wrote after the start, every window flown
(without simulation: planned), a plan for every agent and every window, and not
one violation.
"""

import argparse
import json
import os
import sys

REQUIRED = ("no_go", "capacity", "separation")


def complaint(path, since_s):
    """The first defect of the verdict; None if there is none."""
    try:
        if not os.stat(path).st_mtime >= since_s:
            return "it is of an earlier run"
        with open(path) as file:
            return complaint_of(json.load(file), since_s)
    except (OSError, ValueError) as error:
        return str(error)


def complaint_of(verdict, since_s):
    try:
        if not verdict["began_unix_s"] >= since_s:
            return "it is of a check that began before this run"
        if verdict["ended"] is not True:
            return ("the mission has not ended: not every window was flown"
                    + _said(verdict["notes"]))
        return (_no_plan(verdict["agents"], verdict["complete"],
                         verdict["notes"])
                or _violated(verdict["violations"]))
    except (KeyError, TypeError, AttributeError) as error:
        return f"it lacks something: {error!r}"


def _no_plan(agents, complete, notes):
    if not agents:
        return "no agent has a plan" + _said(notes)
    without = [name for name, agent in agents.items()
               if not agent["waypoints"] > 0]
    if without:
        return f"no plan for {', '.join(without)}" + _said(notes)
    return None if complete is True else "the plan has gaps" + _said(notes)


def _said(notes):
    return "".join(f"; {note}" for note in notes[:3])


def _violated(violations):
    lacking = [kind for kind in REQUIRED if kind not in violations]
    if lacking:
        return f"not checked: {', '.join(lacking)}"
    found = [f"{kind} {count}" for kind, count in violations.items()
             if count != 0]
    return f"violations: {', '.join(found)}" if found else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("verdict")
    parser.add_argument("--since", type=float, required=True)
    arguments = parser.parse_args()
    wrong = complaint(arguments.verdict, arguments.since)
    if wrong:
        sys.exit(f"verdict: FAILED: {arguments.verdict}: {wrong}")
    with open(arguments.verdict) as file:
        verdict = json.load(file)
    print(f"verdict: a plan for {len(verdict['agents'])} agents x "
          f"{verdict['windows']} windows, no violation")


if __name__ == "__main__":
    main()
