"""Planning cases among the ranks of mpirun: the values of one process, whatever the number of ranks and whoever
is killed.

distributed.py DIRECTORY_OF_PROGRAMS [--trials N] [--only SCENE] [--side N] [--seed S]

Scenes: same (--trials generated cases on 1 to 4 ranks, all queries that ranks share, value by value within 1e-9),
passage (halves of free ground and a bridge between lava), killed (SIGKILL to a rank at random moments, --trials times;
the same command goes on, on another number of ranks), refused. Exit code 77 where mpirun or waymark-distributed is
missing.
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import time

from trials import BAD_INPUT, DONE, NO, SOURCE, USAGE, Finished, Programs, Trials, parser

PATIENCE = 300  # seconds
CLOSE = 1e-9  # of values; of costs, relative
TOLERANCE = "1e-10"
ALONE = ["--limit-seconds", "10"]  # of a task on one process, where bounds this near may not meet
SAME_KEYS = ["case", "task", "query", "formula", "semantics", "automaton_states", "product_states", "product_edges",
             "status"]
SHARED = ("pmax", "pmin", "rmin", "discounted")
MORE_TASKS = [
    ("least", "ltl", "F a", "pmin"), ("avoid_least", "ltl", "(!b) U a", "pmin"),
    ("soon", "ltl", "F (a & F b)", "discounted"), ("for_ever", "ltl", "G F a & G !b", "pmax"),
    ("least_for_ever", "ltl", "F G !a", "pmin"),
    ("persist", "ltl", "F G (!a & !b)", "pmax"), ("careful", "ltl", "(!b) U a", "rmin"),
    ("both", "ltl", "G F a & F G !a", "pmax"), ("not_seen", "ltl", "F nowhere", "pmax"),
    ("finite", "ltlf", "F (a & X F b)", "pmax"), ("bounded", "pctl", "F<=9 a", "pmax")]


class Distributed:
    def __init__(self, options):
        self.options, self.trials, self.programs = options, Trials("distributed", options), Programs(options)
        self.environment = {**self.programs.environment, "OMPI_ALLOW_RUN_AS_ROOT": "1",
                            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        self.folder = None

    def start(self, ranks, arguments):
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *self.programs.command(arguments)]
        with open(self.folder / "out", "wb") as out, open(self.folder / "err", "wb") as err:
            return subprocess.Popen(command, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                    stdout=out,
                                    stderr=err)

    def finish(self, process):
        begun = time.monotonic()
        try:
            code = process.wait(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            code = None
        out, err = ((self.folder / name).read_bytes().decode(errors="replace") for name in ("out", "err"))
        return Finished(code, out, err, time.monotonic() - begun)

    def write_case(self, arguments, name, tasks):
        """A generated case with more tasks: those that ranks share."""
        case = json.loads(self.programs.prepare(arguments, self.folder).out)
        case["tasks"] = [task for task in case.get("tasks", []) if task["query"] in SHARED]
        case["tasks"] += [dict(zip(("id", "logic", "formula", "query"), task)) for task in tasks]
        (self.folder / name).write_text(json.dumps(case))

    @staticmethod
    def close(query, one, other):
        if one == other:
            return True
        if "inf" in (one, other) or one is None or other is None:
            return False
        return abs(one - other) <= CLOSE * (max(1, abs(one)) if query == "rmin" else 1)

    def compare(self, scene, arguments, whole, result, ranks):
        wanted, found = ([json.loads(line) for line in text.splitlines()] for text in (whole.out, result.out))
        given_up = [i for i, one in enumerate(wanted) if one["status"] == "exhausted"]
        if result.code is None or (not given_up and result.code != whole.code) or len(wanted) != len(found):
            return self.trials.fault(f"{scene}: not the answers of one process, on {ranks} ranks",
                                     self.programs.text(arguments), code=result.code, wanted=whole.code,
                                     err=result.err, out=result.out)
        self.trials.counts[f"{scene}: given up by one process"] += len(given_up)
        for i, (one, other) in enumerate(zip(wanted, found)):
            if i in given_up:
                continue
            bad = [key for key in SAME_KEYS if one.get(key) != other.get(key)]
            if not self.close(one["query"], one["value"], other["value"]):
                bad.append("value")
            if one["lower"] not in ("inf", None) and other["lower"] not in ("inf", None):
                slack = 1e-13 * max(1, abs(one["upper"]))  # of the rounding of sums
                if other["lower"] > one["upper"] + slack or one["lower"] > other["upper"] + slack:
                    bad.append("bounds without a common value")
            if set(one) - set(other) or set(other) - set(one):
                bad.append("other keys")
            if one.get("dropped") != other.get("dropped"):
                bad.append("dropped")
            if bad:
                self.trials.fault(f"{scene}: {', '.join(bad)} on {ranks} ranks", self.programs.text(arguments),
                                  one=json.dumps(one), other=json.dumps(other),
                                  case=(self.folder / arguments[2]).read_text())
            self.trials.counts[f"{scene}: values"] += 1

    def same(self):
        for trial in range(self.options.trials):
            random = self.trials.random(f"same {trial}")
            kind = random.choice(["rooms", "maze", "oneway", "scatter", "bridge"])
            side = random.randint(12, self.options.side)
            noise = random.choice([0, 0.05, 0.1, 0.2])
            self.write_case(["generate", "map", "--kind", kind, "--width", side, "--height", random.randint(12, side),
                             "--landmarks", random.randint(2, 3), "--noise", noise, "--seed", trial, "--tasks"],
                            "case.json", MORE_TASKS)
            arguments = ["plan", "--case", "case.json", "--tolerance", TOLERANCE, "--json"]
            whole = self.programs.run([*arguments, "--method", "vi", *ALONE], self.folder, seconds=PATIENCE)
            for ranks in (1, 2, 3, 4):
                local = ["--local-sweeps", str(random.choice([1, 2, 5]))]
                result = self.finish(self.start(ranks, arguments + local))
                self.compare(f"same, {kind}", arguments, whole, result, ranks)

    def passage(self):
        for side, width, noise in ((30, 1, 0.05), (40, 2, 0.05), (50, 1, 0.05), (50, 3, 0.02)):
            written = subprocess.run([sys.executable, "-B", SOURCE / "tests/claims/passage.py", str(side), str(width),
                                      str(noise)], stdout=subprocess.PIPE, check=True).stdout
            (self.folder / "case.json").write_bytes(written)
            arguments = ["plan", "--case", "case.json", "--tolerance", TOLERANCE, "--json"]
            whole = self.programs.run([*arguments, "--method", "vi", *ALONE], self.folder, seconds=PATIENCE)
            for ranks in (2, 4):
                self.compare("passage", arguments, whole, self.finish(self.start(ranks, arguments)), ranks)

    def ranks_of(self, process):
        """Processes of waymark-distributed below this mpirun."""
        found = []
        for place in os.listdir("/proc"):
            if not place.isdigit():
                continue
            try:
                with open(f"/proc/{place}/stat", encoding="utf-8") as file:
                    text = file.read()
                parent = int(text.rsplit(")", 1)[1].split()[1])
                if parent == process.pid and "(waymark-distrib" in text:
                    found.append(int(place))
            except OSError:
                continue
        return sorted(found)

    def has_proved(self):
        kept = self.folder / "kept"
        return kept.exists() and any(file.suffix == ".proved" for file in kept.iterdir())

    def killed(self):
        self.write_case(["generate", "map", "--kind", "rooms", "--width", 200, "--height", 200, "--landmarks", 3,
                         "--noise", 0.1, "--seed", self.options.seed, "--tasks"], "case.json", MORE_TASKS[:3])
        arguments = ["plan", "--case", "case.json", "--tolerance", TOLERANCE, "--json"]
        whole = self.programs.run([*arguments, "--method", "vi", *ALONE], self.folder, seconds=PATIENCE)
        kills = number = 0
        while kills < self.options.trials:
            random = self.trials.random(f"killed {number}")
            number += 1
            if number > 20 * self.options.trials:
                raise SystemExit("error: too few processes were there to be killed")
            shutil.rmtree(self.folder / "kept", ignore_errors=True)
            while True:
                ranks = random.randint(2, 4)
                kept = ["--checkpoints", "kept", "--checkpoint-seconds", "0.02", "--statistics", "done"]
                process = self.start(ranks, arguments + kept)
                end = time.monotonic() + (PATIENCE if random.random() < 0.5 else 0)  # or before anything is kept
                while time.monotonic() < end and process.poll() is None and not self.has_proved():
                    time.sleep(0.01)
                time.sleep(random.uniform(0, 0.8))
                alive = self.ranks_of(process)
                if alive and kills < self.options.trials and process.poll() is None:
                    os.kill(random.choice(alive), signal.SIGKILL)
                    kills += 1
                result = self.finish(process)
                if result.code in (DONE, NO):
                    break
            self.compare("killed", arguments, whole, result, ranks)
            done = [json.loads(line) for line in (self.folder / "done").read_text().splitlines()]
            self.trials.counts["killed: blocks whose bounds were kept"] += sum(
                line["resumed"] for line in done if line["rank"] == 0)
        self.trials.counts["killed: SIGKILL to a rank"] += kills

    def refused(self):
        self.write_case(["generate", "map", "--kind", "rooms", "--width", 12, "--height", 12, "--landmarks", 2],
                        "case.json", [("walk", "ltlf", "F a", "steps"), ("go", "ltl", "F a", "pmax"),
                                      ("bad", "ltl", "F (", "pmax")])
        for arguments, code, words in (
                (["--case", "case.json", "--strategy", "there"], USAGE, "--strategy"),
                (["--case", "case.json", "--method", "pi"], USAGE, "--method vi"),
                (["--case", "case.json", "--task", "none"], USAGE, "has no task 'none'"),
                (["--case", "absent.json"], BAD_INPUT, "cannot read the file"),
                (["--case", "case.json", "--no-such-option"], USAGE, "no-such-option"),
                (["--case", "case.json"], BAD_INPUT, "query steps is not shared among ranks")):
            result = self.finish(self.start(2, ["plan", *arguments]))
            told = [line for line in result.err.splitlines() if words in line and "error" in line]
            if result.code != code or len(told) != 1:
                self.trials.fault("refused: not refused, or told more than once",
                                  self.programs.text(["plan", *arguments]), code=result.code, err=result.err)
            self.trials.counts["refused"] += 1

    def run(self):
        with self.trials.scratch() as folder:
            self.folder = folder.resolve()
            for scene in (self.same, self.passage, self.killed, self.refused):
                if self.options.only in scene.__name__:
                    begun = time.monotonic()
                    scene()
                    print(f"  {time.monotonic() - begun:6.1f} s  {scene.__name__}")
        return self.trials.end()


def main():
    options = parser(__doc__, 20)
    options.add_argument("--only", default="", metavar="SCENE", help="only scenes whose name contains SCENE")
    options.add_argument("--side", type=int, default=40, metavar="N", help="of generated maps, at most [40]")
    options = options.parse_args()
    if shutil.which("mpirun") is None or not (options.programs / "waymark-distributed").exists():
        print("SKIPPED: mpirun or waymark-distributed is missing")
        return 77
    return Distributed(options).run()


if __name__ == "__main__":
    sys.exit(main())
