"""What is installed beside the program: manual page, completion for bash, examples."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SHARE = Path(os.environ["EXSECT_PREFIX"]) / "share"
PROGRAM = Path(os.environ["EXSECT_PREFIX"]) / "bin/exsect"
COMPLETION = SHARE / "bash-completion/completions/exsect"
COMMANDS = "intersect line ray self compare verify implicitize revolve batch batch-merge check".split()


def help_of(*words):
    return subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, check=True).stdout


def options_of(command):
    return set(re.findall(r"^ +(?:-\w,)?(--[a-z0-9-]+)", help_of(command), re.M)) - {"--help"} | {"--help"}


def page():
    ended = subprocess.run(
        ["groff", "-man", "-Tascii", "-ww", "-P-c", "-P-b", "-P-u", "-rLL=200n", SHARE / "man/man1/exsect.1"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert not ended.stderr
    return ended.stdout


def completed(*words, cwd=None):
    line = f'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _exsect; printf "%s\\n" "${{COMPREPLY[@]}}"'
    ended = subprocess.run(["bash", "-c", line, COMPLETION, *words], cwd=cwd, capture_output=True, text=True, check=True)
    assert not ended.stderr
    return set(ended.stdout.split("\n")) - {""}


@pytest.mark.skipif(not shutil.which("groff"), reason="it needs groff")
def test_the_manual_page_holds_every_command_and_option():
    shown = page()
    for command in COMMANDS:
        assert re.search(rf"^ +{command}\n +exsect {command} ", shown, re.M), command
        part = shown[re.search(rf"^ +{command}\n +exsect {command} ", shown, re.M).start() :]
        for option in options_of(command):
            assert re.search(rf"{option}\b", part), (command, option)
    assert "EXIT STATUS" in shown
    assert "3 incomplete, the result says where and why" in shown


def test_the_version_is_the_program_s():
    version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    assert f'"{version}"' in (SHARE / "man/man1/exsect.1").read_text().replace("\\-", "-").splitlines()[0]


def test_commands_and_options_are_completed():
    assert completed("exsect", "") == {*COMMANDS, "help", "--help", "--version"}
    assert completed("exsect", "inter") == {"intersect"}
    assert completed("exsect", "help", "ba") == {"batch", "batch-merge"}
    for command in COMMANDS:
        assert completed("exsect", command, "--") == options_of(command), command
    assert completed("exsect", "line", "a.json", "--u", "") == set()


def test_files_are_completed_with_blanks_in_their_names(tmp_path):
    for name in ("model one.json", "model.json", "other"):
        (tmp_path / name).touch()
    for words in (("intersect", "mo"), ("intersect", "a", "--json", "mo")):
        assert completed("exsect", *words, cwd=tmp_path) == {"model one.json", "model.json"}


def test_the_examples_are_there():
    installed = SHARE / "doc/exsect/examples"
    expected = {p.relative_to(ROOT / "examples") for p in (ROOT / "examples").rglob("*") if "__pycache__" not in p.parts}
    assert {p.relative_to(installed) for p in installed.rglob("*")} == expected
    ended = subprocess.run([PROGRAM, "intersect", installed / "chapter9-first.json", "--quiet"])
    assert ended.returncode == 0
