"""Work that takes a while: for each subcommand of waymark an input that keeps it busy, and the files that it writes."""
import json
import random as random_numbers
from dataclasses import dataclass, field

LANDMARKS = ("chair sofa easel lamp hatrack barstool blue brick concrete flower grass gravel wood yellow").split()
BRIEF = ["patterns", "map", "help", "version"]  # no input keeps these busy for 0.2 s


def remembering(pairs):
    """A formula whose minimal DFA remembers which propositions held in the last steps: hours of work."""
    return " & ".join(f"F({p} & X X X {q} & F({q} & G({p} -> X X {q})))" for p, q in pairs)


HARD = remembering((f"p{i}", f"q{i}") for i in range(24))
HARD_ON_MAP = remembering(zip(LANDMARKS, LANDMARKS[1:]))
START = ["--start", "1,9,0"]
TASK = "F(easel & X F(sofa & X F hatrack))"


@dataclass
class Job:
    """A command in a folder of its own. `outputs` are files that exist before; `folders` may get further files."""
    name: str
    arguments: list
    outputs: list = field(default_factory=list)
    folders: list = field(default_factory=list)
    codes: tuple = (11,)  # of the end by a signal
    ends: bool = False  # within seconds, if nobody disturbs it


def make_inputs(programs, folder):
    """Writes what the jobs read into `folder`."""
    def kept(name, arguments):
        (folder / name).write_text(programs.prepare(arguments, folder).out)

    kept("formulas", ["random", "--props", "6", "--size", "40..60", "--count", "400", "--seed", "5"])
    kept("small", ["random", "--props", "5", "--size", "8..12", "--count", "1500", "--seed", "5"])
    kept("automata.hoa", ["random", "--automata", "--props", "4", "--states", "12", "--count", "2000", "--seed", "5"])
    kept("answer.json", ["translate", "--format", "json", "G(a -> F b)"])
    kept("rooms.json", ["generate", "map", "--kind", "rooms", "--width", "200", "--height", "200", "--landmarks", "12",
                        "--noise", "0.2", "--tasks", "--seed", "5"])
    programs.prepare(["generate", "corpus", "--out", "little", "--paragraphs", "6", "--seed", "1"], folder)
    programs.prepare(["generate", "corpus", "--out", "much", "--paragraphs", "200", "--seed", "1"], folder)
    lines = (folder / "much/instructions.jsonl").read_text().splitlines()
    copies = []
    for copy in range(20):
        for line in lines:
            paragraph = json.loads(line)
            paragraph["id"] += f"-{copy}"
            copies.append(json.dumps(paragraph))
    (folder / "much/instructions.jsonl").write_text("\n".join(copies) + "\n")
    pairs = (folder / "little/pairs.tsv").read_text().splitlines()
    (folder / "texts").write_text("".join(line.split("\t")[0] + "\n" for line in pairs) * 200)
    letters = random_numbers.Random(5)
    (folder / "letters").write_text("".join(letters.choice(["{a}", "{b}", "{a, b}", "{}", "{c}"]) + "\n"
                                            for _ in range(200_000)))
    (folder / "commands.jsonl").write_text(json.dumps(
        {"id": "0", "domain": "yard", "text": "go to the gate", "formula": "F gate", "propositions": ["gate"]}) + "\n")
    (folder / "domains.json").write_text(json.dumps({"yard": {"propositions": {"gate": "", "red_shed": ""}}}))


def jobs(folder, programs):
    """All of them; those of programs that were not built are left out."""
    little, much, texts = folder / "little", folder / "much", folder / "texts"
    rooms, on_map = folder / "rooms.json", [HARD_ON_MAP, "--map", "grid", *START]
    found = [
        Job("run", ["run", "-F", texts, "--map", "grid", *START, "--json"]),
        Job("ground", ["ground", "-F", texts, "--map", "grid", *START, "--json"]),
        Job("translate", ["translate", "--to", "dfa", "--max-states", "4000000000", HARD, "--svg", "old.svg"],
            ["old.svg"]),
        Job("translate a batch", ["translate", "-F", folder / "formulas", "--format", "json"]),
        Job("translate --certify", ["translate", "-F", folder / "formulas", "--certify", "--format", "stats"]),
        Job("automaton", ["automaton", folder / "automata.hoa", "--complement"]),
        Job("compose", ["compose", *on_map, "--format", "explicit", "--out", "old"],
            ["old.tra", "old.sta", "old.lab"]),
        Job("plan", ["plan", *on_map, "--svg", "old.svg"], ["old.svg"]),
        Job("plan a lasso", ["plan", *on_map, "--semantics", "infinite"]),
        Job("plan with slips", ["plan", *on_map, "--slip", "0.1,0.1"]),
        Job("plan a case", ["plan", "--case", rooms, "--json", "--strategy", "old.jsonl", "--tolerance", "1e-12"],
            ["old.jsonl"]),
        Job("check", ["check", "G(a -> F b) & G(c -> X X X b)", "--trace", folder / "letters", "--progress"],
            ends=True),
        Job("verify", ["verify", "--words", "100000000", folder / "answer.json"]),
        Job("monitor", ["monitor", HARD]),
        Job("compare-formulas", ["compare-formulas", HARD, HARD + " & F z"]),
        Job("explain", ["explain", "-F", folder / "formulas"]),
        Job("move", ["move", *on_map, "--svg", "old.svg"], ["old.svg"]),
        Job("compare", ["compare", TASK, "--map", "grid", *START, "--svg", "old.svg"], ["old.svg"]),
        Job("train", ["train", "--corpus", little, "--epochs", "1000", "--out", "old.waymark"], ["old.waymark"]),
        Job("train, briefly", ["train", "--corpus", little, "--epochs", "1", "--out", "old.waymark"], ["old.waymark"],
            ends=True),
        Job("train on commands", ["train", "--commands", folder / "commands.jsonl", "--own-commands", "60000",
                                  "--corpus", little, "--epochs", "1", "--out", "old.waymark"], ["old.waymark"]),
        Job("evaluate", ["evaluate", "--corpus", much, "--leave-one-map-out", "--predictions", "old.jsonl"],
            ["old.jsonl"]),
        Job("evaluate, briefly", ["evaluate", "--corpus", little, "--leave-one-map-out", "--epochs", "1",
                                  "--predictions", "old.jsonl"], ["old.jsonl"], ends=True),
        Job("import", ["import", "sail", much, "--out", "old"], ["old/instructions.jsonl"], ["old/maps"], ends=True),
        Job("corpus", ["corpus", much], ends=True),
        Job("draw", ["draw", "product", "--map", "grid", *START, "--formula", HARD_ON_MAP, "--svg", "old.svg",
                     "--png", "old.png"], ["old.svg", "old.png"]),
        Job("generate", ["generate", "map", "--kind", "maze", "--width", "2000", "--height", "2000"], ends=True),
        Job("random", ["random", "--props", "6", "--size", "100..200", "--count", "1000000"])]
    if programs.has("waymark-motion"):
        found.append(Job("move, LTLPlanner", [
            "move", "--workspace", programs.data / "workspaces/office.json", "F(kitchen & F desk) & G !wet", "--start",
            "0.8,5.2,0", "--robot", "car", "--iterations", "10000000", "--svg", "old.svg"], ["old.svg"]))
    if programs.has("waymark-lab"):
        found += [
            Job("tune", ["tune", "--corpus", little, "--grid", "epochs=50,60"]),
            Job("feedback-cost", ["experiment", "feedback-cost", "--svg", "old.svg"], ["old.svg"]),
            Job("compare-systems", ["experiment", "compare-systems", "--corpus", little, "--checkpoints", "kept"],
                folders=["kept"]),
            Job("generate corpus", ["generate", "corpus", "--paragraphs", "300", "--out", "old"],
                ["old/instructions.jsonl", "old/pairs.tsv"], ends=True)]
    if programs.has("waymark-serve"):
        found.append(Job("serve", ["serve", "--port", "0"], codes=(0, 11)))
    return found
