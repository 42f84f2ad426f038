"""Batches in parts by many jobs: the examples of docs/scaling.md, run as they stand there.

jobs.py DIRECTORY_OF_PROGRAMS [--seed S]

Scenes: array (the script for a Slurm array, each of its tasks in a shell with Slurm's variables, some killed and
started again), experiment_array (the same of an experiment, all tasks at once), snakemake (with its local executor;
skipped, with a word, where snakemake is not installed).
"""
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

from trials import SOURCE, Programs, Trials, parser

PATIENCE = 240  # seconds


def processor_seconds():  # of programs that have ended
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def example(name):
    """The block of code behind the marker <!-- example: NAME --> of docs/scaling.md."""
    text = (SOURCE / "docs" / "scaling.md").read_text()
    found = re.search(rf"<!-- example: {re.escape(name)} -->\n```\w*\n(.*?)```\n", text, re.S)
    if not found:
        raise SystemExit(f"error: docs/scaling.md has no example {name}")
    return found[1]


class Jobs:
    def __init__(self, options):
        self.trials, self.programs = Trials("jobs", options), Programs(options)
        self.environment = {**self.programs.environment, "WAYMARK_CHUNK_SECONDS": "0.02",
                            "PATH": f"{self.programs.directory}:{os.environ['PATH']}"}
        self.seed, self.folder = options.seed, None

    def task(self, script, number, count):
        environment = {**self.environment, "SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_TASK_COUNT": str(count),
                       "SLURM_CPUS_PER_TASK": "1"}
        return subprocess.Popen(["bash", script], cwd=self.folder, env=environment, start_new_session=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def end(self, process):
        out, _ = process.communicate(timeout=PATIENCE)
        if process.returncode:
            raise SystemExit(f"error: {process.args} ends with {process.returncode}: {out}")

    def script(self, name):
        text = example(name)
        (self.folder / name).write_text(text)
        return int(re.search(r"^#SBATCH --array=1-(\d+)$", text, re.M)[1])

    def array(self):
        (self.folder / "corpus.ltl").write_text(self.programs.prepare(
            ["random", "--count", "60000", "--size", "5..12", "--seed", str(self.seed)], self.folder).out)
        translate = ["translate", "-F", "corpus.ltl", "--one-line", "--to", "dfa"]
        used = processor_seconds()
        whole = self.programs.prepare([*translate, "--threads", "1"], self.folder).out
        count = self.script("translate.sbatch")
        share = (processor_seconds() - used) / count  # of a task, and no less than that on the clock
        kills = 0
        for number in range(1, count + 1):
            process = self.task("translate.sbatch", number, count)
            if number % 2:
                time.sleep(self.trials.random(number).uniform(0.1, 0.9) * share)
                os.killpg(process.pid, signal.SIGKILL)
                process.communicate()
                kills += process.returncode == -signal.SIGKILL
                process = self.task("translate.sbatch", number, count)  # as Slurm requeues it
            self.end(process)
        if not kills:
            raise SystemExit("error: every task ended before it was killed")
        answers = "".join((self.folder / f"answers.{number}").read_text() for number in range(1, count + 1))
        if answers != whole:
            self.trials.fault("array: not the answer of one process", "translate.sbatch")
        gathered = self.programs.run([*translate, "--kept", "kept"], self.folder)
        if gathered.out != whole:
            self.trials.fault("array: what is kept is not the answer of one process", "translate --kept kept",
                              err=gathered.err)
        self.trials.counts["array: tasks"] += count
        self.trials.counts["array: tasks killed and started again"] += kills

    def experiment_array(self):
        corpus = ["generate", "corpus", "--out", "corpus", "--paragraphs", "6", "--seed", "1"]
        self.programs.prepare(corpus, self.folder)
        grid = ["tune", "--corpus", "corpus", "--grid", "epochs=1,2", "--grid", "rate=0.1,0.2", "--threads", "1"]
        whole = self.programs.prepare(grid, self.folder).out
        count = self.script("tune.sbatch")
        tasks = [self.task("tune.sbatch", number, count) for number in range(1, count + 1)]
        for task in tasks:
            self.end(task)
        for number in range(1, count + 1):
            if (self.folder / f"table.{number}").read_text() != whole:
                self.trials.fault(f"experiment_array: task {number} has another table", "tune.sbatch")
        self.trials.counts["experiment_array: tasks"] += count

    def snakemake(self):
        if shutil.which("snakemake") is None:
            print("SKIPPED: snakemake is not installed: its example is not run")
            return
        (self.folder / "Snakefile").write_text(example("Snakefile"))
        for name in ("kept", "answers"):
            shutil.rmtree(self.folder / name, ignore_errors=True)
        for file in self.folder.glob("answers*"):
            file.unlink()
        result = subprocess.run(["snakemake", "--cores", "2", "--quiet"], cwd=self.folder, env=self.environment,
                                capture_output=True, text=True, timeout=PATIENCE, check=False)
        whole = self.programs.prepare(["translate", "-F", "corpus.ltl", "--one-line", "--to", "dfa"], self.folder).out
        answers = self.folder / "answers"
        if result.returncode or not answers.exists() or answers.read_text() != whole:
            self.trials.fault("snakemake: not the answer of one process", "snakemake --cores 2",
                              code=result.returncode, err=result.stderr)
        self.trials.counts["snakemake: workflows"] += 1

    def run(self):
        with self.trials.scratch() as folder:
            self.folder = folder.resolve()
            for scene in (self.array, self.experiment_array, self.snakemake):
                begun = time.monotonic()
                scene()
                print(f"  {time.monotonic() - begun:6.1f} s  {scene.__name__}")
        return self.trials.end()


def main():
    return Jobs(parser(__doc__, 1).parse_args()).run()


if __name__ == "__main__":
    sys.exit(main())
