"""What is mutated: a copy of the tree, built once with all mutants, and the test programs that are run."""
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import finding
import schemata

ROOT = Path(__file__).resolve().parents[2]
# The folders, and the test programs of each; those that stand first are asked first.
AREAS = {
    "libltl": ("libltl", "laws"),
    "libautomata/finite": ("libautomata", "laws"),
    "libautomata/omega": ("libautomata", "laws"),
    "libplan/product": ("libplan", "model"),
    "libplan/solve": ("libplan", "model"),
    "libparser/mention": ("libparser", "domains"),
    "libparser/decode": ("libparser", "domains"),
}
# What most sources include, with what the mutated ones include.
STANDARD = ("<algorithm>", "<array>", "<charconv>", "<cmath>", "<deque>", "<functional>", "<map>", "<memory>", "<numeric>",
            "<optional>", "<queue>", "<set>", "<span>", "<sstream>", "<stop_token>", "<string>", "<tuple>",
            "<unordered_map>", "<unordered_set>", "<variant>", "<vector>", '"tests/mutation/mutant.hpp"')
# Assertions of waymark and of the standard library are on, as in the preset `dev`.
FLAGS = "-O1 -w -D_GLIBCXX_ASSERTIONS"
MOST_BUILDS = 12


def sources_of(root, area):
    found = (path.relative_to(root).as_posix() for path in (root / area).rglob("*.?pp"))
    return sorted(file for file in found if not file.endswith("_test.cpp"))


def write_if_new(path, content):
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


class Subject:
    """A tree, its mutants by number, and how programs are built. `scratch` holds the copy and the build."""

    def __init__(self, root, scratch, areas, say=print):
        self.root, self.scratch, self.areas, self.say = root, scratch, areas, say
        self.copy, self.build_folder = scratch / "copy", scratch / "build"
        self.schemas, self.mutants, self.skipped = {}, {}, []
        self.sources = [(area, file) for area in self.all_areas() for file in sources_of(root, area)]
        self.known_file = scratch / "mutants.json"  # by content: what was found, and which of it does not compile
        self.known = json.loads(self.known_file.read_text()) if self.known_file.exists() else {}

    def all_areas(self):
        """Mutants have the same numbers, and the copy the same content, whichever areas are looked at."""
        return list(AREAS)

    def tracked(self):
        """The files of the tree that a build needs."""
        listed = subprocess.run(["git", "-C", str(self.root), "ls-files", "-co", "--exclude-standard", "-z"],
                                stdout=subprocess.PIPE, check=True).stdout.decode().split("\0")
        return [file for file in listed if file and (self.root / file).is_file()]

    def arguments(self):
        """Of the parser: where headers are."""
        commands = self.build_folder / "compile_commands.json"
        words = {"-std=c++20": None, f"-I{self.root}": None}
        for entry in json.loads(commands.read_text()) if commands.exists() else ():
            split = shlex.split(entry["command"])
            for i, word in enumerate(split):
                if word == "-isystem":
                    words[f"-isystem{split[i + 1]}"] = None
        return list(words)

    def prepare(self):
        """Copies the tree, configures it, writes the mutated sources, builds; drops mutants that do not compile."""
        mutated = {file for _, file in self.sources}
        for file in [*self.tracked(), *mutated]:
            if file not in mutated or not (self.copy / file).exists():
                write_if_new(self.copy / file, (self.root / file).read_bytes())
        self.configure()
        self.find()
        self.build()
        self.mutants = {number: (schema.area, mutant) for schema in self.schemas.values() if schema.area in self.areas
                        for number, mutant in schema.mutants.items()}

    def find(self):
        arguments = self.arguments()
        digest = hashlib.sha256(repr(arguments).encode())
        arguments = finding.precompile(STANDARD, self.scratch / "standard.pch", arguments)
        for script in ("finding.py", "schemata.py"):
            digest.update((Path(__file__).parent / script).read_bytes())
        first = 1
        for area, file in self.sources:
            source = (self.root / file).read_bytes()
            key = hashlib.sha256(digest.digest() + file.encode() + source).hexdigest()[:16]
            schema = self.remembered(key, source, first) or self.found(key, file, source, first, arguments)
            if schema:
                schema.area, schema.file, schema.first, schema.key = area, file, first, key
                first += len(self.known[key]["found"])
                self.schemas[file] = schema
                self.write(schema)
        self.remember()

    def remembered(self, key, source, first):
        if key not in self.known:
            return None
        schema = schemata.Schema(source, [finding.Mutant(*cells) for cells in self.known[key]["found"]], first)
        for place in self.known[key]["dropped"]:
            schema.mutants.pop(first + place, None)
        return schema

    def found(self, key, file, source, first, arguments):
        try:
            found = finding.Finder(file, self.root / file, arguments).mutants()
        except finding.Reason as reason:
            self.skipped.append(str(reason))
            return None
        schema = schemata.Schema(source, found, first)
        schemata.check(schema, self.root / file, arguments)
        self.known[key] = {"found": found, "dropped": []}
        self.say(f"{file}: {len(schema.mutants)} mutants, {len(found) - len(schema.mutants)} do not compile")
        return schema

    def write(self, schema):
        write_if_new(self.copy / schema.file, schema.write())
        known = self.known[schema.key]
        known["dropped"] = [i for i in range(len(known["found"])) if schema.first + i not in schema.mutants]

    def remember(self):
        self.known_file.write_text(json.dumps(self.known))

    def configure(self):
        command = ["cmake", "-G", "Ninja", "-S", self.copy, "-B", self.build_folder, "-DCMAKE_BUILD_TYPE=Debug",
                   f"-DCMAKE_CXX_FLAGS_DEBUG={FLAGS}", "-DWAYMARK_WITH_OMPL=OFF", "-DWAYMARK_WITH_GRAPHVIZ=OFF",
                   "-DWAYMARK_WITH_CAIRO=OFF", "-DWAYMARK_WITH_STUDIO=OFF", "-DWAYMARK_WITH_PYTHON=OFF"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            raise SystemExit(f"error: the copy cannot be configured\n{done.stdout}")

    def programs(self):
        return list(dict.fromkeys(program for area in self.areas for program in AREAS[area]))

    def program(self, name):
        return self.build_folder / "bin" / f"test_{name}"

    def build_command(self):
        return ["ninja", "-C", self.build_folder, "-k", "0", "-j", str(os.cpu_count()),
                *(f"test_{name}" for name in self.programs())]

    def build(self):
        for _ in range(MOST_BUILDS):
            done = subprocess.run([str(word) for word in self.build_command()], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode == 0:
                return
            if not self.drop(done.stdout):
                raise SystemExit(f"error: the mutated copy cannot be built\n{done.stdout[-6000:]}")
        raise SystemExit(f"error: {MOST_BUILDS} builds failed")

    def drop(self, log):
        """Drops the mutants that a compiler objects to; those of its notes where its errors are elsewhere."""
        places, changed = schemata.complaints(log), set()
        for wanted in (True, False):
            for file, line, column, is_error in places:
                name = os.path.relpath(os.path.realpath(self.build_folder / file), os.path.realpath(self.copy))
                schema = self.schemas.get(name)
                if is_error == wanted and schema:
                    for number in schema.drop(schema.offset(line, column)):
                        self.say(f"{name}:{line}: mutant {number} does not compile")
                        changed.add(schema)
            if changed:
                break
        for schema in changed:
            self.write(schema)
        self.remember()
        return bool(changed)


class Toy(Subject):
    """One source and one test, compiled by hand."""

    def all_areas(self):
        return self.areas

    def tracked(self):
        return ["tests/mutation/mutant.hpp", "tests/mutation/toy/toy_test.cpp"]

    def configure(self):
        self.build_folder.joinpath("bin").mkdir(parents=True, exist_ok=True)

    def programs(self):
        return ["toy"]

    def build_command(self):
        sources = [self.copy / "tests/mutation/toy" / name for name in ("toy.cpp", "toy_test.cpp")]
        return [os.environ.get("CXX", "c++"), "-std=c++20", "-w", f"-I{self.copy}", *sources, "-o", self.program("toy"),
                "-lgtest_main", "-lgtest", "-pthread"]
