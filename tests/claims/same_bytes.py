#!/usr/bin/env python3
"""Do two builds of waymark, by other compilers say, print and write the same bytes?

  tests/claims/same_bytes.py WAYMARK OTHER [--formulas N] [--seed S] [--without train,motion]

Random formulas are translated to every kind of automaton, and what reads, plans, draws, generates and trains is run on
inputs that the first program writes. Both read the data of the first. Seconds and versions are no part of what is
compared. Ends with 1 when an output differs or a command fails.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

KINDS = ["tgba", "buchi", "parity", "rabin", "ldba", "generic"]
CLOCK = re.compile(rb'"seconds":\{[^}]*\}|"[a-z_]*seconds":[0-9.e+-]+|[0-9.]+ m?s\b|(?<= %)\s+[0-9.]+$', re.MULTILINE)


class Build:
    def __init__(self, program, folder, data):
        self.program, self.folder = pathlib.Path(program).resolve(), folder
        self.environment = os.environ | {"WAYMARK_DATA": str(data)}
        folder.mkdir()

    def run(self, arguments, stdin=b""):
        """The exit code and every byte that was printed or written, by name; "printed" is kept for the next command."""
        before = set(self.folder.iterdir())
        done = subprocess.run([self.program, *arguments], cwd=self.folder, env=self.environment, input=stdin,
                              capture_output=True, timeout=1200, check=False)
        out = {"exit": str(done.returncode).encode(), "stdout": CLOCK.sub(b"#", done.stdout),
               "stderr": CLOCK.sub(b"#", done.stderr)}
        for path in sorted(self.folder.rglob("*")):
            if path.is_file() and path not in before:
                out[str(path.relative_to(self.folder))] = path.read_bytes()
        (self.folder / "printed").write_bytes(done.stdout)
        return out


def translations(formulas):
    for kind in KINDS:
        yield ["translate", "-F", "-", "--to", kind, "--limit-states", "20000"], formulas["infinite"]
    yield ["translate", "-F", "-", "--to", "dfa"], formulas["finite"]
    yield ["translate", "-F", "-", "--to", "dfa", "--format", "dot"], formulas["finite"]
    yield ["explain", "G(a -> F(b & X !c))"], b""


def journeys(motion):
    said = "go to the sofa, then to the lamp without passing the chair"
    for name in ("grid", "jelly", "l"):
        yield ["run", said, "--map", name, "--json"], b""
        yield ["ground", said, "--map", name, "--top", "5", "--json"], b""
        yield ["run", said, "--map", name, "--svg", f"{name}.svg"], b""
    yield ["compare", "F sofa", "--map", "grid", "--seeds", "2", "--steps", "2000"], b""
    for name, seed in [("grid", "3"), ("grid", "4"), ("jelly", "1"), ("l", "2")] if motion else []:
        yield ["move", "F sofa", "--map", name, "--seed", seed, "--json"], b""


def others(formulas):
    """The subcommands that stand nowhere else, of what was printed before them too."""
    yield ["compose", "F easel", "--map", "grid", "--start", "1,9,0", "--json"], b""
    yield ["plan", "F easel & G !sofa", "--map", "grid", "--start", "1,9,0", "--json"], b""
    yield ["check", "F easel", "--trajectory", "printed"], b""
    yield ["plan", "F easel & G !sofa", "--map", "grid", "--start", "1,9,0", "--json"], b""
    yield ["verify", "printed"], b""
    yield ["plan", "G F sofa & G F chair", "--semantics", "infinite", "--start", "1,9,0", "--json"], b""
    yield ["draw", "--map", "grid", "--svg", "map.svg"], b""
    yield ["draw", "automaton", "--formula", "F (sofa & X F lamp)", "--svg", "automaton.svg"], b""
    yield ["monitor", "G(a -> F b)"], b"{a}\n{b}\n{}\n"
    yield ["compare-formulas", "F a & F b", "F(a & F b) | F(b & F a)"], b""
    yield ["translate", "-F", "-", "--to", "tgba", "--one-line", "--limit-states", "2000"], formulas["infinite"]
    yield ["automaton", "printed", "--to", "never"], b""
    yield ["map", "grid", "--json"], b""
    yield ["patterns", "--list"], b""
    yield ["help", "conventions"], b""


def cases():
    for kind in ("rooms", "maze", "scatter", "bridge", "oneway"):
        for noise in ("0", "0.05"):
            yield ["generate", "map", "--kind", kind, "--width", "30", "--height", "30", "--noise", noise,
                   "--seed", "3", "--tasks"], b""
            yield ["plan", "--case", "printed", "--json"], b""


def learning():
    yield ["generate", "corpus", "--map", "grid", "--map", "l", "--paragraphs", "60", "--out", "corpus"], b""
    for model in ("linear", "encoder-decoder"):
        fast = ["--corpus", "corpus", "--model", model, "--seed", "1", "--epochs", "3"]
        yield ["train", *fast, "--commands", "own", "--own-commands", "2000", "--networks", "1",
               "--command-epochs", "1", "--out", f"{model}.waymark"], b""
        yield ["evaluate", *fast, "--leave-one-map-out", "--json"], b""


def differences(first, other, jobs):
    for arguments, stdin in jobs:
        a, b = first.run(arguments, stdin), other.run(arguments, stdin)
        names = [name for name in sorted(a.keys() | b.keys()) if a.get(name) != b.get(name)]
        size = sum(map(len, a.values()))
        print(f"{'DIFFERS' if names else 'same':8} exit {a['exit'].decode():3} {size:10} bytes  {' '.join(arguments)}",
              *names, flush=True)
        yield bool(names) or a["exit"] not in (b"0", b"10")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", nargs=2, metavar="WAYMARK")
    parser.add_argument("--formulas", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--without", default="")
    options = parser.parse_args()
    left_out = options.without.split(",")
    with tempfile.TemporaryDirectory() as scratch:
        data = pathlib.Path(options.builds[0]).resolve().parent.parent / "share" / "waymark"
        first, other = (Build(program, pathlib.Path(scratch) / name, data)
                        for program, name in zip(options.builds, ("first", "other")))
        drawn = {words: ["random", "--count", str(options.formulas), "--seed", str(options.seed), "--semantics", words]
                 for words in ("infinite", "finite")}
        formulas = {words: first.run(arguments)["stdout"] for words, arguments in drawn.items()}
        jobs = [(arguments, b"") for arguments in drawn.values()]
        jobs += [*translations(formulas), *cases(), *journeys("motion" not in left_out), *others(formulas)]
        jobs += [] if "train" in left_out else learning()
        found = list(differences(first, other, jobs))
    print(f"{len(found)} commands, {sum(found)} differ or fail")
    return any(found)


if __name__ == "__main__":
    sys.exit(main())
