"""The studio under 200 clients at a time: good, slow, huge, malformed and foreign requests for a while.

clients.py DIRECTORY_OF_PROGRAMS [--seconds S] [--clients N] [--drip N] [--without KIND,…] [--seed S]

The studio must not crash; every good request gets the answer that it has when nobody else asks (503 "busy" is asked
again); what is malformed or foreign is refused; afterwards no connection is left and the resident size is back within
10 % of that after the warm-up. --trials is not used; --drip N clients send a byte a second, as slowloris does.
"""
import asyncio
import collections
import json
import random as random_numbers
import signal
import subprocess
import sys
import time
from pathlib import Path

import studio_requests
from trials import Programs, Trials, parser

MOST_FAULTS = 10  # that are printed; all are counted
GROWTH = 1.10
SHARES = {"good": 60, "malformed": 18, "foreign": 10, "slow": 10, "huge": 2}  # of a hundred clients
CUT_OFF = 64 << 20  # bytes of a huge body: by then the studio has to have had enough
HUGE = 1 << 30


def resident_mib(pid, key="VmRSS"):
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith(key + ":"):
            return int(line.split()[1]) / 1024
    return 0.0


def open_files(pid):
    return len(list(Path(f"/proc/{pid}/fd").iterdir()))


def parsed(data):
    """Status and body of an answer; None where there is none."""
    lines, _, body = data.partition(b"\r\n\r\n")
    words = lines.split(b"\r\n")[0].split(b" ")
    if not words[0].startswith(b"HTTP/") or len(words) < 2 or not words[1].isdigit():
        return None
    return int(words[1]), body


class Clients:
    def __init__(self, options):
        self.options, self.trials, self.programs = options, Trials("clients", options), Programs(options)
        self.waits, self.expected = collections.defaultdict(list), {}
        self.port, self.until, self.most_taken, self.peak = 0, 0.0, 0, 0.0
        self.files_at_rest = 0

    @property
    def host(self):
        return f"127.0.0.1:{self.port}"

    async def exchange(self, data, seconds):
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port)
        try:
            async def both():
                writer.write(data)
                try:
                    await writer.drain()
                except ConnectionError:
                    pass  # the answer may be there all the same
                got = b""
                try:
                    while part := await reader.read(1 << 16):
                        got += part
                except ConnectionError:
                    pass
                return got
            return parsed(await asyncio.wait_for(both(), seconds))
        finally:
            writer.transport.abort()

    async def good(self, random):
        method, path, body = case = random.choice(studio_requests.GOOD)
        key, started = json.dumps(case), time.monotonic()
        data = studio_requests.request(method, path, self.host, body)
        answer = None
        while time.monotonic() - started < self.options.patience:
            try:
                answer = await self.exchange(data, self.options.patience)
            except asyncio.TimeoutError:
                answer = None
                break
            if answer is None or answer[0] != 503:
                break
            self.trials.counts["good: busy, asked again"] += 1
            await asyncio.sleep(random.uniform(0.01, 0.1))
        self.waits[path].append(time.monotonic() - started)
        now = studio_requests.comparable(answer) if answer else None
        if key not in self.expected:
            self.expected[key] = now
        right = now is not None and now == self.expected[key]
        self.trials.counts[f"good: {'right' if right else 'no answer' if now is None else 'another answer'}"] += 1
        if not right:
            self.fault(f"a good request has {'no' if now is None else 'another'} answer", data, answer,
                       waited=f"{time.monotonic() - started:.1f} s")

    async def refused(self, name, data, allowed):
        try:
            answer = await self.exchange(data, 30)
        except asyncio.TimeoutError:
            self.trials.counts[f"{name}: no answer within 30 s"] += 1
            return
        self.trials.counts[f"{name}: {answer[0] if answer else 'connection closed'}"] += 1
        if answer and answer[0] != 503 and not allowed(answer[0]) or answer and b"root:" in answer[1]:
            self.fault(f"{name}: status {answer[0]}", data, answer)

    async def malformed(self, random):
        await self.refused("malformed", studio_requests.malformed(random, self.host), lambda status: status < 500)

    async def foreign(self, random):
        data, statuses = studio_requests.foreign(random, self.host)
        await self.refused("foreign", data, lambda status: status in statuses)

    async def slow(self, random):
        """Half a request, and silence: cut off, or given up after a while."""
        data = studio_requests.request("POST", "/api/plan", self.host, {"formula": "F sofa"})
        started = time.monotonic()
        try:
            await self.exchange(data[:random.randrange(1, len(data) - 1)], 30)
            self.trials.counts["slow: cut off"] += 1
        except asyncio.TimeoutError:
            self.trials.counts["slow: open for 30 s"] += 1
        self.waits["(cut off)"].append(time.monotonic() - started)

    async def drip(self, _random):
        """A byte a second, as long as the trial lasts."""
        _, writer = await asyncio.open_connection("127.0.0.1", self.port)
        data = studio_requests.head("GET", "/", self.host, [f"X-{i}: 1" for i in range(10_000)])
        sent = 0
        try:
            while sent < len(data) and time.monotonic() < self.until:
                writer.write(data[sent:sent + 1])
                await writer.drain()
                sent += 1
                await asyncio.sleep(1)
        finally:
            self.trials.counts[f"drip: {'cut off' if time.monotonic() < self.until else 'open until the end'}"] += 1
            writer.transport.abort()

    async def huge(self, random):
        """A body of 1 GB, with its length or in chunks, sent until nobody takes it."""
        chunked = random.random() < 0.5
        fields = ["Content-Type: application/json",
                  "Transfer-Encoding: chunked" if chunked else f"Content-Length: {HUGE}"]
        reader, writer = await asyncio.open_connection("127.0.0.1", self.port)
        block, taken = b" " * (1 << 16), 0
        try:
            writer.write(studio_requests.head("POST", "/api/maps", self.host, fields))
            while taken < CUT_OFF and not reader.at_eof() and not writer.transport.is_closing():
                writer.write(b"10000\r\n" + block + b"\r\n" if chunked else block)
                await asyncio.wait_for(writer.drain(), 30)
                taken += len(block)
        except ConnectionError:
            pass
        except asyncio.TimeoutError:
            self.trials.counts["huge: nothing taken for 30 s"] += 1
        finally:
            writer.transport.abort()
        name = "in chunks" if chunked else "with its length"
        self.most_taken = max(self.most_taken, taken)
        if taken >= CUT_OFF:
            self.trials.counts[f"huge body {name}: {CUT_OFF >> 20} MiB taken, not cut off"] += 1
        else:
            self.trials.counts[f"huge body {name}: cut off"] += 1

    def fault(self, why, data, answer, **facts):
        if self.trials.faults >= MOST_FAULTS:
            return
        command = self.programs.text(["serve", "--port", "0"]) + "  # then the request"
        self.trials.fault(why, command, request=data[:1500], bytes=len(data), answer=answer, **facts)

    async def client(self, kind, number):
        random = random_numbers.Random(f"{self.options.seed}:{kind}:{number}:{self.until > 0}")
        while time.monotonic() < self.until:
            try:
                await getattr(self, kind)(random)
            except OSError as error:
                self.trials.counts[f"{kind}: {type(error).__name__}"] += 1
                if kind == "good":
                    self.trials.fault(f"a good client: {error!r}", self.programs.text(["serve"]))
                await asyncio.sleep(0.2)

    async def watch(self, process):
        while time.monotonic() < self.until and process.poll() is None:
            self.peak = max(self.peak, resident_mib(process.pid))
            await asyncio.sleep(0.2)

    async def crowd(self, process, seconds, drip, left_out=()):
        self.until = time.monotonic() + seconds
        shares = {kind: share for kind, share in SHARES.items() if kind not in left_out}
        kinds = [kind for kind, share in shares.items() for _ in range(max(1, share * self.options.clients // 100))]
        kinds += ["drip"] * drip
        await asyncio.gather(self.watch(process), *(self.client(kind, i) for i, kind in enumerate(kinds)))

    async def settle(self, process):
        """Resident size and open files when all connections are closed, or have had the time."""
        end, files = time.monotonic() + 8, open_files(process.pid)
        while time.monotonic() < end:
            await asyncio.sleep(0.5)
            files, before = open_files(process.pid), files
            if files == before == self.files_at_rest:
                break
        return resident_mib(process.pid), open_files(process.pid)

    async def session(self, process):
        for case in studio_requests.GOOD:  # what each answer is when nobody else asks
            method, path, body = case
            answer = await self.exchange(studio_requests.request(method, path, self.host, body), self.options.patience)
            self.expected[json.dumps(case)] = studio_requests.comparable(answer) if answer else None
            if answer is None or answer[0] >= 500:
                raise SystemExit(f"error: {method} {path} is not answered: {answer}")
        self.files_at_rest = open_files(process.pid)
        await self.crowd(process, max(2, self.options.seconds / 4), 0, ("slow", "huge", *self.options.without))
        warm, files = await self.settle(process)
        self.waits.clear()
        self.trials.counts.clear()
        self.peak = 0.0
        await self.crowd(process, self.options.seconds, self.options.drip, self.options.without)
        if process.poll() is not None:
            return
        now, files_now = await self.settle(process)
        print(f"resident: {warm:.1f} MiB after the warm-up, {self.peak:.1f} MiB at most, {now:.1f} MiB afterwards")
        print(f"open files: {files} after the warm-up, {files_now} afterwards; "
              f"most bytes taken of a huge body: {self.most_taken}")
        if now > GROWTH * warm:
            self.trials.fault(f"the resident size grew from {warm:.1f} to {now:.1f} MiB", self.programs.text(["serve"]))
        if self.peak > warm + self.options.most_mib:
            self.trials.fault(f"the resident size was {self.peak:.1f} MiB, {warm:.1f} MiB after the warm-up",
                              self.programs.text(["serve"]))
        if files_now > files:
            self.trials.fault(f"{files_now - files} connections are left", self.programs.text(["serve"]))

    def report(self):
        for path, waits in sorted(self.waits.items(), key=lambda row: -len(row[1])):
            waits.sort()
            print(f"  {len(waits):6} {path}: p50 {1000 * waits[len(waits) // 2]:.0f} ms, "
                  f"p99 {1000 * waits[len(waits) * 99 // 100]:.0f} ms, most {1000 * waits[-1]:.0f} ms")

    def run(self):
        with self.trials.scratch() as folder, open(folder / "err", "wb") as err:
            process = self.programs.start(["serve", "--port", "0"], folder, stdout=subprocess.PIPE, stderr=err)
            try:
                self.port = int(process.stdout.readline().decode().split(":")[-1].strip().strip("/"))
                asyncio.run(self.session(process))
                self.report()
                if process.poll() is not None:
                    self.trials.fault(f"the studio ended by itself with {process.returncode}",
                                      self.programs.text(["serve"]), err=(folder / "err").read_text())
                else:
                    process.send_signal(signal.SIGINT)
                    if process.wait(10) != 0:
                        self.trials.fault(f"Ctrl-C: exit code {process.returncode}", self.programs.text(["serve"]))
            finally:
                process.kill()
                process.wait()
                process.stdout.close()
        return self.trials.end()


def main():
    options = parser(__doc__, 0)
    options.add_argument("--seconds", type=float, default=60, metavar="S", help="of the trial [60]")
    options.add_argument("--clients", type=int, default=200, metavar="N", help="at a time [200]")
    options.add_argument("--drip", type=int, default=0, metavar="N", help="clients that send a byte a second [0]")
    options.add_argument("--patience", type=float, default=60, metavar="X", help="of a good client, in seconds [60]")
    options.add_argument("--without", type=lambda names: names.split(","), default=[], metavar="KIND,…",
                         help=f"leave out kinds of clients: {', '.join(SHARES)}")
    options.add_argument("--most-mib", type=float, default=64, metavar="M", help="growth under way [64]")
    options = options.parse_args()
    if not (options.programs / "waymark-serve").exists():
        print("SKIPPED: waymark-serve was not built (libcpp-httplib-dev)")
        return 77
    return Clients(options).run()


if __name__ == "__main__":
    sys.exit(main())
