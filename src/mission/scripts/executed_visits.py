"""Visits executed before this check started, read from the plan's facts, so
that the verdict of a resumed mission covers the whole mission.
"""

from mission_facts import geometry
from mission_record import Visit

JOULES_PER_WH = 3600.0


def executed_visits(select):
    """(agent id, window) -> Visit; `select` runs a SPARQL SELECT."""
    visits = {}
    for row in select("""
            SELECT ?id ?window ?wkt ?stops ?reward ?cost ?wh ?event WHERE {
              ?x a ex:Assignment ; ex:status "executed" ;
                 ex:forAgent/ex:id ?id ; ex:forWindow/ex:index ?window ;
                 ex:waypointWKT ?wkt ; ex:reward ?reward ;
                 ex:seamCost ?cost ; ex:costEnergy ?wh .
              OPTIONAL { ?x ex:visits ?event }
              OPTIONAL { ?x ex:stopsWKT ?stops } }"""):
        point = geometry(row['wkt'])
        visit = visits.setdefault(
            (row['id'], int(row['window'])),
            Visit(point.x, point.y, [], float(row['reward']),
                  float(row['cost']), JOULES_PER_WH * float(row['wh']),
                  [(stop.x, stop.y) for stop in
                   geometry(row['stops']).geoms] if 'stops' in row else []))
        if 'event' in row:
            visit.events.append(row['event'])
    return visits
