"""check_sbom.py FILE BIN: the bill of materials is an SPDX 2.3 document; what dpkg says now agrees with it; and it
names the package of every shared library that the executables in BIN are linked with."""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

LICENCES = {"MIT", "X11", "BSL-1.0", "MPL-2.0", "BSD-2-Clause", "BSD-3-Clause", "EPL-1.0", "PDDL-1.0",
            "LGPL-2.1-or-later", "LGPL-2.0-or-later", "LGPL-2.1-only OR MPL-1.1", "LicenseRef-WordNet-3.0",
            "GPL-3.0-or-later WITH GCC-exception-3.1"}
EXECUTABLES = ("waymark", "waymark-layout", "waymark-lab", "waymark-motion", "waymark-serve", "waymark-convert",
               "waymark-farm", "waymark-distributed")
faults = []


def demand(condition, what):
    if not condition:
        faults.append(what)


def said(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout


def owner(library):
    real = str(Path(library).resolve())  # what a package for development links to
    for path in (real, real.removeprefix("/usr"), library):
        if match := re.match(r"([a-z0-9+.-]+)", said("dpkg-query", "-S", path)):
            return match[1]
    return library


def main(file, folder):
    bill = json.loads(Path(file).read_text())
    demand(bill["spdxVersion"] == "SPDX-2.3" and bill["dataLicense"] == "CC0-1.0", "version or licence of the document")
    demand(bill["SPDXID"] == "SPDXRef-DOCUMENT" and "#" not in bill["documentNamespace"], "name of the document")
    demand(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", bill["creationInfo"]["created"]), "time of creation")
    demand(bill["creationInfo"]["creators"], "creators")
    packages = {package["SPDXID"]: package for package in bill["packages"]}
    demand(len(packages) == len(bill["packages"]), "two packages have one SPDXID")
    own = {entry["licenseId"] for entry in bill["hasExtractedLicensingInfos"] if entry["extractedText"].strip()}
    for identifier, package in packages.items():
        demand(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", identifier), f"{identifier} is no SPDXID")
        for key in ("name", "versionInfo", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"):
            demand(package.get(key), f"{identifier} has no {key}")
        for part in package["licenseDeclared"].split(" AND "):
            demand(part in LICENCES, f"{package['name']}: licence {part}")
            demand(not part.startswith("LicenseRef-") or part in own, f"{part} has no text")
    related = {relation["relatedSpdxElement"] for relation in bill["relationships"]}
    demand(related == set(packages), f"related, but no package, or the reverse: {related ^ set(packages)}")
    names = {package["name"]: package["versionInfo"] for package in packages.values()}
    demand({"waymark", "GloVe vectors", "WordNet"} <= names.keys(), "a part of waymark is missing")
    if shutil.which("dpkg-query"):
        debian = {package["name"] for package in packages.values() if "externalRefs" in package}
        demand(len(debian) >= 10, f"only {len(debian)} Debian packages")
        for name in sorted(debian):
            versions = said("dpkg-query", "-W", "-f=${Version}\n", name).split()
            demand(names[name] in versions, f"{name} is {versions} and not {names[name]}")
        for name in EXECUTABLES:
            program = Path(folder) / name
            needed = re.findall(r"NEEDED +(\S+)", said("objdump", "-p", str(program))) if program.exists() else []
            places = dict(re.findall(r"(\S+) => (\S+)", said("ldd", str(program)))) if needed else {}
            for library in needed:
                if library in places:
                    package = owner(places[library])
                    demand(package in names, f"{name} is linked with {library} of {package}")
    else:
        print("SKIPPED: versions and linked libraries, for there is no dpkg-query")
    print("\n".join(faults) if faults else f"{len(packages)} packages")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
