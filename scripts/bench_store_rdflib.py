#!/usr/bin/python3
"""rdflib in store_bench: bench_store_rdflib.py GRAPH.nt QUERIES

Prints "name<TAB>milliseconds<TAB>rows" (see
src/kg_core/kg_core/rdf/store_bench_main.cc). rdflib keeps its graph in memory,
so its update is not durable.
"""

import statistics
import sys
import threading
import time

import rdflib


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


def median_ms(work):
    times = []
    while len(times) < 5 or (sum(times) < 500 and len(times) < 1000):
        begin = time.perf_counter()
        work()
        times.append((time.perf_counter() - begin) * 1e3)
    return statistics.median(times)


def show(name, value, rows):
    print(f"{name}\t{value}\t{rows}", flush=True)


def main():
    graph_path, queries_path = sys.argv[1:]
    before = resident_bytes()
    graph = rdflib.Graph()
    begin = time.perf_counter()
    graph.parse(graph_path, format="nt")
    show("load", (time.perf_counter() - begin) * 1e3, len(graph))
    show("memory", resident_bytes() - before, 0)
    with open(queries_path, encoding="utf-8") as file:
        queries = [line.rstrip("\n").split("\t") for line in file]
    for name, query in queries:
        show(name, median_ms(lambda q=query: len(list(graph.query(q)))),
             len(list(graph.query(query))))
    edge = "http://example.org/mission/edge/0_7"
    cost = "http://example.org/mission/cost"
    show("update", median_ms(lambda: graph.update(
        f"DELETE {{ <{edge}> <{cost}> ?c }} INSERT {{ <{edge}> <{cost}> 5.0 }} "
        f"WHERE {{ <{edge}> <{cost}> ?c }}")), 0)


if __name__ == "__main__":
    # rdflib evaluates a path by recursion, at least one call per step.
    sys.setrecursionlimit(1000000)
    threading.stack_size(1 << 29)
    thread = threading.Thread(target=main)
    thread.start()
    thread.join()
