"""Ctrl-C and SIGTERM at random moments, sent to every subcommand that can be kept busy.

interrupts.py DIRECTORY_OF_PROGRAMS [--trials N] [--each N] [--only NAME] [--most-seconds X] [--seed S]

The signal goes to waymark alone. waymark has to end with exit code 11 (docs/cli.md; the studio with 0) within
--most-seconds; docs/cli.md says half a second, and the slowest ends are printed. No temporary file and no helper may be
left. A file that was there before has its old bytes, or all its new ones.
"""
import collections
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import long_jobs
from trials import Programs, Trials, parser

PROMISED = 0.5  # seconds, of docs/cli.md
OLD = b"what was there before\n"


def catches(pid, number):
    """Has the process a handler for the signal by now? Before, the signal ends it as it ends every program."""
    try:
        with open(f"/proc/{pid}/status") as status:
            caught = re.search(r"^SigCgt:\s*(\w+)", status.read(), re.M)
    except OSError:
        return False
    return caught is not None and int(caught[1], 16) >> (number - 1) & 1 == 1


def group_is_alive(group):
    """Does a process of the group run? One that ended and is not yet waited for does not."""
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, its_group = status.read_text().rpartition(")")[2].split()[:3]
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(its_group) == group and state not in "ZX":
            return True
    return False


def fresh_folder(parent, job):
    folder = parent / "here"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for name in job.outputs:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(OLD)
    return folder


def start(programs, job, folder):
    with open(folder.parent / "out", "wb") as out, open(folder.parent / "err", "wb") as err:
        return programs.start(job.arguments, folder, stdout=out, stderr=err, start_new_session=True)


def undisturbed(programs, job, parent, longest):
    """Seconds, exit code and bytes written of a job that ends; of others the longest time, no code and no bytes."""
    if not job.ends:
        return longest, None, {}
    folder = fresh_folder(parent, job)
    started = time.monotonic()
    process = start(programs, job, folder)
    process.wait(300)
    seconds = time.monotonic() - started
    if process.returncode not in (0, 10):
        raise SystemExit(f"error: {programs.text(job.arguments)} ends with {process.returncode}: " +
                         (parent / "err").read_text(errors="replace"))
    new = {name: (folder / name).read_bytes() for name in job.outputs if (folder / name).exists()}
    return min(seconds, longest), process.returncode, new


def leftovers(job, folder):
    for file in sorted(folder.rglob("*")):
        name = str(file.relative_to(folder))
        if file.is_dir() or name in job.outputs:
            continue
        inside = any(name.startswith(place + "/") for place in job.folders)
        if not inside or file.name.startswith(".waymark."):
            yield name


class Interrupts:
    def __init__(self, options):
        self.options, self.trials, self.programs = options, Trials("interrupts", options), Programs(options)
        self.times, self.found = {}, collections.Counter()

    def trial(self, job, parent, number, seconds, ended, new):
        random = self.trials.random(f"{job.name} {number}")
        kind = random.choice([signal.SIGINT, signal.SIGTERM])
        moment = random.uniform(0, seconds)
        folder = fresh_folder(parent, job)
        process = start(self.programs, job, folder)
        try:
            process.wait(moment)
            self.trials.counts[f"{job.name}: ended before the signal"] += 1
            return
        except subprocess.TimeoutExpired:
            pass
        caught = catches(process.pid, kind)
        sent = time.monotonic()
        process.send_signal(kind)
        try:
            process.wait(self.options.most_seconds)
        except subprocess.TimeoutExpired:
            pass
        took = time.monotonic() - sent
        why = self.wrong(job, folder, process, ended, new, kind, caught)
        self.trials.counts[f"{job.name}: exit code {process.returncode}"] += 1
        if process.returncode is not None and process.returncode > 0:
            self.times.setdefault(job.name, []).append(took)
        if group_is_alive(process.pid):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        for fault in why:
            self.found[job.name, fault] += 1
            if self.found[job.name, fault] > 1:  # once is enough to read
                self.trials.counts[f"fault: {job.name}: {fault}"] = self.found[job.name, fault]
                continue
            self.trials.fault(f"{job.name}, {kind.name} after {moment:.3f} s of {seconds:.2f} s: {fault}",
                              self.programs.text(job.arguments), trial=number, code=process.returncode,
                              seconds=f"{took:.2f}", err=(parent / "err").read_bytes()[-500:].decode(errors="replace"))

    def wrong(self, job, folder, process, ended, new, kind, caught):
        code, why = process.poll(), []
        if code is None:
            return [f"no end within {self.options.most_seconds} s"]
        message = (folder.parent / "err").read_text(errors="replace")
        if code == -kind and not caught:
            self.trials.counts["the signal came before the handler"] += 1
        elif code < 0:
            why.append(f"ended by signal {-code}")
        elif code not in (*job.codes, ended):
            why.append(f"exit code {code}")
        if code == 11 and "interrupted" not in message:
            why.append("exit code 11 without the word interrupted")
        if "bug in waymark" in message:
            why.append("the message speaks of a bug")
        time.sleep(0.05)
        if group_is_alive(process.pid):
            why.append("a helper still runs")
        why += [f"{name} is left behind" for name in leftovers(job, folder)]
        for name in job.outputs:
            now = (folder / name).read_bytes() if (folder / name).exists() else None
            if now != OLD and (now is None or now != new.get(name)):
                why.append(f"{name} is neither old nor whole: {'gone' if now is None else f'{len(now)} bytes'}")
        return why

    def run(self):
        with self.trials.scratch() as parent:
            long_jobs.make_inputs(self.programs, parent)
            chosen = [job for job in long_jobs.jobs(parent, self.programs) if self.options.only in job.name]
            measured = {}
            for number in range(self.options.each * len(chosen) if self.options.each else self.options.trials):
                job = chosen[number % len(chosen)]
                if job.name not in measured:
                    measured[job.name] = undisturbed(self.programs, job, parent, self.options.longest)
                self.trial(job, parent, number, *measured[job.name])
        for name, times in sorted(self.times.items(), key=lambda row: -max(row[1])):
            late = sum(seconds > PROMISED for seconds in times)
            print(f"  {max(times):6.2f} s at most, {sum(times) / len(times):.2f} s in the mean, "
                  f"{late} of {len(times)} beyond {PROMISED} s: {name}")
        print("no input is long enough for:", ", ".join(long_jobs.BRIEF))
        return self.trials.end()


def main():
    options = parser(__doc__, 100)
    options.add_argument("--each", type=int, default=0, metavar="N", help="N signals to each job, and not --trials")
    options.add_argument("--only", default="", metavar="NAME", help="only jobs whose name contains NAME")
    options.add_argument("--longest", type=float, default=1.5, metavar="X", help="seconds until the last signal [1.5]")
    options.add_argument("--most-seconds", type=float, default=5, metavar="X", help="bound between signal and end [5]")
    return Interrupts(options.parse_args()).run()


if __name__ == "__main__":
    sys.exit(main())
