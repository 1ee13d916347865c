"""exsect batch and batch-merge as processes: order, shards, interruption, and every way a run can go wrong."""

import contextlib
import itertools
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import time
from fractions import Fraction
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["EXSECT_PROGRAM"]


def patch(name, function, rng, noise=4):
    """Bidegree (2,2) near function(u,v), control points multiples of 1/16."""
    points = [[[f"{Fraction(c) + Fraction(rng.randint(-noise, noise), 16)}" for c in function(Fraction(i, 2), Fraction(j, 2))] for j in range(3)] for i in range(3)]
    return {"name": name, "degree": [2, 2], "points": points}


def crossing(k, rng):
    """Two patches near (3k, 0, 0) that cross or nearly so."""
    flat = patch(f"flat{k}", lambda u, v: (3 * k + 2 * u, 2 * v, 0), rng)
    upright = patch(f"upright{k}", lambda u, v: (3 * k + 1, 2 * u, 2 * v - 1), rng)
    return [flat, upright]


def write_model(path, patches):
    header = {"exsect": "model/1", "title": "test"}
    path.write_text("".join(json.dumps(value) + "\n" for value in [header, *patches]))
    return path


def write_pair(path, pair):
    path.write_text(json.dumps({"exsect": "patches/1", "patches": pair}))
    return path


def crossings(seed, count):
    rng = random.Random(seed)
    return [crossing(k, rng) for k in range(count)]


PAIRS = crossings(seed=20260, count=24)
SLOWLY = ["--exact", "--tolerance", "1e-10"]  # long enough to be interrupted


def crc64(text):
    """CRC-64/XZ, bit by bit."""
    crc = 2**64 - 1
    for byte in text:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xC96C5795D7870F42 if crc & 1 else 0)
    return crc ^ 2**64 - 1


def journal_line(line):
    """A line of a result as it stands in the journal."""
    return b"%s\t%016x\n" % (line.rstrip(b"\n"), crc64(line.rstrip(b"\n")))


def model_of(path, pairs):
    return write_model(path, [p for pair in pairs for p in pair])


@pytest.fixture
def pairs():
    return PAIRS


@pytest.fixture
def model(tmp_path):
    return model_of(tmp_path / "model.ndjson", PAIRS)


@pytest.fixture(scope="session")
def whole(tmp_path_factory):
    """What one run writes."""
    return batch(model_of(tmp_path_factory.mktemp("whole") / "model.ndjson", PAIRS))


@pytest.fixture(scope="session")
def whole_exact(tmp_path_factory):
    return batch(model_of(tmp_path_factory.mktemp("whole") / "model.ndjson", PAIRS), *SLOWLY)


def run(*arguments, status=0, program=PROGRAM, **options):
    ended = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, **options)
    assert ended.returncode == status, (ended.returncode, ended.stderr, ended.stdout[-500:])
    if status == 2:
        assert ended.stdout == "" and ended.stderr.startswith("exsect: ") and ended.stderr.count("\n") == 1
    return ended


def lines(path_or_text):
    text = path_or_text.read_text() if isinstance(path_or_text, Path) else path_or_text
    assert text.endswith("\n")
    return [json.loads(line) for line in text.splitlines()]


def batch(path, *arguments, status=0, **options):
    """The bytes of the finished file."""
    output = path.parent / "out.ndjson"
    output.unlink(missing_ok=True)
    run("batch", path, "--output", output, *arguments, status=status, **options)
    assert not (path.parent / "out.ndjson.partial").exists()
    return output.read_bytes()


def start(*arguments, **options):
    return subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def wait_for_lines(process, journal, count):
    """Until the journal of a running batch holds at least so many lines."""
    limit = time.monotonic() + 30
    while not journal.exists() or journal.read_bytes().count(b"\n") < count:
        assert process.poll() is None, process.stderr.read()
        assert time.monotonic() < limit
        time.sleep(0.005)


def workers(process):
    return [int(p) for p in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]


def processor_ticks(process):
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return int(fields[11])


def slow(path, output, *arguments):
    return ["batch", path, *SLOWLY, "--jobs", "2", "--output", output, *arguments]


# What the lines say


def test_lines_of_a_model_are_the_results_of_its_pairs(model, pairs, tmp_path):
    header, *rows = lines(run("batch", model, "--jobs", 2).stdout)
    assert header["exsect"] == "batch/1" and header["model"]["patches"] == 48
    assert [row["line"] for row in rows] == list(range(header["lines"]))
    assert header["model"]["apart"] + len(rows) == 48 * 47 // 2
    for row, pair in list(zip(rows, pairs))[:8]:
        single = json.loads(run("intersect", write_pair(tmp_path / "pair.json", pair), "--json", "-").stdout)
        assert {key: row[key] for key in ("first", "second", "status", "summary", "incomplete")} == {key: single[key] for key in ("first", "second", "status", "summary", "incomplete")}
        assert row["by"] == ("doubles" if "filtered" in single["work"]["steps"] else "exact")


def test_full_lines_hold_whole_results(tmp_path):
    first = ROOT / "examples/chapter9-first.json"
    row = lines(run("batch", first, "--full").stdout)[1]
    single = json.loads(run("intersect", first, "--json", "-").stdout)
    del single["work"]
    assert row["result"] == single


def test_a_list_has_a_line_for_each_file(tmp_path, pairs):
    (tmp_path / "sub").mkdir()
    names = [write_pair(tmp_path / "sub" / f"{k}.json", pair).name for k, pair in enumerate(pairs[:5])]
    far = [pairs[0][0], pairs[15][1]]
    names.insert(2, write_pair(tmp_path / "sub" / "far.json", far).name)
    names.append(names[0])
    listed = tmp_path / "sub" / "list.txt"
    listed.write_text("\r\n".join(names) + "\n\n")
    rows = lines(run("batch", listed).stdout)[1:]
    assert [Path(row["file"]).name for row in rows] == names
    assert rows[2]["by"] == "boxes" and rows[2]["summary"]["components"] == 0
    assert {**rows[0], "line": 6} == rows[6]
    assert rows == lines(run("batch", *(tmp_path / "sub" / name for name in names)).stdout)[1:]


def test_self_intersections_stand_before_the_pairs_of_a_patch(tmp_path):
    second = ROOT / "examples/chapter9-second.json"
    rows = lines(run("batch", second, "--self", "--jobs", "1").stdout)[1:]
    assert [row.get("patch", (row.get("first"), row.get("second"))) for row in rows] == ["x", ("x", "y"), "y"]
    single = json.loads(run("self", second, "--patch", "y", "--json", "-").stdout)
    assert rows[2]["summary"] == single["summary"]
    in_a_list = lines(run("batch", second, second, "--self").stdout)[1:]
    assert [{k: v for k, v in row.items() if k not in ("file", "line")} for row in in_a_list[3:]] == [{k: v for k, v in row.items() if k != "line"} for row in rows]


def test_exact_boxes_decide_which_pairs_are_there(tmp_path):
    def square(name, x, y):
        corners = [[[x, y, 0], [x, y + 1, 0]], [[x + 1, y, 0], [x + 1, y + 1, 0]]]
        return {"name": name, "degree": [1, 1], "points": [[[str(c) for c in p] for p in row] for row in corners]}

    third, tiny = Fraction(1, 3), Fraction(1, 10**30)
    shifts = [(0, 0), (third, 2 - third), (1 + third, 1 - third), (1 + third + tiny, 1 - third), (1 + 2 * third, 0), (2 + third, 2 - third)]
    squares = [square(f"s{k}", *shift) for k, shift in enumerate(shifts)]
    # Closed unit squares meet if their corners differ by at most 1 in both coordinates.
    expected = [[f"s{i}", f"s{j}"] for (i, a), (j, b) in itertools.combinations(enumerate(shifts), 2) if all(abs(p - q) <= 1 for p, q in zip(a, b))]
    rows = lines(run("batch", write_model(tmp_path / "squares.ndjson", squares)).stdout)
    assert [[row["first"], row["second"]] for row in rows[1:]] == expected
    assert ["s1", "s2"] in expected and ["s1", "s3"] not in expected
    assert rows[0]["model"]["apart"] == 15 - len(expected)


# Order


def test_lines_do_not_depend_on_workers_shards_locale_or_time_zone(model, whole):
    assert batch(model, "--jobs", "1") == whole
    whole = batch(model, "--jobs", "1")
    assert batch(model, "--jobs", "3") == whole
    assert run("batch", model).stdout.encode() == whole
    assert batch(model, env={**os.environ, "LC_ALL": "de_DE.UTF-8", "LANG": "tr_TR.UTF-8", "TZ": "Asia/Kathmandu"}) == whole


@pytest.mark.parametrize("count", [1, 2, 5])
def test_merged_shards_are_the_one_run(tmp_path, count):
    many = model_of(tmp_path / "many.ndjson", crossings(seed=7, count=300))
    whole = batch(many)
    shards = [tmp_path / f"shard{i}" for i in range(1, count + 1)]
    for i, shard in enumerate(shards, 1):
        run("batch", many, "--shard", f"{i}/{count}", "-o", shard)
    assert max(len(lines(shard)) for shard in shards) < 2 * len(whole.splitlines()) / count
    assert run("batch-merge", *reversed(shards)).stdout.encode() == whole
    run("batch-merge", *shards, "-o", tmp_path / "merged")
    assert (tmp_path / "merged").read_bytes() == whole


def test_merging_refuses_missing_repeated_and_foreign_shards(model, whole, tmp_path):
    one, two, other = tmp_path / "1", tmp_path / "2", tmp_path / "3"
    run("batch", model, "--shard", "1/2", "-o", one)
    run("batch", model, "--shard", "2/2", "-o", two)
    run("batch", model, "--shard", "2/2", "--tolerance", "1e-3", "-o", other)
    assert "shard 2 of 2 is missing" in run("batch-merge", one, status=2).stderr
    assert "same shard" in run("batch-merge", one, one, status=2).stderr
    assert "another batch" in run("batch-merge", one, other, status=2).stderr
    text = one.read_bytes()
    one.write_bytes(text[: text.rindex(b"\n", 0, -1) + 1])
    assert "not finished" in run("batch-merge", one, two, status=2).stderr
    merged = tmp_path / "merged"
    assert "not finished" in run("batch-merge", one, two, "-o", merged, status=2).stderr
    one.write_bytes(text + text.splitlines(True)[-1])
    assert "follows the end" in run("batch-merge", one, two, status=2).stderr
    assert "follows the end" in run("batch-merge", one, two, "-o", merged, status=2).stderr
    one.write_bytes(text)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["1", "2", "3", "model.ndjson"]
    run("batch-merge", one, two, "-o", merged)  # the refused ones left nothing in its way
    assert merged.read_bytes() == whole
    assert sorted(p.name for p in tmp_path.iterdir()) == ["1", "2", "3", "merged", "model.ndjson"]


@pytest.mark.parametrize(
    "part, broken",
    [
        (b'"shard":[1,2]', b'"shard":[1,18446744073709551615]'),
        (b'"shard":[1,2]', b'"shard":[1,1e300]'),
        (b'"shard":[1,2]', b'"shard":[-1,2]'),
        (b'"lines":24', b'"lines":1000000000000000000'),
        (b'"lines":24', b'"lines":24.5'),
        (b'"line":0', b'"line":1e300'),
        (b'"line":0', b'"line":-1'),
        (b'"line":0', b'"line":0.5'),
        (b'"status":"complete"', b'"status":"solved"'),
    ],
)
def test_numbers_in_a_shard_are_not_trusted(model, tmp_path, part, broken):
    one, two = tmp_path / "1", tmp_path / "2"
    run("batch", model, "--shard", "1/2", "-o", one)
    run("batch", model, "--shard", "2/2", "-o", two)
    assert part in one.read_bytes()
    one.write_bytes(one.read_bytes().replace(part, broken, 1))
    refusal = run("batch-merge", one, two, status=2, timeout=20).stderr
    assert refusal.startswith(f"exsect: {one}: line ")


def test_a_header_of_very_many_keys_is_refused_at_once(model, tmp_path):
    one = tmp_path / "1"
    run("batch", model, "-o", one)
    keys = b",".join(b'"key%d":0' % i for i in range(80000))
    one.write_bytes(one.read_bytes().replace(b'"lines":24', b'"lines":24,' + keys, 1))
    assert "not of the form batch/1" in run("batch-merge", one, status=2, timeout=20).stderr


# Interruption


def test_a_torn_journal_is_continued(model, whole, tmp_path):
    output, journal = tmp_path / "out.ndjson", tmp_path / "out.ndjson.partial"
    for seed in range(6):
        rng = random.Random(seed)
        header, *rows = whole.splitlines(True)
        rng.shuffle(rows)
        text = b"".join([header, *map(journal_line, rows)])
        output.unlink(missing_ok=True)
        journal.write_bytes(text[: rng.choice([0, 5, len(header), rng.randrange(len(text)), len(text) - 1, len(text)])])
        run("batch", model, "--output", output, "--resume")
        assert output.read_bytes() == whole and not journal.exists(), seed


def test_resume_begins_goes_on_and_knows_the_end(model, tmp_path):
    output = tmp_path / "out.ndjson"
    table = run("batch", model, "--output", output, "--resume").stdout
    assert "24 solved" in table
    stamp = output.stat().st_mtime_ns
    counted_again = run("batch", model, "--output", output, "--resume").stdout
    assert counted_again.splitlines() == [row for row in table.splitlines() if " solved in " not in row]
    assert "24 " in counted_again and "by boxes 0, in doubles 24" in counted_again
    assert output.stat().st_mtime_ns == stamp
    assert "another batch" in run("batch", model, "--output", output, "--resume", "--exact", status=2).stderr
    output.write_bytes(output.read_bytes()[:-10])
    assert run("batch", model, "--output", output, "--resume", status=2).stderr


def test_a_journal_is_not_overwritten(model, whole, tmp_path):
    journal = tmp_path / "out.ndjson.partial"
    journal.write_bytes(whole)
    assert "--resume" in run("batch", model, "-o", tmp_path / "out.ndjson", status=2).stderr
    assert journal.read_bytes() == whole
    rows = whole.splitlines(True)
    for broken in (b"{}\n", rows[1], rows[1].replace(b'"line":0', b'"line":24'), b"\xff\n"):
        journal.write_bytes(b"".join([rows[0], journal_line(rows[1]), journal_line(broken)]))
        assert "line 3" in run("batch", model, "-o", tmp_path / "new.ndjson", "--resume", status=2).stderr if journal.rename(tmp_path / "new.ndjson.partial") else True


def test_a_damaged_journal_is_not_believed(model, whole, tmp_path):
    assert crc64(b"123456789") == 0x995DC9BBDF1939FA  # the check value of the catalogue
    output, journal = tmp_path / "new.ndjson", tmp_path / "new.ndjson.partial"
    header, *rows = whole.splitlines(True)
    good = [journal_line(row) for row in rows[:3]]
    assert b'"closed":0' in good[1]
    for damaged in (good[1].replace(b'"closed":0', b'"closed":1'), rows[1], good[1][:-2] + b"\n", b"\0" * 80 + b"\n"):
        journal.write_bytes(b"".join([header, good[0], damaged, good[2]]))
        assert "line 3" in (refusal := run("batch", model, "-o", output, "--resume", status=2).stderr) and "checksum" in refusal
    journal.write_bytes(b"".join([header, good[0], good[2]]))
    run("batch", model, "-o", output, "--resume")
    assert output.read_bytes() == whole


def test_a_link_in_the_place_of_the_journal_is_not_followed(model, whole, tmp_path):
    output, journal, victim = tmp_path / "new.ndjson", tmp_path / "new.ndjson.partial", tmp_path / "victim"
    for content in (b"", whole):
        victim.write_bytes(content)
        journal.symlink_to(victim)
        for resume in ([], ["--resume"]):
            assert "symbolic link" in run("batch", model, "-o", output, *resume, status=2).stderr
        assert victim.read_bytes() == content and not output.exists()
        journal.unlink()
    os.mkfifo(journal)
    assert "no regular file" in run("batch", model, "-o", output, status=2, timeout=20).stderr


@pytest.mark.parametrize("ending", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_an_interrupted_run_loses_nothing(model, whole_exact, tmp_path, ending):
    output, journal = tmp_path / "new.ndjson", tmp_path / "new.ndjson.partial"
    process = start(*slow(model, output))
    wait_for_lines(process, journal, 6)
    started = workers(process)
    process.send_signal(ending)
    _, err = process.communicate(timeout=20)
    if ending == signal.SIGKILL:
        assert process.returncode == -signal.SIGKILL
        assert all(not Path(f"/proc/{worker}/exe").exists() or time.sleep(0.2) is None for worker in started)
    else:
        assert process.returncode == 128 + ending
        assert "--resume" in err and err.count("\n") == 1
        assert journal.read_bytes().endswith(b"\n")
    assert not output.exists()
    kept = journal.read_bytes()
    assert 6 <= kept.count(b"\n") < 25
    table = run(*slow(model, output, "--resume")).stdout
    assert f"{25 - kept.count(bytes([10]))} solved" in table
    assert output.read_bytes() == whole_exact


def test_a_killed_worker_costs_nothing(model, whole_exact, tmp_path):
    process = start(*slow(model, tmp_path / "new.ndjson"))
    for count in (3, 8, 15):
        wait_for_lines(process, tmp_path / "new.ndjson.partial", count)
        os.kill(workers(process)[0], signal.SIGKILL)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    assert (tmp_path / "new.ndjson").read_bytes() == whole_exact


def test_a_pair_whose_worker_is_killed_again_is_lost_alone(model, tmp_path):
    process = start("batch", model, *SLOWLY, "--jobs", "1", "-o", tmp_path / "new.ndjson", "--quiet")
    journal = tmp_path / "new.ndjson.partial"
    wait_for_lines(process, journal, 3)
    while b"failed" not in journal.read_bytes():  # a worker, and the one that gets its pair again
        assert process.poll() is None, process.stderr.read()
        for worker in workers(process):
            with contextlib.suppress(ProcessLookupError, FileNotFoundError):
                if processor_ticks(worker) > 0:  # it is at a pair
                    os.kill(worker, signal.SIGKILL)
    process.communicate(timeout=60)
    assert process.returncode == 3
    rows = lines(tmp_path / "new.ndjson")[1:]
    failed = [row for row in rows if row["status"] == "failed"]
    assert len(rows) == 24 and 1 <= len(failed) <= 2
    assert "lost its worker twice" in failed[0]["error"] and "signal 9" in failed[0]["error"]


# Limits


def test_a_pair_out_of_memory_is_lost_alone(tmp_path, pairs):
    files = [write_pair(tmp_path / f"{k}.json", pair) for k, pair in enumerate(pairs[:4])]
    large = json.dumps({"exsect": "patches/1", "title": "x" * 7_000_000, "patches": pairs[4]})
    files.insert(2, tmp_path / "large.json")
    files[2].write_text(large)
    rows = lines(run("batch", *files, "--max-memory", "5", status=3).stdout)[1:]
    assert [row["status"] for row in rows] == ["complete", "complete", "failed", "complete", "complete"]
    assert rows[2]["error"] == "ran out of memory"
    assert lines(run("batch", *files, "--max-memory", "100").stdout)[3]["status"] == "complete"


def test_a_pair_out_of_time_is_incomplete(model):
    rows = lines(run("batch", model, "--max-seconds", "1e-9", status=3).stdout)[1:]
    assert {row["status"] for row in rows} == {"incomplete"}
    assert all(row["incomplete"][0]["why"] for row in rows)


# Bad input and output


def test_a_file_that_cannot_be_read_is_one_failed_line(tmp_path, pairs):
    files = [write_pair(tmp_path / f"{k}.json", pair) for k, pair in enumerate(pairs[:3])]
    bad = tmp_path / "bad.json"
    bad.write_text('{"exsect": "patches/1", "patches": [{"name": "x", "degree": [1,1], "points": [[["1/0"')
    three = write_pair(tmp_path / "three.json", [*pairs[0], pairs[1][0]])
    twice = write_pair(tmp_path / "twice.json", [pairs[0][0], pairs[0][0]])
    huge = write_pair(tmp_path / "huge.json", [{"name": n, "degree": [1, 1], "points": [[["1e400", "0", "0"], ["0", "1", "0"]], [["1", "0", "0"], ["1", "1", n]]]} for n in "12"])
    listed = tmp_path / "list"
    listed.write_text("\n".join(str(f) for f in [files[0], bad, tmp_path, tmp_path / "none.json", three, twice, huge, *files[1:]]))
    rows = lines(run("batch", listed, status=3).stdout)[1:]
    assert [row["status"] for row in rows] == ["complete", *["failed"] * 5, "incomplete", "complete", "complete"]
    for row, reason in zip(rows[1:6], ["not valid JSON", "directory", "No such file", "3 patches", "given to two patches"]):
        assert reason in row["error"] and row["first"] is None


def test_a_coordinate_beyond_doubles_is_refused_with_its_place(tmp_path):
    points = [[["0", "0", "0"], ["0", "1", "0"]], [["1", "0", "0"], ["1", "1e309", "0"]]]
    small = [[["0", "0", "0"], ["0", "1", "0"]], [["1", "0", "0"], ["1", "1", "1"]]]
    path = write_pair(tmp_path / "huge.json", [{"name": "x", "degree": [1, 1], "points": small}, {"name": "y", "degree": [1, 1], "points": points}])
    for command in (["intersect", path], ["self", path, "--patch", "y"]):
        refusal = subprocess.run([PROGRAM, *map(str, command)], capture_output=True, text=True)
        if refusal.returncode == 2:  # else it is solved
            assert f"{path}: $.patches[1].points[1][1][1]: " in refusal.stderr, refusal.stderr


def test_a_bad_model_is_refused_with_its_line(tmp_path, pairs):
    patches = [p for pair in pairs for p in pair]
    for broken, reason in [
        ([*patches[:5], patches[2]], ":7: $.name: name \"flat1\" given to two patches"),
        ([patches[0], {**patches[1], "degree": [3, 4]}], ":3: $.degree[1]: degree 4 is not supported"),
        ([patches[0], {**patches[1], "extra": 1}], ":3: $: unknown key"),
        ([], "at least one patch"),
    ]:
        assert reason in run("batch", write_model(tmp_path / "bad.ndjson", broken), status=2).stderr
    path = write_model(tmp_path / "bad.ndjson", patches[:3])
    path.write_text(path.read_text()[:-30])
    assert ":4: " in run("batch", path, status=2).stderr
    path.write_text('{"exsect": "model/2"}\n')
    assert "version" in run("batch", path, status=2).stderr
    path.write_text("")
    assert "at least one file" in run("batch", path, status=2).stderr
    assert "No such file" in run("batch", tmp_path / "none", status=2).stderr


def test_options_are_checked(model, tmp_path):
    for options in (["--jobs", "0"], ["--shard", "0/2"], ["--shard", "3/2"], ["--shard", "2"], ["--tolerance", "0"], ["--max-memory", "-1"], ["--resume"], ["-o", model], ["-o", "/dev/null"], ["-o", tmp_path / "none/out"], ["-o", tmp_path]):
        run("batch", model, *options, status=2)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["model.ndjson"]


def test_two_runs_do_not_write_one_output(model, whole_exact, tmp_path):
    output = tmp_path / "new.ndjson"
    process = start(*slow(model, output, "--quiet"))
    wait_for_lines(process, tmp_path / "new.ndjson.partial", 1)
    assert "another run" in run(*slow(model, output, "--resume"), status=2).stderr
    process.communicate(timeout=60)
    assert process.returncode == 0
    assert output.read_bytes() == whole_exact


@pytest.mark.parametrize("signals", [True, False])  # SIGXFSZ as it is in a shell, or ignored as in Python
def test_a_full_disk_loses_nothing_that_was_written(model, whole, tmp_path, signals):
    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))

    output = tmp_path / "new.ndjson"
    full = start("batch", model, "-o", output, restore_signals=signals, preexec_fn=small_files)
    out, err = full.communicate(timeout=60)
    assert full.returncode == 2 and out == "" and "cannot be written: File too large" in err
    assert not output.exists() and (tmp_path / "new.ndjson.partial").stat().st_size == 5000
    assert sorted(p.name for p in tmp_path.iterdir()) == ["model.ndjson", "new.ndjson.partial"]
    run("batch", model, "-o", output, "--resume")
    assert output.read_bytes() == whole
    with open("/dev/full", "w") as device:
        ended = subprocess.run([PROGRAM, "batch", model], stdout=device, stderr=subprocess.PIPE, text=True)
    assert ended.returncode == 2 and "standard output cannot be written" in ended.stderr


def test_no_command_leaves_a_file_where_the_disk_is_full(tmp_path):
    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    example = ROOT / "examples/chapter9-first.json"
    for option in ("--json", "--svg", "--report", "--certificate", "--obj", "--ply", "--vtp", "--csv"):
        written = tmp_path / "written"
        refusal = run("intersect", example, option, written, "--quiet", status=2, preexec_fn=small_files).stderr
        assert "cannot be written: File too large" in refusal, option
        assert not list(tmp_path.iterdir()), option
        written.write_text("old")
        run("intersect", example, option, written, "--quiet", status=2, preexec_fn=small_files)
        assert written.read_text() == "old" and len(list(tmp_path.iterdir())) == 1
        written.unlink()
    with open("/dev/full", "w") as device:
        for arguments in (["intersect", example], ["intersect", example, "--json", "-"], ["line", example, "--u", "1/2"]):
            ended = subprocess.run([PROGRAM, *map(str, arguments)], stdout=device, stderr=subprocess.PIPE, text=True)
            assert ended.returncode == 2 and "standard output cannot be written" in ended.stderr


def test_a_directory_that_is_read_only_is_refused(model, tmp_path, tmp_path_factory):
    locked = tmp_path / "locked"
    locked.mkdir(mode=0o555)
    program, options = PROGRAM, {}
    if os.geteuid() == 0:  # for whom nothing is read-only
        options = {"user": 65534, "group": 65534}
        program = shutil.copy(PROGRAM, tmp_path / "exsect")  # the clone may lie where others cannot enter
        base = tmp_path_factory.getbasetemp()
        for directory in (tmp_path, base, base.parent):
            directory.chmod(directory.stat().st_mode | 0o055)
        if any(not directory.stat().st_mode & 0o001 for directory in base.parents):
            pytest.skip(f"other users cannot enter {base.parent}; TMPDIR chooses another folder")
    assert "Permission denied" in run("batch", model, "-o", locked / "out", status=2, program=program, **options).stderr
