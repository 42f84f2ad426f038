"""Damaged files: every model file, and map, corpus, case and checkpoint, altered at random and read by its commands.

damaged.py DIRECTORY_OF_PROGRAMS [--trials N] [--seed S] [--keep]

A damaged model is refused: exit code 21, a message that names the file and the reason, no answer, and the file stays as
it was. Damage under a checksum that fits, and damage to text, may be read; then the command ends with a documented
exit code, and what is read is answered without NaN. A damaged score of an experiment is made again.
"""
import json
import re
import sys

import damage
from trials import BAD_INPUT, DONE, GAVE_UP, NO, NOT_UNDERSTOOD, USAGE, Programs, Trials, parser

SLOW = 10  # seconds; a start takes 12 ms
TEXT = "walk to the chair, then turn left"
TOWN = {"landmarks": [{"prop": "inn", "name": "The Inn"}, {"prop": "library", "name": "Quince Library"}]}
SMALL = ["--word-size", "4", "--width", "4", "--query", "4", "--symbol-size", "4"]
CASE = ["generate", "map", "--kind", "rooms", "--width", "6", "--height", "6", "--landmarks", "3", "--tasks"]


class Target:
    """A file and the commands that read it; FILE stands for its path, FOLDER for its folder."""

    def __init__(self, name, path, commands, kind, share):
        self.name, self.path, self.commands, self.kind, self.share = name, path, commands, kind, share
        self.whole = path.read_bytes()


def commands_of_model(folder, reads_commands):
    commands = [["ground", TEXT, "--map", "grid", "--json", "--model-file", "FILE"],
                ["ground", TEXT, "--model-file", "FILE"],
                ["ground", "-F", folder / "texts", "--json", "--model-file", "FILE"],
                ["run", TEXT, "--map", "grid", "--start", "1,9,0", "--json", "--model-file", "FILE"],
                ["run", TEXT, "--model-file", "FILE", "--svg", folder / "route.svg"],
                ["evaluate", "--pairs", folder / "corpus/pairs.tsv", "--json", "--model-file", "FILE"]]
    taught = ["train", "--base", "FILE", "--commands", folder / "commands.jsonl", "--own-commands", "0", "--out",
              folder / "out.waymark"]
    if reads_commands:
        commands.append(["ground", "go to the inn", "--landmarks", folder / "town.json", "--json",
                         "--model-file", "FILE"])
        commands.append(["evaluate", "--test-commands", folder / "commands.jsonl", "--domains",
                         folder / "domains.json", "--json", "--model-file", "FILE"])
    return 5 * commands + [taught]  # training reads its word vectors first, which takes a hundred times as long


def make_inputs(programs, folder, data):
    programs.prepare(["generate", "corpus", "--out", "corpus", "--paragraphs", "4", "--seed", "3"], folder)
    lines = (folder / "corpus/pairs.tsv").read_text().splitlines()[:6]
    (folder / "texts").write_text("".join(line.split("\t")[0] + "\n" for line in lines))
    (folder / "corpus/pairs.tsv").write_text("\n".join(lines) + "\n")
    (folder / "town.json").write_text(json.dumps(TOWN))
    (folder / "domains.json").write_text(json.dumps({"yard": {"propositions": {"gate": "", "red_shed": ""}}}))
    (folder / "commands.jsonl").write_text("".join(
        json.dumps({"id": str(i), "domain": "yard", "text": text, "formula": formula,
                    "propositions": ["gate", "red_shed"]}) + "\n"
        for i, (text, formula) in enumerate([("go to the gate", "F gate"), ("avoid the red shed", "G !red_shed")])))
    programs.prepare(["train", "--corpus", "corpus", "--epochs", "1", "--out", "linear.waymark"], folder)
    programs.prepare(["train", "--corpus", "corpus", "--epochs", "1", "--model", "encoder-decoder", *SMALL,
                      "--out", "network.waymark"], folder)
    (folder / "grid.json").write_bytes((data / "maps/grid.json").read_bytes())
    (folder / "case.json").write_text(programs.prepare(CASE, folder).out)
    (folder / "shipped.waymark").write_bytes((data / "models/encoder-decoder.waymark").read_bytes())
    words = folder / "data/words"
    words.mkdir(parents=True)
    for name in ("maps", "models", "language"):
        (folder / "data" / name).symlink_to(data / name)
    for file in (data / "words").iterdir():
        (words / file.name).write_bytes(file.read_bytes())


def targets(folder):
    instructions = ["corpus", "FOLDER", "--json"]
    teach = ["train", "--base", folder / "network.waymark", "--commands", folder / "commands.jsonl", "--own-commands",
             "0", "--networks", "1", "--command-epochs", "1", "--data", folder / "data", "--out",
             folder / "out.waymark"]
    plan = ["plan", "F chair", "--map", "FILE", "--json"]
    return [
        Target("shipped model", folder / "shipped.waymark", commands_of_model(folder, True), "model", 15),
        Target("linear model", folder / "linear.waymark", commands_of_model(folder, False), "model", 20),
        Target("network", folder / "network.waymark", commands_of_model(folder, False), "model", 35),
        Target("network, resealed", folder / "network.waymark", commands_of_model(folder, False)[:-1], "resealed", 12),
        Target("word vectors", folder / "data/words/words.waymark", [teach], "model", 1),
        Target("map", folder / "grid.json", [plan, ["map", "FILE"], ["run", TEXT, "--map", "FILE", "--json"]],
               "text", 6),
        Target("case", folder / "case.json", [["plan", "--case", "FILE", "--json", "--limit-seconds", "5"],
                                              ["compose", "--case", "FILE"]], "text", 4),
        Target("corpus", folder / "corpus/instructions.jsonl",
               [instructions, ["import", "sail", "FOLDER", "--json"]], "text", 5),
        Target("pairs", folder / "corpus/pairs.tsv",
               [["evaluate", "--pairs", "FILE", "--json", "--model-file", folder / "network.waymark"]], "text", 2)]


def wrong_with(target, command, result):
    """What is wrong with the end of a command that read a damaged file; None: nothing."""
    if result.code is None:
        return f"no end after {SLOW} s"
    if result.code < 0:
        return f"ended by signal {-result.code}"
    allowed = {BAD_INPUT} if target.kind == "model" else {DONE, NO, NOT_UNDERSTOOD, BAD_INPUT}
    if result.code in (GAVE_UP, USAGE) and "--case" in command:  # a larger case, or one without tasks
        return None
    if result.code not in allowed:
        return f"exit code {result.code}"
    if result.code == BAD_INPUT:
        if not re.match(r"error: \S", result.err):
            return "no message"
        names = target.path.name in result.err or (
            target.kind == "text" and re.search(r"^(  line \d+|error: task )", result.err, re.M))
        meant = "FILE" in map(str, command) and target.kind != "resealed"  # which may be a whole model, of other maps
        if meant and not names:
            return "the message does not name the file"
        answers = [line for line in result.out.splitlines() if '"status":"error"' not in line]
        if answers and target.kind != "text":
            return "an answer is printed all the same"
        if "json.exception" in result.err:
            return "the message shows the exception of a library"
    return wrong_with_json(result.out) if "--json" in command else None


def wrong_with_json(text):
    for line in text.splitlines():
        try:
            json.loads(line, parse_constant=float)
        except ValueError as error:  # NaN and inf among them, as waymark would print them
            return f"no JSON is printed: {error}"
    return "no UTF-8 is printed" if "\N{REPLACEMENT CHARACTER}" in text else None


def one(trials, programs, folder, target, trial):
    random = trials.random(trial)
    if target.kind == "resealed":
        way, bytes_now = damage.resealed(random, target.whole)
    else:
        ways = damage.OF_MODELS if target.kind == "model" else damage.ANY
        way, bytes_now = damage.damaged(random, target.whole, ways)
    template = random.choice(target.commands)
    command = [str(part).replace("FILE", str(target.path)).replace("FOLDER", str(target.path.parent))
               for part in template]
    target.path.write_bytes(bytes_now)
    before = target.path.stat()
    result = programs.run(command, folder, seconds=SLOW)
    after = target.path.stat()
    why = wrong_with(target, template, result)
    same = (before.st_ino, before.st_mtime_ns, before.st_size) == (after.st_ino, after.st_mtime_ns, after.st_size)
    if not same or target.path.read_bytes() != bytes_now:
        why = "the damaged file was changed"
    if target.kind == "model" and (folder / "out.waymark").exists():
        why = "a model is written all the same"
    for leftover in folder.glob(".waymark.*"):
        why = f"{leftover.name} is left behind"
    trials.counts[f"{target.name}, {way}: exit code {result.code}"] += 1
    trials.seconds[target.name] += result.seconds
    trials.slowest = max(getattr(trials, "slowest", (0, "")), (result.seconds, f"{target.name}, {way}"))
    if why:
        trials.fault(f"{target.name}, {way}: {why}", programs.text(command), trial=trial, code=result.code,
                     out=result.out, err=result.err, bytes=damage.difference(target.whole, bytes_now))
    (folder / "out.waymark").unlink(missing_ok=True)


def damaged_checkpoints(trials, programs, folder, count):
    """A damaged score is made again, a damaged model is refused; the table has the same bytes as before."""
    def experiment(directory):
        return ["experiment", "compare-systems", "--corpus", "corpus", "--checkpoints", directory, "--ensemble", "1",
                "--epochs", "1", "--convention", "relative", "--json"]
    kept = folder / "checkpoints"
    table = programs.prepare(experiment(kept), folder).out
    files = {file.name: file.read_bytes() for file in sorted(kept.iterdir())}
    for trial in range(count):
        random = trials.random(f"checkpoint {trial}")
        name = random.choice(list(files))
        way, bytes_now = damage.damaged(random, files[name], damage.ANY)
        (kept / name).write_bytes(bytes_now)
        if not name.endswith((".scores", ".txt")):  # models are read where scores are missing
            for score in kept.glob("*.scores"):
                score.unlink()
        result = programs.run(experiment(kept), folder, seconds=120)
        model = files[name].startswith(b"waymark\n")
        trials.counts[f"checkpoint {'model' if model else 'text'}, {way}: exit code {result.code}"] += 1
        good = result.code == DONE and result.out == table
        refused = result.code == BAD_INPUT and not result.out and \
            (name in result.err or name == "settings.txt" and "settings" in result.err)
        if not good and not refused:
            trials.fault(f"checkpoint {name}, {way}: neither refused by name nor made again", f"cd {folder}; " +
                         programs.text(experiment(kept)), trial=trial, code=result.code, out=result.out,
                         err=result.err, bytes=damage.difference(files[name], bytes_now))
        for file, contents in files.items():
            (kept / file).write_bytes(contents)


def main():
    options = parser(__doc__, 10_000)
    options.add_argument("--checkpoints", type=int, default=40, metavar="N", help="trials with an experiment's files")
    options.add_argument("--only", default="", metavar="NAME", help="only targets whose name contains NAME")
    options = options.parse_args()
    programs, trials = Programs(options), Trials("damaged", options)
    with trials.scratch() as folder:
        make_inputs(programs, folder, options.data.resolve())
        chosen = [target for target in targets(folder) if options.only in target.name]
        shares = [target.share for target in chosen]
        for trial in range(options.trials if chosen else 0):
            target = trials.random(f"target {trial}").choices(chosen, shares)[0]
            one(trials, programs, folder, target, trial)
            target.path.write_bytes(target.whole)
        if programs.has("waymark-lab"):
            damaged_checkpoints(trials, programs, folder, options.checkpoints)
    for name, seconds in trials.seconds.most_common():
        print(f"  {seconds:7.1f}  s of {name}")
    print(f"slowest: {trials.slowest[0]:.2f} s, {trials.slowest[1]}")
    return trials.end()


if __name__ == "__main__":
    sys.exit(main())
