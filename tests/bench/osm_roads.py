"""An extract of OpenStreetMap as large as a country, imported: bytes, seconds and memory.

osm_roads.py WAYMARK [--nodes N] [--buildings B] [--seed S] [--folder DIR]

A country is drawn by `waymark generate roads` and written as OSM XML: its nodes at their places, every street as a way
of two nodes, landmarks as nodes with a name, and B buildings of four corners for each node of a road, as most of an
extract is. `waymark import osm` must read the same arcs. Prints nodes, bytes of the extract, seconds and the greatest
resident size for each node. Extracts are written and compared by a process of their own: Linux counts the memory of
the process that starts a command as the command's.
"""
import argparse
import multiprocessing
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def run(command):
    """Wall-clock and processor seconds, and bytes of the greatest resident size."""
    begun = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = status
    if status != 0:
        sys.exit(f"{' '.join(map(str, command))}: status {status}")
    return time.monotonic() - begun, used.ru_utime + used.ru_stime, used.ru_maxrss * 1024


def arcs_of(path):
    """Arcs as numbers, sorted, and how many nodes there are."""
    arcs, nodes = [], 0
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("p"):
                nodes = int(line.split()[2])
            elif line.startswith("a"):
                _, tail, head, _ = line.split()
                arcs.append(int(tail) << 32 | int(head))
    arcs.sort()
    return arcs, nodes


def positions_of(path):
    """Degrees: 111,195 metres each, around the equator."""
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("v"):
                _, _, x, y = line.split()
                yield int(x) / 111195, int(y) / 111195


def names_of(path):
    with open(path, encoding="ascii") as file:
        names = dict(entry.split("=") for entry in next(file).split())
        for line in file:
            node, labels = line.split(":")
            for label in labels.split():
                if (name := names[label].strip('"')) not in ("init", "x", "y"):
                    yield int(node), name


def write_extract(prefix, path, buildings):
    arcs, nodes = arcs_of(f"{prefix}.gr")
    names = dict(names_of(f"{prefix}.lab"))
    known = set(arcs)
    with open(path, "w", encoding="ascii") as out:
        out.write('<?xml version="1.0" encoding="UTF-8"?>\n<osm version="0.6" generator="osm_roads.py">\n')
        corner = 100 * nodes  # ids of corners stand behind those of roads
        for node, (longitude, latitude) in enumerate(positions_of(f"{prefix}.co"), 1):
            out.write(f' <node id="{node * 10}" version="3" timestamp="2024-01-01T00:00:00Z" '
                      f'lat="{latitude:.7f}" lon="{longitude:.7f}"')
            out.write(f'><tag k="name" v="{names[node]}"/></node>\n' if node in names else "/>\n")
        for node, (longitude, latitude) in enumerate(positions_of(f"{prefix}.co"), 1):
            for _ in range(buildings):
                for dx, dy in ((1, 1), (2, 1), (2, 2), (1, 2)):
                    out.write(f' <node id="{corner}" version="1" timestamp="2024-01-01T00:00:00Z" '
                              f'lat="{latitude + dy * 1e-4:.7f}" lon="{longitude + dx * 1e-4:.7f}"/>\n')
                    corner += 1
        way = 0
        for arc in arcs:
            tail, head = arc >> 32, arc & 0xFFFFFFFF
            back = head << 32 | tail in known
            if back and head < tail:
                continue
            way += 1
            out.write(f' <way id="{way}" version="2">\n  <nd ref="{tail * 10}"/>\n  <nd ref="{head * 10}"/>\n'
                      f'  <tag k="highway" v="residential"/>\n{"" if back else oneway}'
                      '  <tag k="surface" v="asphalt"/>\n </way>\n')
        for first in range(100 * nodes, corner, 4):
            way += 1
            refs = "".join(f'  <nd ref="{ref}"/>\n' for ref in (first, first + 1, first + 2, first + 3, first))
            out.write(f' <way id="{way}" version="1">\n{refs}  <tag k="building" v="yes"/>\n </way>\n')
        out.write("</osm>\n")


def are_equal(one, other):
    return arcs_of(one) == arcs_of(other)


def apart(function, *arguments):
    with multiprocessing.Pool(1) as pool:
        return pool.apply(function, arguments)


oneway = '  <tag k="oneway" v="yes"/>\n'


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("waymark")
    options.add_argument("--nodes", type=int, default=1_000_000)
    options.add_argument("--buildings", type=int, nargs="+", default=[0, 1])
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--folder")
    chosen = options.parse_args()
    print("| nodes | buildings | extract, bytes | wall-clock s | processor s | bytes a node |\n"
          "|---:|---:|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory(dir=chosen.folder) as folder:
        prefix, extract, made = Path(folder) / "country", Path(folder) / "country.osm", Path(folder) / "imported"
        run([chosen.waymark, "generate", "roads", "--nodes", str(chosen.nodes), "--seed", str(chosen.seed), "--out",
             prefix])
        for buildings in chosen.buildings:
            nodes = chosen.nodes
            apart(write_extract, prefix, extract, buildings)
            wall, processor, peak = run([chosen.waymark, "import", "osm", extract, "--out", made])
            if not apart(are_equal, f"{prefix}.gr", f"{made}.gr"):
                sys.exit("the arcs differ")
            print(f"| {nodes:,} | {buildings * nodes:,} | {extract.stat().st_size:,} | {wall:.1f} | {processor:.1f} "
                  f"| {peak / nodes:.0f} |", flush=True)


main()
