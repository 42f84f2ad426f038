"""Test programs under mutants: which tests reach which mutant, and which test fails first."""
import collections
import concurrent.futures
import contextlib
import hashlib
import json
import os
import shutil
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

MOST_MUTANTS = 1 << 16  # mutant.hpp
MOST_BYTES = 4 << 30    # of address space
SLACK, FACTOR = 2.0, 5.0  # a test may take FACTOR times its processor time and SLACK seconds more
BATCHES = (0.2, 1, 4, 16, 64, 256, 1024)  # seconds of tests that one process runs

Run = collections.namedtuple("Run", "code seconds out was_stopped")
Test = collections.namedtuple("Test", "program name seconds reached")


def limited(command, seconds, environment):
    """Runs a program with limits on processor time, wall time and memory, in a folder of its own."""
    folder = tempfile.mkdtemp(prefix="waymark-mutation-")
    variables = {**os.environ, "TMPDIR": folder, "TEST_TMPDIR": folder, "LC_ALL": "C.UTF-8", **environment}
    shell = f"ulimit -v {MOST_BYTES >> 10}; ulimit -c 0; ulimit -t {int(seconds) + 1}; exec \"$@\""
    try:
        process = subprocess.Popen(["sh", "-c", shell, "sh", *map(str, command)], cwd=folder, env=variables,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        stopped = threading.Event()

        def stop():
            stopped.set()
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        timer = threading.Timer(4 * seconds + 2, stop)
        timer.start()
        out = process.stdout.read(1 << 20)
        while process.stdout.read(1 << 20):  # a mutant may print without end: the timer ends it
            pass
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.stdout.close()
        process.returncode = os.waitstatus_to_exitcode(status)
        by_limit = process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
        return Run(process.returncode, usage.ru_utime + usage.ru_stime, out.decode(errors="replace"),
                   stopped.is_set() or by_limit)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def tests_of(program):
    """The full names of the tests of a program."""
    out = subprocess.run([program, "--gtest_list_tests"], stdout=subprocess.PIPE, text=True, check=True).stdout
    suite, names = "", []
    for line in out.splitlines():
        name = line.split("#")[0].rstrip()
        if not name.startswith(" "):
            suite = name if name.endswith(".") else suite
        elif "DISABLED_" not in suite + name:
            names.append(suite + name.strip())
    return names


def watch(name, program, test, numbers):
    """One test without a mutant: its time, and the mutants that it reaches."""
    with tempfile.NamedTemporaryFile() as file:
        file.truncate(MOST_MUTANTS)
        run = limited([program, f"--gtest_filter={test}"], 120, {"WAYMARK_MUTANTS_REACHED": file.name})
        reached = Path(file.name).read_bytes()
    if run.code != 0:
        return f"{name}: {test} fails without a mutant (exit code {run.code})\n{run.out[-2000:]}"
    return Test(name, test, run.seconds, frozenset(number for number in numbers if reached[number]))


def watch_all(programs, numbers, jobs, memory):
    """All tests of all programs; those that fail come as text. What is known of a program is read from its file."""
    known = json.loads(memory.read_text()) if memory.exists() else {}
    kept, failing = {}, []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for name, path in programs.items():
            told = repr((numbers, os.environ.get("WAYMARK_SHARED")))
            key = hashlib.sha256(path.read_bytes() + told.encode()).hexdigest()
            if key not in known:
                done = list(pool.map(lambda test: watch(name, path, test, numbers), tests_of(path)))
                failing += [one for one in done if isinstance(one, str)]
                known[key] = [(*one[:3], sorted(one.reached)) for one in done if isinstance(one, Test)]
            kept[name] = key
    if not failing:
        memory.write_text(json.dumps({key: known[key] for key in kept.values()}))
    return [Test(*cells[:3], frozenset(cells[3])) for key in kept.values() for cells in known[key]], failing


class Hunt:
    """Runs mutants against the tests that reach them: first those that killed others of the file, then short ones."""

    def __init__(self, programs, tests, seconds_a_mutant, longest_test):
        self.programs, self.seconds = programs, seconds_a_mutant
        self.kills, self.lock = collections.Counter(), threading.Lock()
        self.reaching = collections.defaultdict(list)
        self.too_long = [test for test in tests if test.seconds > longest_test]
        for test in tests:
            if test.seconds <= longest_test:
                for number in test.reached:
                    self.reaching[number].append(test)

    def order(self, file, number):
        with self.lock:
            return sorted(self.reaching[number],
                          key=lambda t: (t.seconds + 0.002) / (1 + self.kills[file, t.program, t.name]))

    def batches(self, tests):
        """Tests of one program each, together of so many seconds."""
        left, spent = list(tests), 0.0
        for most in BATCHES:
            batch, seconds = collections.defaultdict(list), 0.0
            while left and (seconds + left[0].seconds <= most or not batch):
                if spent + left[0].seconds > self.seconds and spent:
                    left.pop(0)
                    continue
                spent += left[0].seconds
                seconds += left[0].seconds
                batch[left[0].program].append(left.pop(0))
            yield from batch.items()

    def one(self, file, number):
        """killed, survived or not reached; by which test; processor seconds."""
        if number not in self.reaching:
            return "not reached", "", 0.0
        total = 0.0
        for program, tests in self.batches(self.order(file, number)):
            expected = sum(test.seconds for test in tests)
            run = limited([self.programs[program], f"--gtest_filter={':'.join(t.name for t in tests)}",
                           "--gtest_fail_fast", "--gtest_brief=0"], FACTOR * expected + SLACK,
                          {"WAYMARK_MUTANT": str(number)})
            total += run.seconds
            if run.code != 0:
                return "killed", self.killer(run, file, program), total
        return "survived", "", total

    def killer(self, run, file, program):
        started = [line.split("]", 1)[1].strip() for line in run.out.splitlines() if line.startswith("[ RUN ")]
        test = started[-1] if started else "the start of the program"
        for line in run.out.splitlines():
            if line.startswith("[  FAILED  ]") and "(" in line:
                test = line.split("]", 1)[1].split(" (")[0].split(",")[0].strip()
                break
        with self.lock:
            self.kills[file, program, test] += 1
        how = "time" if run.was_stopped else f"signal {-run.code}" if run.code < 0 else f"exit {run.code}"
        return f"{program}: {test} ({how})"

