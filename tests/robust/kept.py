"""Kept work: what was there stays whole, on full and read-only disks, after SIGKILL, and beside a second writer.

kept.py DIRECTORY_OF_PROGRAMS [--trials N] [--only SCENE] [--seed S]

Scenes: full_disk, read_only_folder, full_device, closed_output, printed, killed, resumed, cut_output, two_writers,
two_experiments, two_killed. --trials N: half of them kills of killed, a quarter of resumed and of cut_output each; the
first four scenes try each command that writes. Only root has a full disk and devices; a scene that is skipped says so.
"""
import os
import signal
import subprocess
import sys
import time

import unwritable
from trials import DONE, NO, Programs, Trials, parser
from writers import is_whole, make_inputs, writers

PATIENCE = 120  # seconds


def has_unnamed_files(folder):  # of which a killed process leaves nothing
    try:
        os.close(os.open(folder, os.O_TMPFILE | os.O_WRONLY))
    except OSError:
        return False
    return True


def is_temporary(name):  # what a killed process leaves behind
    return os.path.basename(name).startswith(".waymark.")


class Kept:
    def __init__(self, options):
        self.options, self.trials, self.programs = options, Trials("kept", options), Programs(options)
        self.folder, self.new, self.seconds = None, {}, {}

    def measure(self, writer):
        """The bytes that a writer writes when nothing disturbs it, and the seconds that it takes."""
        if writer.name not in self.new:
            place = self.folder / "undisturbed"
            place.mkdir()
            unwritable.put_old_files(writer, place)
            result = self.programs.run(writer.at(place), self.folder, seconds=PATIENCE)
            if result.code not in (DONE, NO):
                raise SystemExit(f"error: {self.programs.text(writer.at(place))} ends with {result.code}: {result.err}")
            self.new[writer.name] = {name: file.read_bytes() for name, file in unwritable.files_in(place).items()}
            writer.outputs = sorted(self.new[writer.name])
            self.seconds[writer.name] = result.seconds
            subprocess.run(["rm", "-r", str(place)], check=True)
        return self.new[writer.name]

    def wants(self, scene):
        return any(name in scene for name in self.options.only.split(","))

    def unwritable(self, scene, chosen):
        for number, writer in enumerate(chosen):
            skipped = scene(self.trials, self.programs, self.folder, writer, self.measure(writer),
                            self.trials.random(f"{scene.__name__} {number}"))
            if skipped:
                print(f"SKIPPED: {scene.__name__}: {skipped}")
                return

    def fault(self, why, arguments, **facts):
        self.trials.fault(why, self.programs.text(arguments), **facts)

    def stays(self, why, arguments):
        if has_unnamed_files(self.folder):
            self.fault(why, arguments)
        else:
            self.trials.counts["killed: a temporary file stays"] += 1

    def kill(self, process, random, longest, place):
        """SIGKILL at a random moment, or as soon as a temporary file is seen. Was the process still at work?"""
        end = time.monotonic() + (longest if random.random() < 0.5 else random.uniform(0, longest))
        while process.poll() is None and time.monotonic() < end:
            if end - time.monotonic() < longest and any(
                    name.name.startswith(".waymark") for name in os.scandir(place)):
                break
        process.send_signal(signal.SIGKILL)
        return process.wait() == -signal.SIGKILL

    def killed(self, chosen):
        """Old or new whole files after a kill; the same command then writes what it would have written."""
        kills = 0
        for number in range(self.options.trials // 2):
            random = self.trials.random(f"killed {number}")
            often = [w for w in chosen if w.name in ("train", "import", "evaluate", "generate corpus")]
            writer = random.choice(often if often and random.random() < 0.7 else chosen)
            new, place = self.measure(writer), self.folder / "place"
            place.mkdir()
            unwritable.put_old_files(writer, place)
            process = self.programs.start(writer.at(place), self.folder)
            kills += self.kill(process, random, 1.2 * self.seconds[writer.name], place / "old"
                               if (place / "old").is_dir() else place)
            for name, file in unwritable.files_in(place).items():
                if name not in writer.outputs:
                    self.stays(f"killed {writer.name}: {name} is left behind", writer.at(place))
                elif file.read_bytes() != unwritable.OLD and not is_whole(writer, name, file.read_bytes(), new):
                    self.fault(f"killed {writer.name}: {name} is neither old nor whole", writer.at(place), trial=number)
            result = self.programs.run(writer.at(place), self.folder, seconds=PATIENCE)
            wrong = [name for name in writer.outputs if not is_whole(writer, name, (place / name).read_bytes(), new)]
            if result.code not in (DONE, NO) or wrong:
                self.fault(f"killed {writer.name}: the same command then ends with {result.code}, other files: {wrong}",
                           writer.at(place), trial=number, err=result.err)
            subprocess.run(["rm", "-r", str(place)], check=True)
        self.trials.counts["killed: SIGKILL at work"] += kills

    def experiment(self, directory):
        return ["experiment", "compare-systems", "--corpus", self.folder / "little", "--checkpoints", directory,
                "--ensemble", "1", "--epochs", "1", "--convention", "relative", "--json"]

    def parts(self, directory):
        return {name: file.read_bytes() for name, file in unwritable.files_in(directory).items()}

    def resumed(self, _chosen):
        """An experiment is killed again and again; its table and its parts have the bytes of one left alone."""
        whole = self.programs.run(self.experiment("whole"), self.folder, seconds=600)
        parts, kills, round_number = self.parts(self.folder / "whole"), 0, 0
        while kills < self.options.trials // 4:
            round_number += 1
            directory = self.folder / f"resumed-{round_number}"
            directory.mkdir()
            more = True
            while more and kills < self.options.trials // 4:
                random = self.trials.random(f"resumed {round_number} {kills}")
                process = self.programs.start(self.experiment(directory), self.folder)
                more = self.kill(process, random, whole.seconds / 4, directory)
                kills += more
                for name, contents in self.parts(directory).items():
                    if is_temporary(name):
                        self.stays(f"killed experiment: {name} is left behind", self.experiment(directory))
                    elif contents != parts.get(name):
                        self.fault(f"killed experiment: {name} is not whole", self.experiment(directory))
            result = self.programs.run(self.experiment(directory), self.folder, seconds=600)
            left = self.parts(directory)
            if result.code != DONE or result.out != whole.out or left != parts:
                odd = sorted(name for name in {*left, *parts} if left.get(name) != parts.get(name))
                self.fault("a resumed experiment differs from one left alone", self.experiment(directory),
                           code=result.code, out=result.out, whole=whole.out, parts=odd, err=result.err)
        self.trials.counts["resumed: SIGKILL at work"] += kills

    def cut_output(self, _chosen):
        """`translate -F … > file` is killed: the file begins as the whole answer does."""
        arguments = ["translate", "-F", "formulas", "--one-line"]
        whole = self.programs.run(arguments, self.folder, seconds=PATIENCE)
        for number in range(self.options.trials // 4):
            random = self.trials.random(f"cut {number}")
            with open(self.folder / "answers", "wb") as answers:
                process = self.programs.start(arguments, self.folder, stdout=answers)
                time.sleep(random.uniform(0, 1.1 * whole.seconds))
                process.send_signal(signal.SIGKILL)
            killed = process.wait() == -signal.SIGKILL
            text = (self.folder / "answers").read_text()
            self.trials.counts[f"cut output: {'SIGKILL at work' if killed else 'ended before'}"] += 1
            self.trials.counts["cut output: the last line is whole"] += text.endswith("\n") or not text
            if not whole.out.startswith(text) or not killed and text != whole.out:
                self.fault("translate > file: the file is no beginning of the answer", arguments, trial=number,
                           out=text[-300:])

    def two_writers(self, _chosen):
        """Several processes write one file at the same time: one of their files is there, and nothing else."""
        little = self.folder / "little"
        made = {}
        for number in range(max(3, self.options.trials // 20)):
            place = self.folder / "place"
            place.mkdir()
            commands = [["train", "--corpus", little, "--epochs", "1", "--seed", str(seed), "--out",
                         place / "old.waymark"] for seed in (1, 2, 3)]
            for command in commands:
                if str(command) not in made:
                    self.programs.prepare(command, self.folder)
                    made[str(command)] = (place / "old.waymark").read_bytes()
            ends = [process.wait() for process in [self.programs.start(c, self.folder) for c in commands]]
            names = sorted(unwritable.files_in(place))
            if ends != [DONE] * len(commands) or names != ["old.waymark"] or \
                    (place / "old.waymark").read_bytes() not in made.values():
                self.fault(f"three writers of one file: exit codes {ends}, files {names}", commands[0], trial=number)
            self.trials.counts["two writers: one whole file"] += 1
            subprocess.run(["rm", "-r", str(place)], check=True)

    def two_experiments(self, _chosen):
        """Two processes fill one directory: both print the table, or one refuses; the parts are whole."""
        whole = self.programs.run(self.experiment("both-whole"), self.folder, seconds=600)
        parts = self.parts(self.folder / "both-whole")
        for number in range(max(2, self.options.trials // 40)):
            directory = self.folder / f"both-{number}"
            processes = [self.programs.start(self.experiment(directory), self.folder, stdout=subprocess.PIPE,
                                             stderr=subprocess.PIPE) for _ in range(2)]
            ends = [(*process.communicate(timeout=600), process.returncode) for process in processes]
            codes = sorted(code for _, _, code in ends)
            self.trials.counts[f"two experiments in one directory: exit codes {codes}"] += 1
            left = self.parts(directory)
            bad = [name for name, contents in left.items() if parts.get(name) != contents]
            for out, err, code in ends:
                if code != DONE or out.decode() != whole.out:
                    self.fault(f"two experiments in one directory: one ends with {code}", self.experiment(directory),
                               trial=number, err=err.decode()[-600:], parts=bad)
            if bad:
                self.fault(f"two experiments in one directory: parts that are not whole: {bad}",
                           self.experiment(directory), trial=number)

    def two_killed(self, _chosen):
        """Two processes fill one directory and are killed at about the same moment: every part is whole."""
        whole = self.programs.run(self.experiment("killed-whole"), self.folder, seconds=600)
        parts = self.parts(self.folder / "killed-whole")
        for number in range(self.options.trials // 4):
            random, directory = self.trials.random(f"two killed {number}"), self.folder / f"two-killed-{number}"
            pair = [self.programs.start(self.experiment(directory), self.folder) for _ in range(2)]
            time.sleep(random.uniform(0, whole.seconds))
            for process in pair:
                process.kill()
                process.wait()
                time.sleep(random.choice([0, 0.001]))
            left = self.parts(directory) if directory.exists() else {}
            bad = [name for name in left if not is_temporary(name) and left[name] != parts.get(name)]
            self.trials.counts["two killed experiments: parts that are whole"] += len(left) - len(bad)
            if bad:
                self.fault(f"two killed experiments in one directory: not whole: {bad}", self.experiment(directory),
                           trial=number, bytes=[(len(left[name]), len(parts[name])) for name in bad])
            subprocess.run(["rm", "-rf", str(directory)], check=True)

    def run(self):
        with self.trials.scratch() as self.folder:
            make_inputs(self.programs, self.folder)
            chosen = [writer for writer in writers(self.folder, self.programs)
                      if not self.options.writers or writer.name in self.options.writers.split(",")]
            for scene in unwritable.SCENES:
                if self.wants(scene.__name__):
                    self.unwritable(scene, chosen)
            if self.wants("printed"):
                unwritable.printed_into_full_places(self.trials, self.programs, self.folder)
            for scene in (self.killed, self.resumed, self.cut_output, self.two_writers, self.two_experiments,
                          self.two_killed):
                of_the_lab = scene.__name__ in ("resumed", "two_experiments", "two_killed")
                if self.wants(scene.__name__) and (not of_the_lab or self.programs.has("waymark-lab")):
                    scene(chosen)
        return self.trials.end()


def main():
    options = parser(__doc__, 100)
    options.add_argument("--only", default="", metavar="SCENE", help="only scenes whose names contain it; a,b: or b")
    options.add_argument("--writers", default="", metavar="NAME,…", help="these commands of writers.py only")
    return Kept(options.parse_args()).run()


if __name__ == "__main__":
    sys.exit(main())
