"""Whole processes under a limit, with the processor seconds that they and their children took in user mode."""
import math
import os
import resource
import signal
import subprocess


class Answer:
    def __init__(self, status, output, errors, seconds):
        self.status, self.output, self.errors, self.seconds = status, output, errors, seconds  # status None: cut off


def run(command, seconds, text="", most_bytes=4 << 30):
    """Processor seconds are limited: a loaded machine answers as much as an idle one. Java needs most_bytes 0."""
    limited = ["prlimit", f"--cpu={max(1, math.ceil(seconds))}", f"--as={most_bytes or 'unlimited'}", "--", *command]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    with subprocess.Popen(limited, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as process:
        try:
            output, errors = process.communicate(text, timeout=4 * seconds + 2)
            status = process.returncode
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, errors = process.communicate()
            status = None
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        status = None
    return Answer(status, output, errors, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
