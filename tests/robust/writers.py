"""Commands that write files in a moment: on what disks, devices and kills may do to them (kept.py)."""
from dataclasses import dataclass, field

START = ["--map", "grid", "--start", "1,9,0"]


@dataclass
class Writer:
    """A command whose outputs stand in the folder PLACE. `makes` are further files, which are not there before."""
    name: str
    arguments: list
    outputs: list
    makes: list = field(default_factory=list)

    def at(self, place):
        return [str(argument).replace("PLACE", str(place)) for argument in self.arguments]


def make_inputs(programs, folder):
    programs.prepare(["generate", "corpus", "--out", "little", "--paragraphs", "6", "--seed", "1"], folder)
    programs.prepare(["generate", "corpus", "--out", "much", "--paragraphs", "200", "--seed", "1"], folder)
    for name, arguments in (
            ("formulas", ["random", "--props", "5", "--size", "15..25", "--count", "300", "--seed", "5"]),
            ("route.json", ["plan", "F sofa", *START, "--json"]),
            ("yard.json", ["generate", "map", "--kind", "rooms", "--width", "8", "--height", "8", "--landmarks", "3",
                           "--tasks"])):
        (folder / name).write_text(programs.prepare(arguments, folder).out)


def writers(folder, programs):
    little, yard = folder / "little", folder / "yard.json"
    explicit = ["old.tra", "old.sta", "old.lab", "old.srew"]
    found = [
        Writer("translate", ["translate", "--to", "dfa", "F(a & X F b)", "--svg", "PLACE/old.svg"], ["old.svg"]),
        Writer("run", ["run", "walk to the chair", *START, "--svg", "PLACE/old.svg", "--hoa", "PLACE/old.hoa"],
               ["old.svg", "old.hoa"]),
        Writer("plan", ["plan", "F easel", *START, "--svg", "PLACE/old.svg", "--hoa", "PLACE/old.hoa",
                        "--behavior-tree", "PLACE/old.xml"], ["old.svg", "old.hoa", "old.xml"]),
        Writer("plan a case", ["plan", "--case", yard, "--task", "seq", "--strategy", "PLACE/old.jsonl"],
               ["old.jsonl"]),
        Writer("compose explicit", ["compose", "F easel", *START, "--format", "explicit", "--out", "PLACE/old"],
               explicit),
        Writer("compose prism", ["compose", "F easel", *START, "--format", "prism", "--out", "PLACE/old"], ["old.nm"]),
        Writer("compose jani", ["compose", "F easel", *START, "--format", "jani", "--out", "PLACE/old"], ["old.jani"]),
        Writer("check", ["check", "F sofa", "--trajectory", folder / "route.json", "--svg", "PLACE/old.svg"],
               ["old.svg"]),
        Writer("move", ["move", "F chair", *START, "--svg", "PLACE/old.svg"], ["old.svg"]),
        Writer("compare", ["compare", "F easel", *START, "--methods", "search,q-learning", "--seeds", "2", "--steps",
                           "500", "--svg", "PLACE/old.svg"], ["old.svg"]),
        Writer("train", ["train", "--corpus", little, "--epochs", "1", "--out", "PLACE/old.waymark"], ["old.waymark"]),
        Writer("evaluate", ["evaluate", "--corpus", little, "--leave-one-map-out", "--epochs", "1", "--predictions",
                            "PLACE/old.jsonl"], ["old.jsonl"]),
        Writer("import", ["import", "sail", folder / "much", "--out", "PLACE/old"], ["old/instructions.jsonl"])]
    if programs.has("waymark-convert"):
        found.append(Writer("draw", ["draw", "route", *START, "--formula", "F sofa", "--svg", "PLACE/old.svg", "--png",
                                     "PLACE/old.png", "--pdf", "PLACE/old.pdf"], ["old.svg", "old.png", "old.pdf"]))
    if programs.has("waymark-lab"):
        found.append(Writer("feedback-cost", ["experiment", "feedback-cost", "--sentences", "1", "--candidates", "2",
                                              "--svg", "PLACE/old.svg"], ["old.svg"]))
        found.append(Writer("generate corpus", ["generate", "corpus", "--paragraphs", "40", "--out", "PLACE/old"],
                            ["old/instructions.jsonl", "old/pairs.tsv"]))
    return found


def is_whole(writer, name, contents, new):
    """Are these the bytes of a finished file? Some files hold measured times, PDF the time of day."""
    if name.endswith(".pdf"):
        return contents.startswith(b"%PDF") and contents.rstrip().endswith(b"%%EOF")
    if writer.name == "feedback-cost":
        return contents.rstrip().endswith(b"</svg>")
    return contents == new[name]
