# The manual as a site: `./dev site` writes build/site. The pages are the Markdown files of the repository as they
# stand, so the source folder is the root of the repository, and a link works on a repository host and in the site.
import pathlib
import re
import xml.etree.ElementTree as ElementTree

root = pathlib.Path(__file__).resolve().parent.parent

project = "waymark"
author = "the waymark authors"
copyright = "2026 the waymark authors"
release = re.search(r"project\(waymark VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text()).group(1)
extensions = ["myst_parser", "sphinx.ext.graphviz"]
root_doc = "docs/index"
include_patterns = ["*.md", "docs/**.md"]
myst_heading_anchors = 4
graphviz_output_format = "svg"
html_theme = "furo"
html_title = f"waymark {release}"
html_extra_path = ["site/root", "../build/doxygen/site"]  # index.html, and the folder api that Doxygen wrote
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"font-stack": "system-ui, sans-serif"},
    "dark_css_variables": {"font-stack": "system-ui, sans-serif"},
}


def diagram(direction, flowchart):
    """A flowchart of Mermaid as a graph of Graphviz: repository hosts draw the one, this site the other."""
    node = r'(\w+)(?:\["([^"]*)"\])?'
    lines = [f"digraph {{ compound=true; newrank=true; rankdir={direction}; bgcolor=transparent",
             "node [shape=box, style=filled, fillcolor=white, fontname=sans, fontsize=10]; edge [color=gray]"]
    for line in map(str.strip, flowchart.splitlines()):
        nodes = []
        if match := re.fullmatch(r"subgraph (\w+)", line):
            anchor = f'{match[1]} [style=invis, shape=point, label=""]'
            lines.append(f'subgraph cluster_{match[1]} {{ label="{match[1]}"; fontname=sans; color=gray; {anchor}')
        elif line == "end":
            lines.append("}")
        elif match := re.fullmatch(rf'{node} (?:-- "([^"]*)" )?--> {node}', line):
            source, source_label, label, target, target_label = match.groups()
            nodes = [(source, source_label), (target, target_label)]
            between = f", ltail=cluster_{source}, lhead=cluster_{target}" if source.startswith("lib") else ""
            lines.append(f'{source} -> {target} [label="{label or ""}", fontname=sans, fontsize=10{between}]')
        elif match := re.fullmatch(node, line):
            nodes = [match.groups()]
        else:
            raise ValueError(f"docs/conf.py cannot draw the line '{line}' of a flowchart")
        lines += [f'{name} [label="{label}"]' for name, label in nodes if label]
    return "\n".join(["```{graphviz}", *lines, "}", "```"])


def joined_rows(page):
    """Tables in which a row of a long table is one line: in the sources, a row with an empty first cell goes on."""
    out, body = [], False
    for line in page.split("\n"):
        cells = re.split(r"(?<!\\)\|", line)
        if re.fullmatch(r"\|[ :|-]+\|", line) and "---" in line:
            out.append(line)
            body = True
            continue
        above = re.split(r"(?<!\\)\|", out[-1]) if out else []
        if body and len(cells) > 2 and not cells[1].strip() and len(cells) == len(above) and "---" not in out[-1]:
            out[-1] = "|".join(f"{a.rstrip()} {b.strip()} " if b.strip() else a for a, b in zip(above, cells))
        else:
            out.append(line)
            body = body and line.startswith("|")
    return "\n".join(out)


def pages_of_headers():
    """The page of the API of each installed header, by its path."""
    tags = root / "build/doxygen/waymark.tag"
    if not tags.exists():
        return {}
    pages = {}
    for file in ElementTree.parse(tags).getroot().iterfind("compound[@kind='file']"):
        _, _, folder = (file.findtext("path") or "").partition("/headers/")  # of the copies for Doxygen
        pages[folder + file.findtext("name")] = file.findtext("filename")
    return pages


def adapt(app, name, text):
    page = re.sub(r"```mermaid\nflowchart (\w+)\n(.*?)\n```", lambda match: diagram(*match.groups()),
                  joined_rows(text[0]), flags=re.S)
    depth = name.count("/")

    def link(match):
        target = (root / name).parent / match.group(1)
        header = str(target.resolve().relative_to(root))
        if header not in app.header_pages:
            return match.group(0)
        return f"]({app.site_address}{header}#{depth}#{app.header_pages[header]})"

    text[0] = re.sub(r"\]\(([^)#: ]+\.hpp)\)", link, page)


def relative_api_links(app, doctree):
    """An address of the site's own API pages, relative to the page that links there."""
    from docutils import nodes

    for reference in doctree.findall(nodes.reference):
        address = reference.get("refuri", "")
        if address.startswith(app.site_address):
            _, depth, page = address.split("#")
            reference["refuri"] = "../" * int(depth) + "api/" + page


def setup(app):
    app.site_address = "https://waymark.invalid/"
    app.header_pages = pages_of_headers()
    app.connect("source-read", adapt)
    app.connect("doctree-read", relative_api_links)
