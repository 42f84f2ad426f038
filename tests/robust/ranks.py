"""Ranks of mpirun: the bytes of one process, whatever their number and whoever is killed.

ranks.py DIRECTORY_OF_PROGRAMS [--trials N] [--only SCENE] [--ranks N] [--seed S]

Scenes: same (translate and ground on 1, 2 and 4 ranks), killed_hands (SIGKILL to processes that answer, --trials of
them), killed_rank (one rank under `mpirun --enable-recovery`), killed_job (one rank without it, again and again; --kept
goes on), killed_experiment (SIGKILL to processes that learn, a quarter of --trials), refused. Exit code 77 where mpirun
or waymark-farm is missing.
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from trials import DONE, USAGE, Finished, Programs, Trials, parser

PATIENCE = 120  # seconds
SECONDS = re.compile(r'"seconds":[0-9.e+-]+|\t[0-9]+\.[0-9]{6}\t')  # what differs between two runs of one process, too
BAD = ["F (a", "# a comment", "", "G a b", "a U"]


def comparable(text):
    return SECONDS.sub("SECONDS", text)


def processes(folder, variable):
    """Those that work in the folder, whose environment has this beginning of a line."""
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        try:
            if os.readlink(place / "cwd") == str(folder) and any(
                    line.startswith(variable) for line in (place / "environ").read_bytes().split(b"\0")):
                found.append(int(place.name))
        except OSError:
            continue
    return sorted(found)


def kill(process):
    try:
        os.kill(process, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


def parts(folder):
    return {file.name: file.stat().st_mtime_ns for file in folder.iterdir() if file.suffix == ".replies"}


class Ranks:
    def __init__(self, options):
        self.options, self.trials, self.programs = options, Trials("ranks", options), Programs(options)
        # Small chunks: there is something to kill at every moment.
        self.environment = {**self.programs.environment, "OMPI_ALLOW_RUN_AS_ROOT": "1",
                            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "WAYMARK_CHUNK_SECONDS": "0.02"}
        self.folder = None

    def start(self, ranks, arguments, *options, **streams):
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *options, *self.programs.command(arguments)]
        # Files, not pipes: nobody reads while processes are killed.
        with open(self.folder / "out", "wb") as out, open(self.folder / "err", "wb") as err:
            streams = {"stdin": subprocess.DEVNULL, "stdout": out, "stderr": err, **streams}
            return subprocess.Popen(command, cwd=self.folder, env=self.environment, **streams)

    def finish(self, process, given=None):
        begun = time.monotonic()
        try:
            process.communicate(given, timeout=PATIENCE)
            code = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            code = None
        out, err = ((self.folder / name).read_bytes().decode(errors="replace") for name in ("out", "err"))
        return Finished(code, out, err, time.monotonic() - begun)

    def make_inputs(self):
        bad = iter(BAD * 100)
        formulas = self.programs.prepare(
            ["random", "--count", "3000", "--size", "5..12", "--seed", str(self.options.seed)], self.folder).out
        lines = [line if i % 50 else next(bad) for i, line in enumerate(formulas.splitlines())]
        (self.folder / "mixed.ltl").write_text("\n".join(lines) + "\n")
        (self.folder / "good.ltl").write_text(formulas)
        self.programs.prepare(["generate", "corpus", "--out", "little", "--paragraphs", "6", "--seed", "1"], self.folder)
        pairs = (self.folder / "little" / "pairs.tsv").read_text().splitlines()
        (self.folder / "texts").write_text("\n".join(line.split("\t")[0] for line in pairs) + "\n")

    def compare(self, scene, arguments, whole, result):
        if result.code != whole.code or comparable(result.out) != comparable(whole.out) or whole.err not in result.err:
            self.trials.fault(f"{scene}: not the answer of one process", self.programs.text(arguments),
                              code=result.code, wanted=whole.code, err=result.err, out=result.out[:500])

    def same(self):
        for arguments, numbers in (
                (["translate", "-F", "mixed.ltl", "--one-line"], (1, 2, 4)),
                (["translate", "-F", "mixed.ltl", "--to", "dfa", "--format", "stats"], (4,)),
                (["translate", "F a", "F (", "G b"], (4,)), (["translate", "F a"], (2,)), (["translate", "F ("], (2,)),
                (["ground", "-F", "texts", "--map", "grid", "--json"], (2, 4)), (["translate", "-F", "absent"], (2,))):
            whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
            for ranks in numbers:
                self.compare("same", arguments, whole, self.finish(self.start(ranks, arguments)))
                self.trials.counts["same: on ranks and on one process"] += 1
        given = (self.folder / "good.ltl").read_bytes()
        arguments = ["translate", "--one-line"]
        whole = self.programs.run(arguments, self.folder, given=given, seconds=PATIENCE)
        self.compare("same", arguments, whole, self.finish(self.start(4, arguments, stdin=subprocess.PIPE), given))

    def kill_some(self, process, random, variable, most, longest):
        """SIGKILL at random moments to processes that live so long; how many."""
        killed = 0
        while process.poll() is None and killed < most:
            time.sleep(random.uniform(0, longest))
            alive = processes(self.folder, variable)
            if alive and process.poll() is None:
                killed += kill(random.choice(alive))
        return killed

    def killed_hands(self):
        arguments = ["translate", "-F", "good.ltl", "--to", "dfa", "--format", "json", "--certify"]
        whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
        kills, number = 0, 0
        while kills < self.options.trials:
            random = self.trials.random(f"hands {number}")
            process = self.start(self.options.ranks, arguments)
            kills += self.kill_some(process, random, b"WAYMARK_FARM=hand", self.options.trials - kills, 0.15)
            self.compare("killed_hands", arguments, whole, self.finish(process))
            number += 1
            if number > 100 and kills == 0:
                raise SystemExit("error: no process was killed in 100 runs")
        self.trials.counts["killed_hands: SIGKILL"] += kills

    def rank_to_kill(self, process):
        """Waits until rank 1 is there and has begun."""
        end = time.monotonic() + PATIENCE
        while process.poll() is None and time.monotonic() < end:
            ranks = set(processes(self.folder, b"OMPI_COMM_WORLD_RANK=1")) - set(
                processes(self.folder, b"WAYMARK_FARM="))
            if ranks and processes(self.folder, b"WAYMARK_FARM=hand"):
                return min(ranks)
            time.sleep(0.02)
        return None

    def killed_rank(self):
        arguments = ["translate", "-F", "good.ltl", "--to", "dfa", "--format", "json", "--certify"]
        whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
        process = self.start(self.options.ranks, arguments, "--enable-recovery")
        rank = self.rank_to_kill(process)
        if rank is None:
            raise SystemExit("error: no rank was there to be killed")
        time.sleep(0.2)
        self.trials.counts["killed_rank: SIGKILL"] += kill(rank)
        self.compare("killed_rank", arguments, whole, self.finish(process))

    def killed_job(self):
        arguments = ["translate", "-F", "good.ltl", "--one-line", "--certify", "--to", "dfa", "--format", "json"]
        whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
        kept = self.folder / "kept"
        arguments += ["--kept", kept]
        kills = 0
        while True:
            process = self.start(self.options.ranks, arguments)
            before = parts(kept) if kept.exists() else {}
            if kills < 3:
                rank = self.rank_to_kill(process)
                time.sleep(0.2)
                kills += rank is not None and kill(rank)
            result = self.finish(process)
            after = parts(kept)
            again = [name for name, when in before.items() if after.get(name) != when]
            if again:
                self.trials.fault("killed_job: what was kept is answered again", self.programs.text(arguments),
                                  parts=again)
            self.trials.counts["killed_job: parts found again"] += len(before)
            if result.code == DONE:
                break
        self.compare("killed_job", arguments, whole, result)
        self.trials.counts["killed_job: SIGKILL"] += kills

    def killed_experiment(self):
        arguments = ["tune", "--corpus", "little", "--grid", "epochs=1,2", "--grid", "rate=0.1,0.2", "--threads", "1"]
        whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
        random = self.trials.random("experiment")
        process = self.start(self.options.ranks, [*arguments, "--checkpoints", "shared"])
        kills = self.kill_some(process, random, b"WAYMARK_FARM=together", max(1, self.options.trials // 4), 0.5)
        self.compare("killed_experiment", arguments, whole, self.finish(process))
        again = self.programs.run([*arguments, "--checkpoints", "shared"], self.folder, seconds=PATIENCE)
        self.compare("killed_experiment, again by one process", arguments, whole, again)
        self.trials.counts["killed_experiment: SIGKILL"] += kills

    def refused(self):
        for arguments in (["tune", "--corpus", "little"], ["experiment", "feedback-cost"]):
            result = self.finish(self.start(2, arguments))
            if result.code != USAGE or "give --checkpoints DIR" not in result.err:
                self.trials.fault("refused: not refused", self.programs.text(arguments), code=result.code,
                                  err=result.err)
            self.trials.counts["refused"] += 1

    def run(self):
        with self.trials.scratch() as folder:
            self.folder = folder.resolve()
            self.make_inputs()
            for scene in (self.same, self.killed_hands, self.killed_rank, self.killed_job, self.killed_experiment,
                          self.refused):
                if self.options.only in scene.__name__:
                    begun = time.monotonic()
                    scene()
                    print(f"  {time.monotonic() - begun:6.1f} s  {scene.__name__}")
        return self.trials.end()


def main():
    options = parser(__doc__, 20)
    options.add_argument("--only", default="", metavar="SCENE", help="only scenes whose name contains SCENE")
    options.add_argument("--ranks", type=int, default=4, metavar="N", help="where ranks are killed [4]")
    options = options.parse_args()
    if shutil.which("mpirun") is None or not (options.programs / "waymark-farm").exists():
        print("SKIPPED: mpirun or waymark-farm is missing")
        return 77
    return Ranks(options).run()


if __name__ == "__main__":
    sys.exit(main())
