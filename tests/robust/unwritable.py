"""Places that take no file: a full disk, a read-only one, a full device, a standard output that is closed or full."""
import os
import re
import stat
import subprocess

from trials import BAD_INPUT, DONE, NO
from writers import is_whole

OLD = b"what was there before\n"
PAGES = 16  # a disk of 64 KiB


def put_old_files(writer, place):
    for name in writer.outputs:
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).write_bytes(OLD)


def files_in(place):
    return {str(file.relative_to(place)): file for file in place.rglob("*") if not file.is_dir()}


def unlike_old_or_new(writer, place, new, code):
    """What is wrong with the files of a place after a write that may have failed."""
    for name, file in files_in(place).items():
        if name == "filler":
            continue
        if name not in writer.outputs:
            yield f"{name} is left behind"
        elif file.read_bytes() != OLD and not is_whole(writer, name, file.read_bytes(), new):
            yield f"{name} is neither old nor whole: {file.stat().st_size} bytes"
        elif code == DONE and file.read_bytes() == OLD:
            yield f"{name} is old, and the exit code is 0"
    for name in writer.outputs:
        if not (place / name).exists():
            yield f"{name} is gone"


def wrong_with_refusal(result, named):
    if result.code != BAD_INPUT:
        return f"exit code {result.code}"
    if not re.search(r"^error: \S", result.err, re.M):
        return "no message"
    if named not in result.err:
        return f"the message does not name {named}"
    return None


def mounted(place, size):
    place.mkdir(exist_ok=True)
    if os.geteuid() != 0:
        return "only root mounts a disk of its own"
    done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(place)], capture_output=True,
                          check=False)
    return done.stderr.decode().strip() if done.returncode else None


def unmount(place):
    subprocess.run(["umount", str(place)], check=False)


def full_disk(trials, programs, folder, writer, new, random):
    """Some pages are free: the file is whole and new, or old and refused."""
    place = folder / "disk"
    why = mounted(place, "64k")
    if why:
        place.rmdir()
        return why
    try:
        put_old_files(writer, place)
        with open(place / "filler", "wb", buffering=0) as filler:
            try:
                for _ in range(PAGES):
                    filler.write(bytes(4096))
            except OSError:
                pass
            free = random.choice([0, 0, 1, 2, 5])
            filler.truncate(max(0, filler.tell() - 4096 * free))
        result = programs.run(writer.at(place), folder)
        faults = list(unlike_old_or_new(writer, place, new, result.code))
        if result.code not in (DONE, NO):
            faults.append(wrong_with_refusal(result, "old"))
        elif free == 0:
            faults.append("the disk is full, and the exit code is 0")
        trials.counts[f"full disk: exit code {result.code}"] += 1
        for fault in filter(None, faults):
            trials.fault(f"full disk, {writer.name}, {free} pages free: {fault}", programs.text(writer.at(place)),
                         code=result.code, err=result.err)
    finally:
        unmount(place)
        place.rmdir()
    return None


def read_only_folder(trials, programs, folder, writer, new, _random):
    place = folder / "disk"
    why = mounted(place, "16m")
    root = why is None
    try:
        put_old_files(writer, place)
        if root:
            subprocess.run(["mount", "-o", "remount,ro", str(place)], check=True)
        else:
            for part in [place, *place.rglob("*")]:
                part.chmod(0o555 if part.is_dir() else 0o444)
        result = programs.run(writer.at(place), folder)
        trials.counts[f"read-only folder: exit code {result.code}"] += 1
        for fault in [wrong_with_refusal(result, "old"), *unlike_old_or_new(writer, place, new, result.code)]:
            if fault:
                trials.fault(f"read-only folder, {writer.name}: {fault}", programs.text(writer.at(place)),
                             code=result.code, err=result.err)
    finally:
        if root:
            unmount(place)
        for part in [place, *place.rglob("*")]:
            part.chmod(0o755 if part.is_dir() else 0o644)
        subprocess.run(["rm", "-r", str(place)], check=True)
    return None


def full_device(trials, programs, folder, writer, _new, _random):
    """Root gets a device of its own, lest the one of the machine be replaced."""
    place = folder / "devices"
    place.mkdir()
    try:
        for name in writer.outputs:
            (place / name).parent.mkdir(exist_ok=True)
            if os.geteuid() == 0:
                os.mknod(place / name, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
            else:
                (place / name).symlink_to("/dev/full")
        try:
            with open(place / writer.outputs[0], "wb", buffering=0) as device:
                device.write(b"x")
        except OSError as error:
            if error.errno != 28:  # no space left on device: as it has to be
                return f"no device here: {error}"
        result = programs.run(writer.at(place), folder)
        trials.counts[f"/dev/full: exit code {result.code}"] += 1
        fault = wrong_with_refusal(result, "old")
        if not all((place / name).is_char_device() for name in writer.outputs):
            fault = "the device was replaced by a file"
        if fault:
            trials.fault(f"/dev/full, {writer.name}: {fault}", programs.text(writer.at(place)), code=result.code,
                         err=result.err)
    finally:
        subprocess.run(["rm", "-r", str(place)], check=True)
    return None


def closed_output(trials, programs, folder, writer, new, random):
    """What is printed goes nowhere: files are whole all the same, and a full device is no success."""
    place = folder / "place"
    place.mkdir()
    put_old_files(writer, place)
    kind = random.choice(["closed", "/dev/full", "a pipe that nobody reads"])
    redirect = {"closed": ">&-", "/dev/full": ">/dev/full", "a pipe that nobody reads": ""}[kind]
    reader, output = os.pipe()
    os.close(reader)
    try:
        result = subprocess.run(["sh", "-c", f'exec "$@" {redirect}', "sh", *programs.command(writer.at(place))],
                                cwd=folder, env=programs.environment, stdin=subprocess.DEVNULL, stdout=output,
                                stderr=subprocess.PIPE, timeout=60, check=False, restore_signals=True)
        os.close(output)
        faults = list(unlike_old_or_new(writer, place, new, NO))
        expected = {"closed": (DONE, NO, BAD_INPUT), "/dev/full": (BAD_INPUT, DONE),
                    "a pipe that nobody reads": (-13, BAD_INPUT, DONE)}[kind]
        if result.returncode not in expected:
            faults.append(f"exit code {result.returncode}")
        trials.counts[f"standard output {kind}: exit code {result.returncode}"] += 1
        for fault in faults:
            trials.fault(f"standard output {kind}, {writer.name}: {fault}",
                         programs.text(writer.at(place)) + " " + redirect, code=result.returncode,
                         err=result.stderr.decode(errors="replace"))
    finally:
        subprocess.run(["rm", "-r", str(place)], check=True)
    return None


SCENES = (full_disk, read_only_folder, full_device, closed_output)


def printed_into_full_places(trials, programs, folder):
    """What is printed is no answer where nobody gets it: exit code 21 and a message."""
    for arguments in (["translate", "F a"], ["plan", "F sofa", "--json"], ["ground", "walk to the chair"],
                      ["patterns", "--list"], ["map", "grid"], ["version"], ["--version"], ["--help"], ["help", "maps"],
                      ["random", "--count", "3"], ["translate", "-F", "formulas"], ["explain", "F a"],
                      ["draw", "map", "--svg", "-"], ["compose", "F easel", "--format", "prism"],
                      ["corpus", "little"], ["import", "sail", "little"], ["generate", "map", "--kind", "maze"],
                      ["check", "F a", "--word", "{a}"], ["compare-formulas", "F a", "F a"]):
        with open("/dev/full", "wb") as full:
            result = programs.run(arguments, folder, stdout=full)
        trials.counts[f"printed into /dev/full: exit code {result.code}"] += 1
        if result.code != BAD_INPUT or "error: " not in result.err:
            trials.fault(f"printed into /dev/full: exit code {result.code}", programs.text(arguments) + " > /dev/full",
                         err=result.err)
