#!/usr/bin/env python3
"""Builds SSI-Bench 1, the folder and the tar file, and compares it with what is frozen (docs/ssi-bench.md).

    build.py [--output build/ssi-bench-1] [--members N] [--second-checker] [--freeze]

--members N takes the first N pairs of each family only. The status is 1 if pairs or counts are not those of
frozen.json and counts.csv, or if a certificate is rejected.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tarfile

import archive

HERE = pathlib.Path(__file__).resolve().parent
COUNTS = ["closed", "open", "branched", "isolated", "overlaps", "boundary"]
SECOND_CHECKER = archive.ROOT / "examples/check_certificate.py"


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content)


def write_pairs(output, generator, members):
    """Names of the pairs, all of them or the first ones of each family; and the digests of whole families."""
    contents = {family: {} for family in archive.FAMILIES}
    for name, document in archive.pairs(generator):
        contents[name.split("/")[0]][name] = archive.text(document)
    names = [name for family in contents.values() for name in list(family)[:members]]
    for name in names:
        write(output / f"pairs/{name}.json", contents[name.split("/")[0]][name])
    return names, {family: archive.digest(text.encode() for text in of_family.values())
                   for family, of_family in contents.items()}


def check(program, certificate, second_checker):
    checkers = [[program, "check"], [sys.executable, SECOND_CHECKER]]
    for checker in checkers if second_checker else checkers[:1]:
        said = subprocess.run([*checker, certificate], capture_output=True, text=True)
        if said.returncode:
            raise SystemExit(f"{certificate}: {said.stdout}{said.stderr}")


def solve(program, output, name, second_checker):
    """Writes truth and, if there is one, certificate of a pair; what the manifest says of it."""
    certificate = output / f"certificates/{name}.json"
    command = [program, "intersect", output / f"pairs/{name}.json", "--tolerance", archive.DRAWN_TO, "--json", "-",
               "--quiet"]
    if name.split("/")[0] in archive.CERTIFIED:
        certificate.parent.mkdir(parents=True, exist_ok=True)
        command += ["--certificate", certificate]
    ended = subprocess.run(command, capture_output=True, text=True)
    result = json.loads(ended.stdout)
    if result["status"] != "complete":
        raise SystemExit(f"{name}: {result['status']}: {result['incomplete']}")
    write(output / f"truth/{name}.candidate.json", archive.text(archive.candidate(result, "SSI-Bench 1, truth")))
    if certificate.exists():
        check(program, certificate, second_checker)
        certified = "accepted"
    else:
        certified = ended.stderr.strip().removeprefix("exsect: ") or "not tried"
    return {"name": name, **{key: result["summary"][key] for key in COUNTS}, "certificate": certified}


def counts(lines):
    return "".join(",".join(row) + "\n" for row in [["pair", *COUNTS], *([line["name"], *(str(line[key]) for key in COUNTS)]
                                                                          for line in lines)])


def members_of(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


def write_tar(output):
    """A tar file in which nothing depends on the clock, the user or the order of the folder; its path."""
    path = output.with_name(output.name + ".tar")
    with tarfile.open(path, "w", format=tarfile.USTAR_FORMAT) as tar:
        for member in members_of(output):
            entry = tarfile.TarInfo(f"{archive.NAME}/{member.relative_to(output)}")
            entry.size = member.stat().st_size
            with open(member, "rb") as content:
                tar.addfile(entry, content)
    return path


def digests(output, tar, pair_digests):
    present = [family for family in archive.FAMILIES if (output / "pairs" / family).exists()]
    return {"pairs": pair_digests,
            "truth": {family: archive.folder_digest(output / "truth" / family) for family in present},
            "certificates": {family: archive.folder_digest(output / "certificates" / family)
                             for family in present if family in archive.CERTIFIED},
            "archive": archive.digest([tar.read_bytes()])}


def differences(frozen, found, lines, whole):
    """What is not as it was frozen. Pairs and counts never change; how the truth is drawn may, with the program."""
    wrong = [f"pairs of the family {family} are not the frozen ones"
             for family, value in frozen["pairs"].items() if found["pairs"][family] != value]
    kept = set((HERE / "counts.csv").read_text().splitlines())
    wrong += [f"counts are not the frozen ones: {line}" for line in counts(lines).splitlines() if line not in kept]
    if whole and len(kept) != len(lines) + 1:
        wrong.append(f"{len(lines)} pairs, frozen are {len(kept) - 1}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=archive.ROOT / "build" / archive.NAME)
    parser.add_argument("--exsect", type=pathlib.Path, default=archive.PROGRAM)
    parser.add_argument("--generator", type=pathlib.Path, default=archive.GENERATOR)
    parser.add_argument("--members", type=int)
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--second-checker", action="store_true", help="examples/check_certificate.py as well; an hour")
    parser.add_argument("--freeze", action="store_true", help="renew the digests of truth and certificates")
    arguments = parser.parse_args()
    output = arguments.output
    shutil.rmtree(output, ignore_errors=True)
    names, pair_digests = write_pairs(output, arguments.generator, arguments.members)
    lines = archive.in_parallel(lambda name: solve(arguments.exsect, output, name, arguments.second_checker), names,
                                arguments.jobs)
    write(output / "manifest.json", json.dumps({"name": archive.NAME, "drawn_to": archive.DRAWN_TO, "pairs": lines},
                                               indent=1) + "\n")
    write(output / "README.md", (HERE / "archive.md").read_text())
    write(output / "LICENSE", (archive.ROOT / "LICENSE").read_text())
    tar = write_tar(output)
    found = digests(output, tar, pair_digests)
    frozen = json.loads((HERE / "frozen.json").read_text())
    wrong = differences(frozen, found, lines, not arguments.members)
    if arguments.freeze and not arguments.members and not wrong:
        write(HERE / "frozen.json", json.dumps(found, indent=1) + "\n")
        frozen = found
    same = "the frozen bytes" if found["archive"] == frozen["archive"] else "not the frozen bytes"
    print(f"{len(names)} pairs, {sum(line['certificate'] == 'accepted' for line in lines)} certificates, all accepted")
    print(f"{tar}: sha256 {found['archive']}" + ("" if arguments.members else f", {same}"))
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
